package daphnis.core.run

import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputList
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.scenario.InputException
import daphnis.core.scenario.OutputSpec

/**
 * The outputs of a run by name, and what a checkpoint knows of them.
 *
 * @param watcher called after them; nothing of it is kept
 */
internal class RunOutputs(private val byName: Map<String, Output>, watcher: Output) : AutoCloseable {
    private val all = OutputList(byName.values + watcher)

    fun open(simulation: Simulation, opening: Opening): Unit = all.open(simulation, opening)

    fun write(simulation: Simulation): Unit = all.write(simulation)

    fun finish(simulation: Simulation): Unit = all.finish(simulation)

    /** The states of the outputs that keep something, by name. */
    fun save(): Map<String, OutputState> = byName.mapValues { (name, output) ->
        OutputState(name).also { output.save(it) }
    }.filterValues { it.names.isNotEmpty() }

    override fun close(): Unit = all.close()

    companion object {
        private const val SERIES = "series"
        const val TRANSPORT = "transport"
        private const val SNAPSHOTS = "snapshots"
        private const val COLLISIONS = "collisions"

        private const val LONGEST_NAME = 200

        /** Names that no other output may have. */
        val RESERVED: Set<String> = setOf(SERIES, TRANSPORT, SNAPSHOTS, COLLISIONS)

        /** @throws IllegalArgumentException when one of [names] is taken, empty or too long */
        fun requireFree(names: Set<String>) {
            for (name in names) {
                require(name.isNotBlank()) { "an output has no name; the checkpoint knows it by one" }
                require(name.length <= LONGEST_NAME) {
                    "an output has a name of ${name.length} characters; it can have $LONGEST_NAME"
                }
                require(name !in RESERVED) { "an output is called '$name'; ${RESERVED.joinToString()} are taken" }
            }
        }

        /** The outputs that [spec] asks for, in the order in which they are called. */
        fun of(spec: OutputSpec, sums: StepSums, files: RunFiles, directory: RunDirectory): Map<String, Output> {
            val outputs = LinkedHashMap<String, Output>()
            outputs[SERIES] = Series(spec.seriesEvery, sums, files)
            if (spec.transportEvery > 0) outputs[TRANSPORT] = Transport(spec.transportEvery, sums, files)
            outputs[SNAPSHOTS] = Snapshots(spec.snapshotEvery, directory)
            if (spec.collisionLog) outputs[COLLISIONS] = CollisionLog(files)
            return outputs
        }
    }
}

/**
 * Gives each of [outputs] the state that it [saved].
 *
 * @throws InputException when one cannot take it over; [source] is what to call the checkpoint
 */
internal fun restore(outputs: Map<String, Output>, saved: Map<String, OutputState>, source: String) {
    for ((name, state) in saved) {
        try {
            outputs[name]?.restore(state)
        } catch (e: RuntimeException) {
            throw InputException(source, null, "output '$name' cannot continue from what it saved: ${e.message}")
        }
    }
}
