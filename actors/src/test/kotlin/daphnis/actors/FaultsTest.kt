package daphnis.actors

import daphnis.actors.FaultKit.assertWorksOn
import daphnis.actors.FaultKit.expected
import daphnis.actors.FaultKit.initial
import daphnis.actors.FaultKit.simulation
import daphnis.actors.region.Phase
import daphnis.actors.region.RegionCommand
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Open
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.step.CollapseException
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CancellationException
import java.util.concurrent.atomic.AtomicInteger

/** Regions that throw or dawdle: no hang, no half-advanced state. The time limit is the watchdog. */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
abstract class FaultsContract(shares: Boolean) : BothWays(shares) {
    private val errors = listOf(
        AssertionError("on purpose"),
        StackOverflowError("on purpose"),
        OutOfMemoryError("on purpose"),
        NoClassDefFoundError("on purpose"),
        ExceptionInInitializerError("on purpose"),
        @Suppress("DEPRECATION")
        ThreadDeath(),
    )
    private val exceptions =
        listOf(
            IllegalStateException("on purpose"),
            InterruptedException("on purpose"),
            CancellationException("on purpose"),
        )

    @Test
    fun `an exception in a region, in any phase, is put before the serial engine, which finds nothing wrong`() {
        for (phase in phases) {
            for (exception in exceptions) {
                val failures = AtomicInteger()
                val probe = { command: RegionCommand ->
                    if (command.phase == phase && failures.getAndIncrement() < 2) throwAny(exception)
                }
                for (engine in engines(probe)) {
                    failures.set(0)
                    simulation(engine).use { simulation ->
                        assertWorksOn(simulation) { "${engine.name}, $phase, $exception" }
                        assertTrue(failures.get() > 1) { "${engine.name}: no $phase came by" }
                        assertTrue(simulation.collisions!!.counters.causalityReplays in 1..2) {
                            "${engine.name}, $phase, $exception"
                        }
                    }
                }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `an error in a region, in any phase, is thrown at once, the population is as before, the engine works on`() {
        for (phase in phases) {
            for (error in errors) {
                var armed = false
                for (engine in engines { if (armed && it.phase == phase && it.region <= 3) throwAny(error) }) {
                    simulation(engine).use { simulation ->
                        simulation.advance()
                        armed = true
                        // A step may come without this phase, such as that which looks ahead.
                        while (simulation.step < expected.size) {
                            val before = simulation.step
                            val thrown = runCatching { simulation.advance() }.exceptionOrNull() ?: continue
                            assertSame(error, thrown) { "${engine.name}, $phase" }
                            assertEquals(before, simulation.step)
                            break
                        }
                        assertTrue(simulation.step < expected.size) { "${engine.name}: no $phase came by" }
                        val digest = expected[simulation.step.toInt() - 1]
                        assertEquals(digest, stateDigest(simulation.population)) { "${engine.name}, $phase, $error" }
                        armed = false
                        assertWorksOn(simulation) { "${engine.name}, $phase, $error" }
                        assertEquals(0, simulation.collisions!!.counters.causalityReplays)
                    }
                }
            }
        }
    }

    @Test
    fun `what a law throws comes out of the step as it is, the population is as before, and the engine works on`() {
        for (thrown in exceptions + errors) {
            for (engine in engines()) {
                var armed = false
                simulation(engine) { if (armed) throwAny(thrown) else 1.0 }.use { simulation ->
                    simulation.advance()
                    armed = true
                    assertSame(thrown, runCatching { simulation.advance() }.exceptionOrNull()) { engine.name }
                    assertEquals(expected[0], stateDigest(simulation.population)) { "${engine.name}, $thrown" }
                    armed = false
                    assertWorksOn(simulation) { "${engine.name}, $thrown" }
                }
            }
        }
    }

    @Test
    fun `a law that fails once, on a path that may be a guess, costs nothing but a replay`() {
        for (engine in engines()) {
            val calls = AtomicInteger()
            val law = { _: Double ->
                if (calls.incrementAndGet() == 30) {
                    throw ArithmeticException("on purpose")
                } else {
                    1.0
                }
            }
            simulation(engine, law).use { simulation ->
                assertWorksOn(simulation) { engine.name }
                assertEquals(1, simulation.collisions!!.counters.causalityReplays)
            }
        }
    }

    @Test
    fun `of several failures an error counts, whichever region was first`() {
        val error = OutOfMemoryError("on purpose")
        for (region in 0..4) {
            val probe = { command: RegionCommand ->
                if (command.phase == phases[0]) throwAny(if (command.region == region) error else exceptions[0])
            }
            for (engine in engines(probe)) {
                simulation(engine).use { assertSame(error, runCatching { it.advance() }.exceptionOrNull()) }
            }
        }
    }

    @Test
    fun `a collapse is the serial engine's to declare`() {
        val n = 10
        val x = DoubleArray(n) { 2.2 * it }
        val vx = DoubleArray(n) { 4.5 - it }
        for (engine in engines()) {
            fun zeros() = DoubleArray(n)
            fun ones() = DoubleArray(n) { 1.0 }
            val p = Population(x.clone(), zeros(), zeros(), vx.clone(), zeros(), zeros(), ones(), ones())
            val before = stateDigest(p)
            Simulation(p, Open, CollisionForcing(ConstantRestitution(0.0), engine = engine), FixedTimeStep(1.0)).use {
                assertThrows(CollapseException::class.java) { it.advance() }
            }
            assertEquals(before, stateDigest(p))
        }
    }

    @Test
    fun `a step that fails in the coordinator's own work leaves an engine that works on`() {
        for (engine in engines()) {
            simulation(engine).use { simulation ->
                val step = FaultKit.step().also { it.duration = 1e9 }
                assertThrows(IllegalArgumentException::class.java) { engine.advance(step) }
                assertEquals(initial, stateDigest(step.population))
                assertWorksOn(simulation) { engine.name }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `a slow region is waited for, longer than the patience with regions that do not begin`() {
        for (engine in engines {
            if (it.region == 2 &&
                it.phase in setOf(Phase.SHARE, Phase.WORK)
            ) {
                Thread.sleep(250)
            }
        }) {
            FaultKit.setPatience(engine, 100_000_000)
            simulation(engine).use { simulation ->
                simulation.advance()
                assertEquals(expected[0], stateDigest(simulation.population))
            }
        }
    }

    @Test
    fun `one step at a time, and none from within another`() {
        for (engine in engines()) {
            var inner: Throwable? = null
            val law = { _: Double ->
                if (inner == null) inner = runCatching { engine.advance(FaultKit.step()) }.exceptionOrNull()
                1.0
            }
            simulation(engine, law).use { simulation ->
                simulation.advance()
                assertEquals("a step is under way", inner?.message)
                assertEquals(expected[0], stateDigest(simulation.population))
            }
        }
    }
}

class FaultsTest : FaultsContract(shares = false)

@Tag("thorough")
class SharedFaultsTest : FaultsContract(shares = true)
