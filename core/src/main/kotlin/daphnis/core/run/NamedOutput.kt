package daphnis.core.run

import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.NodeException
import java.io.IOException
import java.io.UncheckedIOException

/**
 * The output [output] of a run of [simulation], which is called [title] when it throws. Every exception from it comes
 * out as a [RunException] with the step and [title]. Passed on as they are: an [IOException], also from within the
 * [UncheckedIOException] that Java code throws instead; a [FleetException] or [NodeException] of nodes that were asked
 * for the state; and an [Error].
 */
internal class NamedOutput(private val title: String, private val output: Output, private val simulation: Simulation) :
    Output {
    override fun open(simulation: Simulation, opening: Opening): Unit = named { output.open(simulation, opening) }

    override fun write(simulation: Simulation): Unit = named { output.write(simulation) }

    override fun finish(simulation: Simulation): Unit = named { output.finish(simulation) }

    override fun save(state: OutputState): Unit = named { output.save(state) }

    override fun restore(state: OutputState): Unit = named(" cannot continue from what it saved") {
        output.restore(state)
    }

    override fun close(): Unit = named { output.close() }

    private inline fun named(what: String = "", call: () -> Unit) = named("$title$what", simulation.step, call)
}

/** Does [call] of the output [title] after [step]; exceptions come out as [NamedOutput] says. */
internal inline fun named(title: String, step: Long, call: () -> Unit) {
    try {
        call()
    } catch (e: IOException) {
        throw e
    } catch (e: UncheckedIOException) {
        throw e.cause ?: e
    } catch (e: FleetException) {
        throw e
    } catch (e: NodeException) {
        throw e
    } catch (e: Exception) {
        if (e is InterruptedException) Thread.currentThread().interrupt()
        throw RunException("step $step: $title: ${e.message ?: e.javaClass.name}", e)
    }
}
