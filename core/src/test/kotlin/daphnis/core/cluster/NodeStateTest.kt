package daphnis.core.cluster

import daphnis.core.Engines
import daphnis.core.engine.EngineFactory
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.run.Run
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.time.Duration
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger

/** What belongs to the state of a run, but not to its digest: boxes crossed and times of collision; and odd ids. */
@Timeout(120)
class NodeStateTest {
    @TempDir
    lateinit var home: Path

    /** A clock by which copies cost nothing and are due after nearly every step. */
    private fun often(): CopyClock {
        var looks = 0
        return CopyClock { ++looks / 3 * 10_000_000_000L }
    }

    private fun engines(fleet: Fleet) = FleetEngines(fleet, Duration.ZERO, { }, often())

    /** All of the spheres by id, with the counters. */
    private fun stateOf(run: Run): List<Any> {
        val p = run.simulation.population
        val c = run.simulation.collisions!!.counters
        return listOf(stateDigest(p), c.collisions, c.wallCollisions, c.guardActivations) + boxes(p) + times(p)
    }

    private fun boxes(p: Population) = (0 until 3).flatMap { axis -> p.id.sorted().map { p.boxesCrossed(it, axis) } }

    private fun times(p: Population) = p.id.sorted().map { p.lastCollision[p.indexOf(it)] }

    private fun run(case: RowCase, name: String, engines: EngineFactory, settings: List<String>): Run {
        val all = settings + listOf("output.seriesEvery=0", "output.checkpointEvery=0", "engine.name=serial")
        return Run.start(ScenarioJson.parse(case.text, "test", all), "test", home.resolve(name), engines = engines)
    }

    private fun end(run: Run, steps: Int = Int.MAX_VALUE): List<Any> = run.use {
        it.execute(cancelled = { it.simulation.step >= steps })
        stateOf(it)
    }

    private fun Run.stateAfter(steps: Int): List<Any> = use {
        repeat(steps) { simulation.advance() }
        stateOf(this)
    }

    @Tag("thorough")
    @Test
    fun `boxes crossed and times of collision are kept through losses and copies`() {
        val settings = listOf(GUARD, "velocities.sigma=10")
        val expected = run(RowCase.SHEARED, "serial", Engines, settings).stateAfter(10)
        assertTrue(expected.count { it is Int && it != 0 } > 100) { "few boxes are crossed" }
        assertTrue(expected.count { it is Double && it.isFinite() } > 100) { "few spheres have collided" }
        assertTrue(expected[3] as Long > 0) { "the guard does nothing" }
        val random = Random(8)
        var lost = 0
        repeat(5) { turn ->
            val fleet = ThreadFleet(3) { 1 + it % 2 }
            val left = AtomicInteger(1 + random.nextInt(500))
            val victim = random.nextInt(3)
            fleet.onSend = { _, _, _ -> if (left.decrementAndGet() == 0) fleet.kill(victim) }
            assertEquals(expected, run(RowCase.SHEARED, "nodes$turn", engines(fleet), settings).stateAfter(10))
            lost += fleet.crews - 1
        }
        assertTrue(lost > 1) { "only $lost were lost" }
    }

    @Test
    fun `a run whose spheres are all removed goes on`() {
        val settings =
            listOf(satellite("\"x\": 0, \"y\": 0, \"radius\": 500"))
        val expected = run(RowCase.REMOVED, "serial", Engines, settings).stateAfter(5)
        assertEquals(4, expected.size)
        assertEquals(expected, run(RowCase.REMOVED, "nodes", engines(ThreadFleet(3)), settings).stateAfter(5))
    }

    @Test
    fun `ids with large gaps`() {
        val settings =
            listOf(satellite("\"x\": -8, \"y\": 0, \"radius\": 36"))
        val few = run(RowCase.REMOVED, "serial", Engines, settings)
        end(few, 4)
        val serial = Run.resume(home.resolve("serial"), engines = Engines)
        assertTrue(serial.simulation.population.idPlaces.ranked != null) { "ids are dense" }
        val expected = serial.stateAfter(4)
        val nodes = Run.resume(home.resolve("serial"), engines = engines(ThreadFleet(3) { 2 }))
        assertEquals(expected, nodes.stateAfter(4))
    }

    private fun satellite(where: String) = "forces=[{\"type\": \"satellite\", \"massRatio\": 1e-20, $where}]"

    private companion object {
        const val GUARD = "guard={\"type\": \"contact-duration\", \"duration\": 0.12}"
    }
}
