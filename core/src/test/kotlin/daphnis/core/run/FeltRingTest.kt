package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.cluster.RowCase
import daphnis.core.hill.Satellite
import daphnis.core.input.InputException
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

/** Runs in which satellites feel the ring: where they are goes on with a run, and from its states. */
class FeltRingTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(vararg settings: String) = ScenarioJson.parse(
        RowCase.MOONS.text,
        "test",
        listOf("output.snapshotEvery=2", "output.bodiesEvery=2", "output.seriesEvery=1") + settings,
    )

    private fun start(name: String, vararg settings: String) =
        Run.start(scenario(*settings), "test", home.resolve(name), engines = Engines)

    private fun rows(run: String, file: String) = Files.readAllLines(home.resolve("$run/$file"))

    private fun moons(run: Run) = run.simulation.forces.filterIsInstance<Satellite>().map { it.carried }.toTypedArray()

    @Test
    fun `a run that was cancelled goes on with its moons where they were`() {
        val whole = start("whole").use { run -> run.execute() to moons(run) }
        start("cut").use { it.execute(cancelled = { it.simulation.step >= 3 }) }
        Run.resume(home.resolve("cut"), engines = Engines).use { run ->
            assertEquals(whole.first.stateDigest, run.execute().stateDigest)
            assertArrayEquals(whole.second, moons(run))
        }
        for (file in listOf("series.csv", "bodies.csv")) assertEquals(rows("whole", file), rows("cut", file))
        val bodies = rows("whole", "bodies.csv").drop(1).map { it.split(',') }
        assertEquals(listOf("-2", "-1"), bodies.take(2).map { it[2] })
        assertTrue(bodies.map { it[9] }.distinct().size == bodies.size) { "$bodies" }
    }

    @Test
    fun `from any state that has a row the moons go on, and so do the bits`() {
        val whole = start("whole").use { run -> run.execute() to moons(run) }
        val other = Run.open(home.resolve("whole"))
        for (step in other.steps()) {
            if (step == other.steps().last()) continue
            val from = RunOrigin(other, other.atStep(step))
            Run.start(scenario(), "test", home.resolve("from$step"), engines = Engines, from = from).use { run ->
                assertEquals(whole.first.stateDigest, run.execute().stateDigest) { "step $step" }
                assertArrayEquals(whole.second, moons(run)) { "step $step" }
            }
            // A moon that is to keep its orbit keeps the one it has come to.
            val kept = scenario("forces[0].feelsRing=false")
            Run.start(kept, "test", home.resolve("kept$step"), engines = Engines, from = from).use { run ->
                val moon = run.simulation.forces.filterIsInstance<Satellite>().first()
                val row = rows("whole", "bodies.csv").map { it.split(',') }.single { it[0] == "$step" && it[2] == "-1" }
                assertEquals(row[10].toDouble(), moon.orbit.guidingX)
            }
        }
    }

    @Test
    fun `a state without a row says nothing of moons, and their orbits are none of a new run's settings`() {
        start("whole", "output.bodiesEvery=3", "output.checkpointEvery=100").use { it.execute() }
        val other = Run.open(home.resolve("whole"))
        val without = RunOrigin(other, other.atStep(2))
        val told = assertThrows(InputException::class.java) {
            Run.start(scenario(), "test", home.resolve("x"), engines = Engines, from = without)
        }.message.orEmpty()
        assertTrue("forces[0]" in told && "bodies.csv" in told) { told }
        val states = listOf("x", "y", "e", "phase", "inclination", "node", "epoch").associateWith { true } +
            listOf("softening", "massRatio", "feelsRing", "type").associateWith { false }
        for ((key, isOfState) in states) assertEquals(isOfState, without.isOfState("forces[1].$key")) { key }
        assertEquals(false, without.isOfState("forces[9].x"))
    }

    @Test
    fun `a moon is known by the orbit it was given, wherever in the list, and another one begins anew`() {
        start("whole").use { it.execute() }
        val other = Run.open(home.resolve("whole"))
        val from = RunOrigin(other, other.atStep(4))
        fun begin(name: String, vararg settings: String) =
            Run.start(scenario(*settings), "test", home.resolve(name), engines = Engines, from = from).use { run ->
                run.notices to run.simulation.forces.filterIsInstance<Satellite>().map { it.orbit.guidingX to it.epoch }
            }
        val second = """{"type": "satellite", "massRatio": 2e-20, "x": 50, "y": 15, "e": 3, "inclination": 2,
            "feelsRing": true}"""
        val rows = rows("whole", "bodies.csv").map { it.split(',') }.filter { it[0] == "4" }
        val outer = rows.single { it[2] == "-2" }.let { it[10].toDouble() to it[1].toDouble() }
        val (said, alone) = begin("one", "forces=[$second]")
        assertEquals(listOf(outer), alone)
        assertTrue(said.any { "its forces[0] is no more" in it }) { "$said" }
        val before = """{"type": "uniform-acceleration", "acceleration": [0, 0, 0]}"""
        assertEquals(outer, begin("two", "forces=[$before, $second]").second.single())
        val (anew, moved) = begin("three", "forces[1].x=51")
        assertEquals(51.0 to 0.0, moved[1])
        assertTrue(anew.any { "forces[1] begins anew; none there had the same x" in it }) { "$anew" }
    }

    @Test
    fun `what is not as the run wrote it says nothing of moons, and a damaged checkpoint does not hide a good row`() {
        start("whole", "output.checkpointEvery=4").use { it.execute() }
        val run = home.resolve("whole")
        val step = Run.open(run).steps()[2]
        fun start() = Run.open(run).let { other ->
            val from = RunOrigin(other, other.atStep(step))
            Run.start(scenario(), "test", home.resolve("x"), force = true, engines = Engines, from = from).use { }
        }
        val checkpoint = run.resolve("checkpoint")
        val good = Files.readAllBytes(checkpoint)
        Files.write(checkpoint, good.copyOf().also { it[good.size / 2] = (it[good.size / 2] + 1).toByte() })
        start()
        Files.write(checkpoint, good)
        val table = run.resolve("bodies.csv")
        Files.writeString(table, Files.readString(table).replaceFirst(",-1,", ",-1,1"))
        val told = assertThrows(InputException::class.java) { start() }.message.orEmpty()
        assertTrue("bodies.csv" in told) { told }
    }

    @Test
    fun `energy in the series has that of moons, and is constant where nothing collides or passes a face`() {
        val thin = arrayOf("box.lengths=[60,2000,12]", "particles.opticalDepth=0.001", "untilOrbits=0.2")
        val moons = start("thin", *thin).use { run ->
            fun energy() = run.simulation.forces.filterIsInstance<Satellite>().sumOf { it.energy }
            val before = energy()
            run.execute()
            energy() - before
        }
        val rows = rows("thin", "series.csv").map { it.split(',') }
        val hill = rows[0].indexOfFirst { it.startsWith("hill_energy") }
        val change = rows.last()[hill].toDouble() - rows[1][hill].toDouble()
        assertTrue(abs(change) < 0.02 * abs(moons)) { "$change, and $moons of the moons" }
    }

    @Test
    fun `what cannot feel the ring is refused`() {
        val told = mapOf(
            "forces[0].radius=2" to "forces[0].feelsRing",
            "forces[0].epoch=1e999" to "forces[0].epoch",
            "forces[0].e=1e200" to "forces[0].e",
            "forces[0].x=1e101" to "forces[0].x",
            "forces[0].massRatio=0" to "forces[0].massRatio",
            "frame.verticalFactor=0" to "forces[0].feelsRing",
        )
        for ((setting, key) in told) {
            val message = assertThrows(InputException::class.java) { start("x", setting) }.message.orEmpty()
            assertTrue(key in message) { "$setting: $message" }
        }
    }
}
