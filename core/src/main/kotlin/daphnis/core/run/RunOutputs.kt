package daphnis.core.run

import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputList
import daphnis.core.OutputState
import daphnis.core.Simulation

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
        private const val LONGEST_NAME = 200

        /** @throws IllegalArgumentException when one of [names] is taken, empty or too long */
        fun requireFree(names: Set<String>) {
            for (name in names) {
                require(name.isNotBlank()) { "an output has no name; the checkpoint knows it by one" }
                require(name.length <= LONGEST_NAME) {
                    "an output has a name of ${name.length} characters; it can have $LONGEST_NAME"
                }
                val taken = PeriodicOutputs.names
                require(name !in taken) { "an output is called '$name'; ${taken.joinToString()} are taken" }
            }
        }
    }
}

/** [outputs] as outputs of a run of [simulation], which say their names when they fail. */
internal fun named(outputs: Map<String, Output>, simulation: Simulation): Map<String, Output> =
    outputs.mapValues { (name, output) -> NamedOutput(titleOf(name), output, simulation) }

/** What messages call the output [name]. */
internal fun titleOf(name: String): String = "output '$name'"

/** Gives each of [outputs] the state that it [saved]. */
internal fun restore(outputs: Map<String, Output>, saved: Map<String, OutputState>) {
    for ((name, state) in saved) outputs[name]?.restore(state)
}
