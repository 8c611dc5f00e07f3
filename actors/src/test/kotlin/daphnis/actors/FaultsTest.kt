package daphnis.actors

import com.typesafe.config.ConfigFactory
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.actors.region.Phase
import daphnis.actors.region.RegionCommand
import daphnis.actors.region.RegionFailedException
import daphnis.actors.region.RegionLayout
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.Restitution
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.CollisionStep
import daphnis.core.population.stateDigest
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CancellationException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicInteger

/** Actors that throw, dawdle, are cancelled, closed, interrupted: no hang, no half-advanced state. The time limit is the watchdog. */
@Timeout(120)
class FaultsTest {
    private val layout = RegionLayout.Stretches(5)

    private fun engines(probe: (RegionCommand) -> Unit): List<CollisionEngine> = listOf(
        RegionActorEngine(2, layout).also { it.probe = probe },
        PekkoEngine(2, layout).also { it.probe = probe },
    )

    private fun simulation(engine: CollisionEngine, restitution: Restitution = ConstantRestitution(1.0)): Simulation {
        val (p, boundary) = gas(400, 4)
        return Simulation(p, boundary, CollisionForcing(restitution, engine = engine), FixedTimeStep(0.2))
    }

    private val expected = simulation(daphnis.core.engine.SerialEngine()).let { s ->
        List(4) {
            s.advance()
            stateDigest(s.population)
        }
    }

    @Test
    fun `a region that throws once costs a second try, in every phase`() {
        for (phase in Phase.entries) {
            val failures = AtomicInteger()
            val probe = { command: RegionCommand -> if (command.phase == phase && command.region == 0 && failures.getAndIncrement() == 0) error("on purpose") }
            for (engine in engines(probe)) {
                failures.set(0)
                simulation(engine).use { simulation ->
                    for (digest in expected) {
                        simulation.advance()
                        assertEquals(digest, stateDigest(simulation.population)) { "${engine.name}, $phase" }
                    }
                }
                assertTrue(failures.get() > 1) { "${engine.name}: no $phase came by" }
            }
        }
    }

    @Test
    fun `a region that keeps throwing ends the step after the second try, and the population is as before`() {
        var broken = false
        for (engine in engines { if (broken && it.region == 3) error("on purpose") }) {
            broken = false
            simulation(engine).use { simulation ->
                simulation.advance()
                broken = true
                val e = assertThrows(RegionFailedException::class.java) { simulation.advance() }
                assertEquals("on purpose", e.cause?.message)
                assertEquals(expected[0], stateDigest(simulation.population))
                assertEquals(1, simulation.step)
                broken = false
                simulation.advance()
                assertEquals(expected[1], stateDigest(simulation.population))
            }
        }
    }

    @Test
    fun `a slow region is waited for`() {
        for (engine in engines { if (it.region == 2) Thread.sleep(3) }) {
            simulation(engine).use { simulation ->
                simulation.advance()
                assertEquals(expected[0], stateDigest(simulation.population))
            }
        }
    }

    @Test
    fun `an interrupted host gets its step, and its interrupt`() {
        for (engine in engines { }) {
            simulation(engine).use { simulation ->
                for (digest in expected) {
                    Thread.currentThread().interrupt()
                    simulation.advance()
                    assertTrue(Thread.interrupted())
                    assertEquals(digest, stateDigest(simulation.population))
                }
            }
        }
    }

    @Test
    fun `a step that is closed from another thread ends, with the population as before`() {
        for (make in 0..1) {
            val inside = CountDownLatch(1)
            val engine = engines {
                if (it.phase == Phase.WORK) {
                    inside.countDown()
                    Thread.sleep(20)
                }
            }[make]
            val simulation = simulation(engine)
            val before = stateDigest(simulation.population)
            val closer = Thread {
                inside.await()
                engine.close()
            }.apply { start() }
            assertThrows(CancellationException::class.java) { simulation.advance() }
            closer.join()
            assertEquals(before, stateDigest(simulation.population))
            engine.close()
            assertThrows(IllegalStateException::class.java) { simulation.advance() }
        }
    }

    @Test
    fun `a coroutine that is cancelled in the middle of a step leaves the population as before, and the engine works on`() {
        var slow = true
        val engine = RegionActorEngine(2, layout).also { it.probe = { if (slow) Thread.sleep(5) } }
        val (p, boundary) = gas(400, 4)
        val step = CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters()).also { it.duration = 0.2 }
        val before = stateDigest(p)
        runBlocking {
            val job = launch { engine.advanceSuspending(step) }
            delay(30)
            job.cancel()
            job.join()
            assertTrue(job.isCancelled)
            assertEquals(before, stateDigest(p))
            slow = false
            engine.advanceSuspending(step)
        }
        assertNotEquals(before, stateDigest(p))
        engine.close()
    }

    @Test
    fun `a restitution that throws is a failing region`() {
        for (engine in engines { }) {
            simulation(engine, { throw ArithmeticException("on purpose") }).use { simulation ->
                val before = stateDigest(simulation.population)
                assertThrows(RegionFailedException::class.java) { simulation.advance() }
                assertEquals(before, stateDigest(simulation.population))
            }
        }
    }

    @Test
    fun `closing twice, and without a single step`() {
        for (engine in engines { }) {
            engine.close()
            engine.close()
        }
    }

    @Test
    fun `inside a host with an actor system of its own, engines come and go and the system stays`() {
        val config = ConfigFactory.parseString("pekko.loglevel=WARNING").withFallback(ConfigFactory.load())
        val host = ActorSystem.create(Behaviors.empty<Void>(), "host", config)
        try {
            repeat(5) {
                PekkoEngine(2, layout, host).use { engine ->
                    val simulation = simulation(engine)
                    simulation.advance()
                    assertEquals(expected[0], stateDigest(simulation.population))
                }
                assertFalse(host.whenTerminated().isCompleted)
            }
        } finally {
            host.terminate()
        }
    }
}
