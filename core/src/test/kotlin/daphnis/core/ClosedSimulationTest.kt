package daphnis.core

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.force.Kick
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CountDownLatch

/** What is left of a simulation that is closed. The time limit is the watchdog. */
@Timeout(120)
class ClosedSimulationTest : FaultKit() {
    @Test
    fun `a closed simulation refuses steps and loops, and so does its engine`() {
        for (make in engines) {
            var given: RangeLoop = InlineLoop
            val force = object : Kick {
                override fun useLoop(loop: RangeLoop) {
                    given = loop
                }

                override fun kick(population: Population, time: Double, duration: Double) = Unit
            }
            val engine = make()
            val simulation = simulation(engine, forces = listOf(force))
            simulation.advance()
            val before = stateDigest(simulation.population)
            given.run(10) { _, _, _ -> }
            repeat(2) { simulation.close() }
            assertRefused("the simulation is closed") { simulation.advance() }
            assertRefused("the simulation is closed") { given.run(10) { _, _, _ -> } }
            assertEquals(before, stateDigest(simulation.population))
            assertEquals(1, simulation.step)
            if (engine == null) continue
            val step =
                CollisionStep(
                    simulation.population,
                    boundary,
                    CollisionLaw(ConstantRestitution(1.0)),
                    CollisionCounters(),
                )
            step.duration = 0.1
            assertRefused("the engine is closed") { engine.advance(step) }
            assertRefused("the engine is closed") { engine.loop.run(10) { _, _, _ -> } }
        }
    }

    @Test
    fun `closing within a step lets it end, or leaves all as it was`() {
        for (make in engines) {
            for (place in listOf("restitution", "force", "output", "another thread")) {
                var isArmed = false
                var closing: Simulation? = null
                fun closeAt(here: String) {
                    if (!isArmed || here != place) return
                    isArmed = false
                    closing!!.close()
                }
                val restitution = Restitution { closeAt("restitution").let { 0.9 } }
                val force = Kick { _, _, _ ->
                    closeAt("force")
                    if (isArmed && place == "another thread") Thread { closeAt(place) }.apply { start() }.join()
                }
                val simulation = simulation(make(), restitution, listOf(force), listOf(Output { closeAt("output") }))
                val expected = digests(2, simulation.collisions != null)
                closing = simulation
                simulation.advance()
                isArmed = true
                val done = runCatching { simulation.advance() }.isSuccess
                val story = "${simulation.collisions?.engine?.name}, $place"
                assertEquals(expected[if (done) 2 else 1], stateDigest(simulation.population)) { story }
                assertEquals(if (done) 2 else 1, simulation.step) { story }
                if (!isArmed) assertRefused("the simulation is closed") { simulation.advance() }
                simulation.close()
            }
        }
    }

    @Test
    fun `closing from another thread at any moment lets the step end, or leaves all as it was`() {
        val expected = digests(12)
        for (make in engines) {
            val simulation = simulation(make() ?: continue)
            val started = CountDownLatch(1)
            val closer = Thread {
                started.await()
                Thread.sleep(3)
                simulation.close()
            }.apply { start() }
            started.countDown()
            var isOpen = true
            while (isOpen && simulation.step < 12) isOpen = runCatching { simulation.advance() }.isSuccess
            closer.join()
            val name = simulation.collisions!!.engine.name
            assertEquals(expected[simulation.step.toInt()], stateDigest(simulation.population)) { name }
        }
    }
}
