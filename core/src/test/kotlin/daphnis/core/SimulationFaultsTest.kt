package daphnis.core

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.force.Force
import daphnis.core.force.UniformAcceleration
import daphnis.core.parallel.ExecutorHandler
import daphnis.core.parallel.ThreadHandler
import daphnis.core.parallel.WorkerTask
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.lang.management.ManagementFactory
import java.util.concurrent.Executor
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.atomic.AtomicInteger

/** What is left of a step that fails. The time limit is the watchdog. */
@Timeout(120)
class SimulationFaultsTest : FaultKit() {
    /** So many that the loops of a step are shared out. */
    private val wide = Periodic(Box.centred(49.0, 49.0, 49.0))
    private val large = randomSpheres(9000, wide, 1, 1.0) { 0.4 }

    @Test
    fun `an executor that rejects any one task leaves the population as it was or the step is done`() {
        fun simulation(engine: CollisionEngine) = simulationOf(large.copy(), wide, 0.1, engine = engine)
        val expected = listOf("") + digests(simulation(SerialEngine()), 3)
        val makes = listOf<(Executor) -> CollisionEngine>(
            { IslandsEngine(ExecutorHandler(it, 3), fewest = 0) },
            { ThreadPoolEngine(ExecutorHandler(it, 3)) },
        )
        for (make in makes) {
            val calls = AtomicInteger()
            var nth = 0
            do {
                nth++
                val simulation = simulation(
                    make {
                        if (calls.incrementAndGet() == nth) throw RejectedExecutionException("on purpose")
                        it.run()
                    },
                )
                calls.set(NEVER)
                simulation.advance()
                calls.set(0)
                val order = simulation.population.id.copyOf()
                val done = runCatching { simulation.advance() }.isSuccess
                val story = "${simulation.collisions!!.engine.name}, task $nth"
                assertEquals(expected[if (done) 2 else 1], stateDigest(simulation.population)) { story }
                assertEquals(if (done) 2 else 1, simulation.step)
                if (!done) {
                    assertEquals(order.asList(), simulation.population.id.asList()) { story }
                    simulation.advance()
                }
                val tasks = calls.getAndSet(NEVER)
                simulation.advance()
                assertEquals(expected[3], stateDigest(simulation.population)) { story }
            } while (nth < tasks)
            assertTrue(nth > 10) { "only $nth tasks" }
        }
    }

    @Test
    fun `a store that fails leaves the population of an engine without a simulation as it was`() {
        for (nth in 1..200) {
            val calls = AtomicInteger()
            val handler = object : ThreadHandler {
                override val threads get() = 2

                override fun run(task: WorkerTask) {
                    for (worker in 0 until threads) {
                        if (calls.incrementAndGet() == nth) {
                            throw OutOfMemoryError()
                        } else {
                            task.work(worker)
                        }
                    }
                }

                override fun close() = Unit
            }
            val engine = IslandsEngine(handler, fewest = 0)
            val population = large.copy()
            val step = CollisionStep(population, wide, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
            step.duration = 0.02
            val before = stateDigest(population)
            val order = population.id.copyOf()
            if (runCatching { engine.advance(step) }.isSuccess) {
                assertTrue(nth > 5) { "only $nth tasks" }
                return
            }
            assertEquals(before, stateDigest(population)) { "task $nth" }
            assertEquals(order.asList(), population.id.asList()) { "task $nth" }
            assertEquals(0, step.counters.collisions)
        }
    }

    @Test
    fun `a force that throws before or after the drift takes all kicks back`() {
        for (engine in engines) {
            for (isAfter in listOf(false, true)) {
                var isBroken = false
                val broken = object : Force {
                    override fun beforeDrift(population: Population, start: Double, duration: Double) {
                        check(isAfter || !isBroken) { "on purpose" }
                    }

                    override fun afterDrift(population: Population, end: Double, duration: Double) {
                        check(!isAfter || !isBroken) { "on purpose" }
                    }
                }
                // Behind the first before the drift, behind the third after it.
                val pull = UniformAcceleration(0.0, 0.0, -1.0)
                val push = UniformAcceleration(0.1, 0.0, 0.0)
                val forces = listOf(pull, broken, push)
                val simulation = simulation(engine(), forces = forces)
                val expected = digests(2, simulation.collisions != null, listOf(pull, push))
                simulation.advance()
                assertEquals(expected[1], stateDigest(simulation.population))
                isBroken = true
                repeat(3) {
                    assertRefused("on purpose") { simulation.advance() }
                    assertEquals(expected[1], stateDigest(simulation.population))
                    assertEquals(1, simulation.step)
                    assertEquals(0.3, simulation.time)
                }
                isBroken = false
                simulation.advance()
                assertEquals(expected[2], stateDigest(simulation.population))
                simulation.close()
            }
        }
    }

    @Test
    fun `an output sees each state once, though another throws, also the first`() {
        val seen = List(3) { ArrayList<Long>() }
        var broken = 0
        val outputs = seen.mapIndexed { k, steps ->
            Output {
                if (k == 1 && broken > 0) {
                    broken--
                    error("on purpose")
                }
                steps += it.step
            }
        }
        val simulation = simulation(SerialEngine(), outputs = outputs)
        broken = 2
        assertThrows(IllegalStateException::class.java) { simulation.open() }
        assertThrows(IllegalStateException::class.java) { simulation.advance() }
        assertEquals(0, simulation.step)
        simulation.open()
        broken = 3
        repeat(3) { assertThrows(IllegalStateException::class.java) { simulation.advance() } }
        repeat(2) { simulation.advance() }
        for (steps in seen) assertEquals(listOf(0L, 1L, 2L), steps)
    }

    @Test
    fun `a step within a step is refused, and leaves all as it was`() {
        var isArmed = false
        val output = Output {
            it.open()
            if (isArmed) it.advance()
        }
        val simulation = simulation(SerialEngine(), outputs = listOf(output))
        simulation.advance()
        val before = stateDigest(simulation.population)
        isArmed = true
        assertTrue("within" in assertThrows(IllegalStateException::class.java) { simulation.advance() }.message!!)
        assertEquals(before, stateDigest(simulation.population))
        isArmed = false
        simulation.advance()
        assertEquals(2, simulation.step)
    }

    @Test
    fun `arrays come by turns, and a warm step copies no state`() {
        val simulation = simulation(SerialEngine())
        repeat(20) { simulation.advance() }
        val first = simulation.population.x
        simulation.advance()
        val second = simulation.population.x
        simulation.advance()
        assertSame(first, simulation.population.x)
        simulation.advance()
        assertSame(second, simulation.population.x)
        val bean = ManagementFactory.getThreadMXBean() as com.sun.management.ThreadMXBean
        val before = bean.getThreadAllocatedBytes(Thread.currentThread().id)
        repeat(10) { simulation.advance() }
        val allocated = (bean.getThreadAllocatedBytes(Thread.currentThread().id) - before) / 10
        assertTrue(allocated < 8 * gas.size) { "$allocated bytes per step" }
    }

    private companion object {
        /** Of calls that are not counted. */
        const val NEVER = Int.MIN_VALUE
    }
}
