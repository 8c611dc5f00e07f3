package daphnis.core.scenario

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Open
import daphnis.core.engine.SerialEngine
import daphnis.core.format.ExtendedXyz
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.population.SpinSums
import daphnis.core.population.stateDigest
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.SeriesColumns
import daphnis.core.run.results
import daphnis.core.run.tableScenario
import daphnis.core.run.toStep
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.CoulombRoughness
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.sqrt

class RoughScenarioTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(vararg settings: String, boundary: String = PERIODIC) = ScenarioJson.parse(
        """{
          "box": { "lengths": [60, 60, 60] }, "boundary": $boundary,
          "particles": { "count": 3000, "sizes": { "type": "power-law", "minimum": 0.2, "maximum": 0.8, "exponent": 2 } },
          "velocities": { "type": "gaussian", "sigma": 1 },
          "restitution": { "type": "constant", "coefficient": 1 },
          "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 1
        }""",
        "test",
        settings.toList(),
    )

    private fun setup(vararg settings: String, boundary: String = PERIODIC) =
        ScenarioSetup.of(scenario(*settings, boundary = boundary), "test")

    private fun refused(vararg settings: String, boundary: String = PERIODIC): String =
        assertThrows(InputException::class.java) { setup(*settings, boundary = boundary) }.message.orEmpty()

    @Test
    fun `without roughness nothing spins, with it everything else is drawn as before`() {
        val smooth = setup()
        assertFalse(smooth.population.hasSpin)
        assertNull(smooth.roughness)
        assertFalse("roughness" in ScenarioJson.write(scenario()) || "spins" in ScenarioJson.write(scenario()))
        val rough = setup("roughness=$CONSTANT", """spins={"type": "gaussian", "sigma": 2}""")
        assertTrue(rough.population.hasSpin)
        for (place in 0..7) assertArrayEquals(smooth.population.column(place), rough.population.column(place))
        assertEquals(0.25, (rough.roughness as ConstantRoughness).value)
        assertEquals(0.4, rough.momentFactor)
        val coulomb = setup("""roughness={"type": "coulomb", "friction": 0.3, "sticking": 0.5, "momentFactor": 0.5}""")
        assertEquals(0.3, (coulomb.roughness as CoulombRoughness).friction)
        assertEquals(0.5, coulomb.momentFactor)
        assertTrue(coulomb.population.wx.all { it == 0.0 })
        // Spheres that are smooth and spin.
        assertNull(setup("""roughness={"type": "smooth"}""").roughness)
        assertTrue(setup("""roughness={"type": "smooth"}""").population.hasSpin)
    }

    @Test
    fun `spins have the temperature, the deviation and the mean that are asked for, for every size`() {
        val hot = setup("roughness=$CONSTANT", """spins={"type": "gaussian", "temperature": 0.7}""").population
        fun square(k: Int) = hot.wx[k] * hot.wx[k] + hot.wy[k] * hot.wy[k] + hot.wz[k] * hot.wz[k]
        for ((from, to) in listOf(0.2 to 0.3, 0.3 to 0.5, 0.5 to 0.81)) {
            val some = (0 until hot.size).filter { hot.radius[it] >= from && hot.radius[it] < to }
            val t = some.sumOf { 0.4 * hot.mass[it] * hot.radius[it] * hot.radius[it] * square(it) } / 3 / some.size
            assertEquals(0.7, t, 4 * 0.7 * sqrt(2.0 / 3 / some.size)) { "radii from $from to $to: ${some.size}" }
        }
        val turning = setup("roughness=$CONSTANT", """spins={"type": "gaussian", "sigma": 2, "mean": [0, -3, 1]}""")
        val p = turning.population
        assertEquals(-3.0, p.wy.average(), 4 * 2 / sqrt(3000.0))
        assertEquals(4.0, p.wy.sumOf { (it + 3) * (it + 3) } / p.size, 4 * 4 * sqrt(2 / 3000.0))
        val alike = setup("roughness=$CONSTANT", """spins={"type": "rest", "mean": [1, 2, 3]}""").population
        assertTrue(alike.wx.all { it == 1.0 } && alike.wy.all { it == 2.0 } && alike.wz.all { it == 3.0 })
        // Another seed, another draw; the same seed, the same.
        val words = arrayOf("roughness=$CONSTANT", """spins={"type": "gaussian", "sigma": 2}""")
        assertEquals(stateDigest(setup(*words).population), stateDigest(setup(*words).population))
        assertFalse(setup(*words, "seed=2").population.wx.contentEquals(setup(*words).population.wx))
    }

    @Test
    fun `walls have surfaces of their own, each face if need be`() {
        val one = """{ "type": "constant", "coefficient": 0.25 }"""
        val two = """{ "type": "coulomb", "friction": 0.5, "sticking": 0 }"""
        val faces = """{ "all": $one, "upperX": $two, "lowerZ": { "type": "smooth" } }"""
        val setup = setup(boundary = """{ "type": "walls", "axes": "xz", "roughness": $faces }""")
        assertTrue(setup.population.hasSpin && setup.roughness == null)
        val laws = List(6) { setup.boundary.walls[it]?.roughness }
        assertEquals(listOf(0.25, null, null, null, null, 0.25), laws.map { (it as? ConstantRoughness)?.value })
        assertEquals(0.5, (laws[1] as CoulombRoughness).friction)
        val walls = """"type": "walls", "axes": "xz", "roughness": """
        for ((roughness, problem) in listOf(
            """{ "lowerY": $one }""" to "boundary.roughness.lowerY: is of no wall; there are walls across xz",
            """{ "all": { "type": "constant", "coefficient": -2 } }""" to
                "boundary.roughness.all.coefficient: is -2.0; must be in [-1, 1]",
            """{ "all": { "type": "smooth", "momentFactor": 0.4 } }""" to
                "boundary.roughness.all.momentFactor: is that of spheres",
            """{ "top": $one }""" to "boundary.roughness.top: unknown key",
        )) {
            val said = refused(boundary = "{ $walls$roughness }")
            assertTrue(problem in said) { "$problem: $said" }
        }
    }

    @Test
    fun `what is wrong is said in one line with its key`() {
        for ((settings, problem) in listOf(
            listOf("""roughness={"type": "constant", "coefficient": 1.5}""") to
                "roughness.coefficient: is 1.5; must be in [-1, 1]",
            listOf("""roughness={"type": "coulomb", "friction": -1, "sticking": 0}""") to
                "roughness.friction: is -1.0; must be at least 0",
            listOf("""roughness={"type": "coulomb", "friction": 1, "sticking": 2}""") to
                "roughness.sticking: is 2.0; must be in [-1, 1]",
            listOf(
                """roughness={"type": "smooth", "momentFactor": 0.7}""",
            ) to "roughness.momentFactor: is 0.7; must be",
            listOf("""roughness={"type": "walton"}""") to "roughness.type: is \"walton\"; ",
            listOf("""spins={"type": "rest"}""") to "spins: are of spheres that spin; give roughness",
            listOf("roughness=$CONSTANT", """spins={"type": "rest", "mean": [0, 1e160, 0]}""") to
                "E159; it must be at most 1.0E70",
            listOf("roughness=$CONSTANT", """spins={"type": "gaussian"}""") to
                "spins: needs exactly one of sigma and temperature",
            listOf("roughness=$CONSTANT", """spins={"type": "gaussian", "sigma": -1}""") to
                "spins.sigma: is -1.0; must be at least 0",
            listOf("roughness=$CONSTANT", """spins={"type": "gaussian", "temperature": -1}""") to
                "spins.temperature: is -1.0; must be at least 0",
            listOf("roughness=$CONSTANT", """spins={"type": "rest", "mean": [1, 2]}""") to
                "spins.mean: is [1.0, 2.0]; must be three numbers",
            listOf("roughness=$CONSTANT", """spins={"type": "gaussian", "sigma": 1e308, "mean": [1e308, 0, 0]}""") to
                "spins: make the surface of particle ",
        )) {
            val said = refused(*settings.toTypedArray())
            assertTrue(problem in said && '\n' !in said) { "$problem: $said" }
        }
    }

    /** A state of two spheres as a file. */
    private fun file(hasSpin: Boolean): Path {
        val at = doubleArrayOf(-2.0, 2.0)
        val zero = DoubleArray(2)
        val one = DoubleArray(2) { 1.0 }
        val smooth = Population(at, zero, zero, one, zero, zero, one, one)
        val p = if (hasSpin) smooth.withSpin(doubleArrayOf(0.5, -0.5), zero, zero) else smooth
        val path = home.resolve("state-$hasSpin.xyz")
        Files.newBufferedWriter(path).use { ExtendedXyz.write(Snapshot.of(p, Open, 0, 0.0), it) }
        return path
    }

    private fun placed(hasSpin: Boolean, vararg settings: String) = ScenarioSetup.of(
        ScenarioJson.parse(
            """{
              "box": { "lengths": [60, 60, 60] }, "boundary": { "type": "open" },
              "placement": { "type": "file", "path": "${file(hasSpin)}" },
              "restitution": { "type": "constant", "coefficient": 1 },
              "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 1
            }""",
            "test",
            settings.toList(),
        ),
        "test",
    )

    @Test
    fun `spins of a file are kept by rough spheres, and dropped by smooth ones, which is said`() {
        val kept = placed(hasSpin = true, "roughness=$CONSTANT")
        assertEquals(listOf(0.5, -0.5), kept.population.wx.toList())
        assertTrue(kept.notices.none { "angular" in it }) { "${kept.notices}" }
        val dropped = placed(hasSpin = true)
        assertFalse(dropped.population.hasSpin)
        assertTrue(dropped.notices.any { "has angular velocities, which are dropped" in it }) { "${dropped.notices}" }
        val still = placed(hasSpin = false, "roughness=$CONSTANT")
        assertEquals(listOf(0.0, 0.0), still.population.wx.toList())
        assertTrue(still.notices.any { "has no angular velocities" in it }) { "${still.notices}" }
        val drawn = placed(hasSpin = false, "roughness=$CONSTANT", """spins={"type": "rest", "mean": [0, 0, 2]}""")
        assertEquals(listOf(2.0, 2.0), drawn.population.wz.toList())
        assertTrue(drawn.notices.none { "angular" in it }) { "${drawn.notices}" }
        val e = assertThrows(InputException::class.java) {
            placed(hasSpin = true, "roughness=$CONSTANT", """spins={"type": "rest"}""")
        }
        assertTrue("spins: must be left out" in e.message.orEmpty()) { e.message }
    }

    private fun rough() = tableScenario(
        """roughness={"type": "coulomb", "friction": 0.4, "sticking": 0.5, "momentFactor": 0.3}""",
        """spins={"type": "gaussian", "temperature": 0.5, "mean": [0, 0, 1]}""",
    )

    @Test
    fun `a rough run that is ended and resumed, or done again from its own scenario, has the same bits`() {
        val whole = Run.start(rough(), "test", home.resolve("whole")).use { it.execute() }
        val broken = RunDirectory(home.resolve("broken"))
        Run.start(rough(), "test", broken.path).toStep(8)
        Run.resume(broken.path).use { it.execute() }
        assertEquals(results(home.resolve("whole")), results(broken.path))
        val again = ScenarioJson.read(home.resolve("whole/scenario.json"))
        val second = Run.start(again, "again", home.resolve("again")).use { it.execute() }
        assertEquals(whole.stateDigest, second.stateDigest)
        val snapshot = RunDirectory(home.resolve("whole")).let { it.readSnapshot(it.snapshotSteps().last()) }
        assertEquals(whole.stateDigest, stateDigest(snapshot.population()))
        val smooth = Run.start(tableScenario(), "test", home.resolve("smooth")).use { it.execute() }
        assertTrue(smooth.stateDigest != whole.stateDigest)
    }

    @Test
    fun `the series has columns of spins where there are spins`() {
        for (isRough in listOf(true, false)) {
            val directory = home.resolve("series-$isRough")
            Run.start(if (isRough) rough() else tableScenario(), "test", directory).use { it.execute() }
            val lines = Files.readAllLines(directory.resolve("series.csv"))
            val heads = lines[0].split(',').map { it.substringBefore(' ') }
            assertEquals(isRough, SeriesColumns.ROTATIONAL_ENERGY.name in heads)
            if (!isRough) continue
            val last = RunDirectory(directory).let { it.readSnapshot(it.snapshotSteps().last()) }.population()
            val cells = heads.zip(lines.last().split(',').map { it.toDouble() }).toMap()
            val sums = SpinSums(0.3).also { it.take(last) }
            assertEquals(sums.energyOfRotation, cells["rotational_energy"])
            assertEquals(sums.temperature, cells["rotational_temperature"])
            assertEquals(sums.mean(2), cells["mean_spin_z"])
            assertEquals(cells.getValue("kinetic_energy") + sums.energyOfRotation, cells["total_energy"])
            // Space repeats.
            assertTrue(cells.getValue("angular_momentum_z").isNaN())
        }
    }

    @Test
    fun `sums over spins are those of the textbook, and total angular momentum stays in open space`() {
        val p = placed(hasSpin = true, "roughness=$CONSTANT").population
        p.vx[1] = -1.0
        p.y[1] = 1.0
        val sums = SpinSums(0.4)
        sums.take(p)
        assertEquals(0.4 * 0.5 * 0.5, sums.energyOfRotation, 1e-16)
        assertEquals(2 * 0.4 * 0.25 / 2 / 3, sums.temperature, 1e-16)
        assertEquals(1.0, sums.angularMomentum(2), 1e-16)
        val setup = placed(hasSpin = true, "roughness=$CONSTANT", "restitution.coefficient=0.5")
        Simulation(p, Open, setup.collisions(SerialEngine()), FixedTimeStep(0.5)).use {
            repeat(8) { _ -> it.advance() }
            assertEquals(1L, it.collisions!!.counters.collisions)
            sums.take(it.population)
            assertEquals(1.0, sums.angularMomentum(2), 1e-15)
            assertEquals(0.0, sums.angularMomentum(0), 1e-15)
            assertTrue(it.population.wz[0] != 0.0)
        }
        sums.take(placed(hasSpin = false).population)
        assertEquals(0.0, sums.energyOfRotation)
    }

    private companion object {
        const val PERIODIC = """{ "type": "periodic" }"""
        const val CONSTANT = """{"type": "constant", "coefficient": 0.25}"""
    }
}
