package daphnis.core.run

import daphnis.core.Output
import daphnis.core.scenario.OutputSpec
import kotlinx.serialization.ExperimentalSerializationApi

/** The list of outputs that runs can have by a key of their [OutputSpec]. */
public object PeriodicOutputs {
    /** All objects of [PeriodicOutput], in the order of their keys in [OutputSpec], in which they are called. */
    @JvmStatic
    @OptIn(ExperimentalSerializationApi::class)
    public val all: List<PeriodicOutput> = PeriodicOutput::class.java.permittedSubclasses
        .map { it.getField("INSTANCE").get(null) as PeriodicOutput }
        .sortedBy { OutputSpec.serializer().descriptor.getElementIndex(it.key) }

    /** Names that no other output of a run may have. */
    internal val names: Set<String> = all.map { it.name }.toSet()

    /** Names of the folders that they fill in a run directory. */
    internal val folders: List<String> = all.mapNotNull { it.folder }

    /** Those that [spec] asks for and that need the record of collisions. */
    internal fun readingCollisions(spec: OutputSpec): List<PeriodicOutput> =
        all.filter { it.readsCollisions && !it.times(spec).isNever }

    /** The outputs that [spec] asks for, by name, in the order in which they are called. */
    internal fun make(spec: OutputSpec, sums: StepSums, files: RunFiles): Map<String, Output> {
        val outputs = LinkedHashMap<String, Output>()
        for (output in all) output.make(output.times(spec), sums, files)?.let { outputs[output.name] = it }
        return outputs
    }
}
