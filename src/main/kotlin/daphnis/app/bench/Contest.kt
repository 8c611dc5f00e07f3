package daphnis.app.bench

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EngineFactory
import daphnis.core.population.stateDigest
import daphnis.core.run.RunException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioSetup
import kotlin.math.ceil

/** An engine and the number of its threads. */
internal data class Contestant(val engine: String, val threads: Int)

/**
 * Times [contestants] on the same steps from the same state. They take turns in one process, round after round: where
 * others use the machine too, nothing else is a fair comparison. One round before the first warms up and is not kept.
 *
 * @param name of the scenario in messages and results
 * @param steps of each round; null for the whole scenario
 */
internal class Contest(
    private val engines: EngineFactory,
    private val contestants: List<Contestant>,
    private val scenario: Scenario,
    val name: String,
    private val steps: Long?,
) {
    private val setup = ScenarioSetup.of(scenario, name)
    private val seconds = contestants.associateWith { ArrayList<Double>() }
    private var first: Outcome? = null

    /** What a turn came to, but for its time. */
    private data class Outcome(val engine: String, val digest: String, val steps: Long, val collisions: Long)

    /** Spheres at the start. */
    val spheres: Int get() = setup.population.size

    /** Steps of a round as far as they are known before; null where the scenario adapts its step. */
    private val plannedSteps: Long? = steps ?: (setup.timeStep as? FixedTimeStep)?.let {
        ceil((setup.scenario.end - setup.scenario.startTime) / it.duration - END_SLACK).toLong()
    }

    /** How far a round goes, in words. */
    val span: String get() = when (plannedSteps) {
        null -> "to time ${setup.scenario.end}"
        1L -> "1 step"
        else -> "$plannedSteps steps"
    }

    /** Spheres times steps; null when the steps are not known. */
    val work: Double? get() = plannedSteps?.let { it.toDouble() * spheres }

    /**
     * One round of all.
     *
     * @param isKept false to warm up
     * @param after is told who has had a turn, and the seconds it took
     * @throws RunException when engines end in different states, or a step fails
     */
    fun round(isKept: Boolean, after: (Contestant, Double) -> Unit) {
        for (contestant in contestants) {
            val time = turn(contestant)
            if (isKept) seconds.getValue(contestant) += time
            after(contestant, time)
        }
    }

    private fun turn(contestant: Contestant): Double {
        val own = ScenarioSetup.of(scenario, name, setup.population.copy())
        val engine = engines.create(contestant.engine, contestant.threads)!!
        val forcing = CollisionForcing(own.restitution, own.guard, engine, false, own.scenario.search)
        val start = own.scenario.startTime
        return Simulation(own.population, own.boundary, forcing, own.timeStep, own.forces, startTime = start).use {
            val begin = System.nanoTime()
            try {
                while (!isOver(it, own)) it.advance()
            } catch (e: RuntimeException) {
                throw RunException("$name: ${contestant.engine}: step ${it.step + 1}: ${e.message}", e)
            }
            val time = (System.nanoTime() - begin) * NANO
            compare(Outcome(contestant.engine, stateDigest(it.population), it.step, forcing.counters.collisions))
            time
        }
    }

    private fun isOver(simulation: Simulation, own: ScenarioSetup): Boolean {
        if (steps != null) return simulation.step >= steps
        // The end of a whole number of steps may fall short of it by round-off.
        val slack = (own.timeStep as? FixedTimeStep)?.let { it.duration * END_SLACK } ?: 0.0
        return simulation.time >= own.scenario.end - slack
    }

    private fun compare(outcome: Outcome) {
        val first = first ?: outcome.also { first = it }
        if (outcome.copy(engine = first.engine) == first) return
        throw RunException("$name: ${outcome.engine} and ${first.engine} end in different states")
    }

    /** What was kept; empty before the first such round. */
    fun timings(): List<Timing> {
        val first = first ?: return emptyList()
        return contestants.filter { seconds.getValue(it).isNotEmpty() }.map {
            val times = seconds.getValue(it).toList()
            Timing(name, spheres, it.engine, it.threads, first.steps, first.collisions, times)
        }
    }

    private companion object {
        const val NANO = 1e-9
        const val END_SLACK = 1e-6
    }
}
