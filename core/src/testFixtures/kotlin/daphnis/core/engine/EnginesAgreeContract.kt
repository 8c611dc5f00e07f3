package daphnis.core.engine

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.parallel.Execution
import org.junit.jupiter.api.parallel.ExecutionMode

/**
 * The contract: every engine gives the bits of the serial one, after every step, for every number of threads and every
 * division into regions. Each module runs it for its own engines, so that each engine runs once.
 *
 * @param draws how many cases are drawn; null for as many as there is time for: the property `daphnis.draws`
 *   The property `daphnis.firstDraw` says with which they begin.
 */
@Execution(ExecutionMode.SAME_THREAD)
abstract class EnginesAgreeContract(private val tested: TestedEngines, draws: Long? = null) {
    private val draws: Long = draws ?: Draws.of(usual = 150, long = 5000)

    /** Asked for the same, before the others; null where another module has done that. */
    protected open val oracle: BruteForceEngine? get() = null

    private var asked = 0

    @Test
    fun `every engine gives the digest, counts and collisions of the serial one after each step of each case`() {
        var collisions = 0L
        var replays = 0L
        var failures = 0
        asked = 0
        for (seed in Draws.first..<Draws.first + draws) {
            val case = if (seed % 3 == 0L) OddDraw(seed) else Draw(seed)
            val serial = case.simulation(SerialEngine())
            val others = tested.others(case).map { case.simulation(it) }
            try {
                if (!agree(case, serial, others)) failures++
            } finally {
                others.forEach { it.close() }
            }
            collisions += serial.collisions!!.counters.collisions
            replays += others.sumOf { it.collisions!!.counters.causalityReplays }
        }
        println(
            "$draws draws, $collisions collisions per engine, $replays replays, $failures that end by an exception, " +
                "$asked steps with every pair asked",
        )
        assertTrue(collisions > 0) { "no collisions" }
        if (draws < 100) return
        assertTrue(collisions > 100 * draws) { "only $collisions collisions" }
        assertTrue(failures > 0) { "no case fails: the draws do not test what they should" }
        assertTrue(oracle == null || asked > draws / 3) { "$asked steps asked: the draws do not test what they should" }
    }

    /** @return whether the serial engine, and so all, came to the end; else all threw the same */
    private fun agree(case: Case, serial: Simulation, others: List<Simulation>): Boolean {
        val every = oracle?.let { case.simulation(it) }
        var isAsked = every != null
        for (step in 1..STEPS) {
            isAsked = isAsked && BruteForceEngine.isQuick(serial.population, case.boundary, case.dt)
            val expected = failure(serial)
            for (other in others) {
                val engine = other.collisions!!.engine
                val story = "$case, step $step, ${engine.name} on ${engine.threads}"
                assertEquals(expected, failure(other)) { story }
                assertSameStep(serial, other, story)
            }
            if (expected != null) return false
            if (!isAsked) continue
            every!!.advance()
            assertSameStep(serial, every, "$case, step $step, every pair asked")
            asked++
        }
        return true
    }

    @Test
    fun `no sphere, one, and a boundary that removes more of them each step`() {
        val floor = object : BoundaryConditions {
            override val box = Box.UNBOUNDED

            override fun endStep(population: Population, time: Double) =
                population.retain { population.id[it] >= 100 * time }
        }
        for (count in listOf(0, 1, 400)) {
            val serial = end(SerialEngine(), spheres(count), floor)
            for (engine in tested.others(FixedThreads(3))) {
                assertEquals(serial, end(engine, spheres(count), floor)) { "$count spheres, ${engine.name}" }
            }
        }
    }

    @Test
    fun `an engine has the name that it is chosen by, and no other name makes one`() {
        val registry = tested.registry
        for (name in registry.names) registry.create(name, 1)!!.use { assertEquals(name, it.name) }
        assertEquals(null, registry.create("no-such-engine", 1))
        assertEquals(registry.names.distinct(), registry.names)
    }

    private fun spheres(count: Int) = Population(
        DoubleArray(count) { it % 8 * 1.2 },
        DoubleArray(count) { it / 8 % 8 * 1.2 },
        DoubleArray(count) { it / 64 * 1.2 },
        DoubleArray(count) { Math.sin(1.0 * it) },
        DoubleArray(count) { Math.cos(2.0 * it) },
        DoubleArray(count),
        DoubleArray(count) { 0.5 },
        DoubleArray(count) { 1.0 },
    )

    /** The digest after ten steps, and what was left and counted. */
    private fun end(engine: CollisionEngine, start: Population, boundary: BoundaryConditions): List<Any> {
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine)
        return Simulation(start, boundary, forcing, FixedTimeStep(0.5)).use {
            repeat(10) { _ -> it.advance() }
            listOf(stateDigest(it.population), it.population.size, forcing.counters.collisions)
        }
    }

    private companion object {
        const val STEPS = 3
    }
}
