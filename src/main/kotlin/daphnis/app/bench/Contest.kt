package daphnis.app.bench

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
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
 * others use the machine too, nothing else is a fair comparison. Turns before the first round that counts warm up.
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
    private val kept = contestants.associateWith { ArrayList<Turn>() }
    private var first: Outcome? = null

    /** What a turn took, in real time and in that of all processors. */
    class Turn(val seconds: Double, val processorSeconds: Double)

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

    /** The turns of one contestant that do not count. */
    class WarmUp(val first: Turn) {
        var last = first
            private set
        var turns = 1
            private set

        fun add(turn: Turn) {
            last = turn
            turns++
        }
    }

    /**
     * Turns that do not count, one at least for each, until each has worked for so many [seconds], with what prepares a
     * turn: code that Java has not yet compiled tells nothing of an engine.
     *
     * @param after is told who is warm, and its turns
     * @return the seconds of the last turns of all, which a round may take
     * @throws RunException when engines end in different states, or a step fails
     */
    fun warmUp(seconds: Double, after: (Contestant, WarmUp) -> Unit): Double {
        val done = HashMap<Contestant, WarmUp>()
        val worked = HashMap<Contestant, Double>()
        var cold = contestants
        while (cold.isNotEmpty()) {
            cold = cold.filter { contestant ->
                val begin = System.nanoTime()
                val turn = turn(contestant)
                done[contestant]?.add(turn) ?: done.put(contestant, WarmUp(turn))
                val all = worked.merge(contestant, (System.nanoTime() - begin) / NANOS, Double::plus)!!
                (all < seconds).also { if (!it) after(contestant, done.getValue(contestant)) }
            }
        }
        return done.values.sumOf { it.last.seconds }
    }

    /**
     * One round of all, which counts.
     *
     * @param after is told who has had a turn, and what it took
     * @throws RunException when engines end in different states, or a step fails
     */
    fun round(after: (Contestant, Turn) -> Unit) {
        for (contestant in contestants) {
            val turn = turn(contestant)
            kept.getValue(contestant) += turn
            after(contestant, turn)
        }
    }

    private fun turn(contestant: Contestant): Turn {
        val own = ScenarioSetup.of(scenario, name, setup.population.copy())
        val engine = engines.create(contestant.engine, contestant.threads)!!
        val forcing = own.collisions(engine)
        val start = own.scenario.startTime
        val simulation = Simulation(
            own.population,
            own.boundary,
            forcing,
            own.timeStep,
            own.forces,
            startTime = start,
            sources = own.sources,
        )
        return simulation.use {
            val begin = System.nanoTime()
            val processorBegin = ProcessorTime.now()
            try {
                while (!isOver(it, own)) it.advance()
            } catch (e: RuntimeException) {
                throw RunException("$name: ${contestant.engine}: step ${it.step + 1}: ${e.message}", e)
            }
            val seconds = (System.nanoTime() - begin) / NANOS
            val turn = Turn(seconds, ProcessorTime.secondsSince(processorBegin))
            compare(Outcome(contestant.engine, stateDigest(it.population), it.step, forcing.counters.collisions))
            turn
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
        return contestants.filter { kept.getValue(it).isNotEmpty() }.map {
            val turns = kept.getValue(it)
            val seconds = turns.map(Turn::seconds)
            val processor = turns.map(Turn::processorSeconds)
            Timing(name, spheres, it.engine, it.threads, first.steps, first.collisions, seconds, processor, JAVA)
        }
    }

    private companion object {
        const val NANOS = 1e9
        const val END_SLACK = 1e-6

        /** Without what would have to be quoted in a table. */
        val JAVA = System.getProperty("java.version").orEmpty().replace(Regex("[,\"\\s]"), "_")
    }
}
