package daphnis.core.scenario

import daphnis.core.boundary.at
import daphnis.core.input.InputException
import daphnis.core.population.granularTemperature
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs
import kotlin.math.sqrt

/** A sheet that breathes, in a scenario. */
class PerturbedScenarioTest {
    private fun scenario(vararg settings: String) =
        BuiltIn.scenario("perturbed-ring", listOf("box.lengths=[40,40,20]") + settings)

    @Test
    fun `what does not fit is refused in one line with its key`() {
        for ((settings, key) in listOf(
            listOf("boundary.perturbation=-0.1") to "boundary.perturbation",
            listOf("boundary.perturbation=1") to "boundary.perturbation",
            listOf("boundary.radiallyOpen=true") to "boundary.perturbation",
            listOf("""boundary={"type":"periodic","perturbation":0.5}""") to "boundary.perturbation",
            listOf("""boundary={"type":"lees-edwards","shearRate":1,"perturbation":0.5}""") to "boundary.perturbation",
            listOf("""forces=[{"type":"self-gravity"}]""") to "forces[0]",
            listOf("""forces=[{"type":"body-gravity"}]""") to "forces[0]",
            listOf("""forces=[{"type":"satellite","massRatio":1e-12,"x":-200,"y":0}]""") to "forces[0]",
            listOf("""forces=[{"type":"rescaling","temperature":1e-7,"time":1000}]""") to "forces[0]",
            listOf("""bodies=[{"radius":5,"density":200,"position":[0,0,0]}]""") to "bodies[0]",
            listOf("output.modesEvery=10") to "output.modesEvery",
            listOf("boundary.perturbation=0.95", "particles.opticalDepth=0.01") to "box.lengths[0]",
        )) {
            val message = assertThrows(InputException::class.java) {
                ScenarioSetup.of(scenario(*settings.toTypedArray()), "ring")
            }.message!!
            assertTrue("$key: " in message) { "$settings: $message" }
            assertTrue('\n' !in message) { message }
        }
        ScenarioSetup.of(scenario("""forces=[{"type":"uniform-acceleration","acceleration":[0,0,1e-9]}]"""), "ring")
    }

    @Test
    fun `spheres begin in the narrow box of time 0, with its flow, and as many as on average`() {
        val setup = ScenarioSetup.of(scenario("velocities.exact=true"), "ring")
        val p = setup.population
        val now = setup.boundary.at(0.0)
        assertEquals(20.0, now.box.length(0))
        assertTrue((0 until p.size).all { p.x[it] >= -10 && p.x[it] < 10 })
        val depth = p.radius.sumOf { Math.PI * it * it } / 1600
        assertEquals(0.5, depth, 0.01)
        val omega = setup.angularSpeed!!
        assertEquals(omega * (-1.5 + 2 * 0.5) / 0.5, now.meanFlow!!.rate, 1e-12 * omega)
        assertEquals(0.0004, sqrt(granularTemperature(p, now)), 1e-9)
        // Of a sphere at the edge the flow is much faster than the rest of its motion.
        val edge = (0 until p.size).maxBy { abs(p.x[it]) }
        assertEquals(-omega * p.x[edge], p.vy[edge], 0.002)
    }

    @Test
    fun `it says what it does, in words`() {
        val words = scenario().boundary.inWords({ "%.2f".format(java.util.Locale.ROOT, it) }, { "$it" })
        assertTrue("perturbed" in words && "q = 0.50" in words && "0.50" in words && "1.50" in words) { words }
        val plain = scenario("boundary.perturbation=0").boundary.inWords({ "$it" }, { "$it" })
        assertEquals("shearing sheet, repeats along x and y", plain)
    }

    @Test
    fun `without a perturbation the digest is that of ring-patch, to the bit`(@TempDir home: Path) {
        fun digest(name: String, vararg settings: String): String {
            val all = listOf("untilOrbits=0.5", "box.lengths=[60,60,20]", "output={}") + settings
            return Run.start(BuiltIn.scenario(name, all), name, home.resolve(name)).use { it.execute() }.stateDigest
        }
        assertEquals(digest("ring-patch"), digest("perturbed-ring", "boundary.perturbation=0"))
    }

    @Test
    fun `a run that goes on from a checkpoint at any phase has the bits of one that was never broken`(
        @TempDir home: Path,
    ) {
        val settings = arrayOf("output.checkpointEvery=1", "output.snapshotEvery=30", "timeStep.steps=60")
        fun start(name: String, orbits: Double) =
            Run.start(scenario(*settings, "untilOrbits=$orbits"), "ring", home.resolve(name))
        val whole = start("whole", 1.5).use { it.execute() }
        for (orbits in listOf(0.2, 0.5, 0.9)) {
            val part = home.resolve("part$orbits")
            start("part$orbits", orbits).use { it.execute() }
            val until = Surroundings.of(scenario("untilOrbits=1.5"), "ring").end
            val end = Run.resume(part, until).use { it.execute() }
            assertEquals(whole.stateDigest, end.stateDigest) { "from $orbits orbits" }
            assertEquals(
                Files.readString(home.resolve("whole/transport.csv")),
                Files.readString(part.resolve("transport.csv")),
            )
        }
    }

    @Test
    fun `a run from any state of another ends in the bits of that, and one with other images is refused`(
        @TempDir home: Path,
    ) {
        val settings = listOf("output.snapshotEvery=5", "timeStep.steps=60", "untilOrbits=1")
        fun start(name: String, scenario: Scenario, from: RunOrigin? = null) =
            Run.start(scenario, "ring", home.resolve(name), from = from).use { it.execute() }
        val whole = start("whole", scenario(*settings.toTypedArray()))
        val run = Run.open(home.resolve("whole"))
        fun again(vararg changed: String) = ScenarioJson.read(home.resolve("whole/scenario.json")).let {
            ScenarioJson.parse(ScenarioJson.write(it), "ring", changed.toList())
        }
        fun wrong(changed: String, step: Long) = assertThrows(InputException::class.java) {
            start("wrong", again(changed), RunOrigin(run, run.atStep(step)))
        }.message!!
        for (step in listOf(0L, 5L, 15L, 35L)) {
            val end = start("from$step", again(), RunOrigin(run, run.atStep(step)))
            assertEquals(whole.stateDigest, end.stateDigest) { "from $step" }
        }
        for (changed in listOf("boundary.perturbation=0.4", "boundary.perturbation=0", "box.lengths=[41,40,20]")) {
            assertTrue("box.lengths[0]: is " in wrong(changed, 35)) { wrong(changed, 35) }
        }
        // Round-off is no other box.
        start("close", again("box.lengths=[40.000000000001,40,20]"), RunOrigin(run, run.atStep(55)))
        // A quarter of a period after the narrowest it is as wide as on average for every q, with images elsewhere.
        assertEquals(40.0, run.atStep(15).lengths[0], 1e-6)
        val elsewhere = wrong("boundary.perturbation=0.4", 15)
        assertTrue("boundary: puts images off by" in elsewhere && "placement.time" !in elsewhere) { elsewhere }
    }
}
