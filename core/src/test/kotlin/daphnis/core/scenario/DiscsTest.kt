package daphnis.core.scenario

import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.format.ParticleCsv
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.population.VelocityMoments
import daphnis.core.population.granularTemperature
import daphnis.core.population.stateDigest
import daphnis.core.run.CollisionStatistics
import daphnis.core.space.Space
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.sqrt

/** Scenarios with `"dimensions": 2`. */
class DiscsTest {
    private val plain = """{
        "dimensions": 2, "box": { "lengths": [24, 18] }, "boundary": { "type": "periodic" },
        "particles": { "fillingFactor": 0.4, "sizes": { "type": "equal", "radius": 0.5 } },
        "velocities": { "type": "gaussian", "sigma": 1.0, "exact": true },
        "restitution": { "type": "constant", "coefficient": 1.0 }, "until": 10
    }"""

    private fun setup(vararg settings: String, text: String = plain) =
        ScenarioSetup.of(ScenarioJson.parse(text, "discs", settings.toList()), "discs")

    private fun problem(vararg settings: String, text: String = plain): String =
        assertThrows<InputException> { setup(*settings, text = text) }.message.orEmpty()

    private fun run(setup: ScenarioSetup, boundary: BoundaryConditions, steps: Int): Population {
        val forcing = setup.collisions()
        Simulation(setup.population, boundary, forcing, setup.timeStep, setup.forces).use { simulation ->
            repeat(steps) { simulation.advance() }
            return simulation.population
        }
    }

    @Test
    fun `discs have the bits of spheres in a slab whose heights are all 0`() {
        val rough =
            arrayOf("""roughness={"type":"constant","coefficient":0.3}""", "spins={\"type\":\"gaussian\",\"sigma\":2}")
        val lossy = "restitution.coefficient=0.8"
        val sheared = """boundary={"type":"lees-edwards","shearRate":0.7}"""
        val walled = """boundary={"type":"walls","axes":"xyz","restitution":0.9}"""
        val falling = """forces=[{"type":"uniform-acceleration","acceleration":[0,-1,0]}]"""
        val fixed = "timeStep={\"type\":\"fixed\",\"dt\":0.05}"
        val slab = Box.centred(24.0, 18.0, 7.0)
        val cases = listOf<Pair<Array<String>, BoundaryConditions>>(
            rough + lossy to Periodic(slab),
            rough + arrayOf(lossy, sheared) to LeesEdwards(slab, 0.7),
            rough + arrayOf(lossy, walled, falling, fixed) to
                Walls(slab, 0.9, booleanArrayOf(true, true, false)),
        )
        for ((settings, boundary) in cases) {
            val discs = setup(*settings).let { run(it, it.boundary, 60) }
            val spheres = run(setup(*settings), boundary, 60)
            assertEquals(stateDigest(spheres), stateDigest(discs)) { settings.joinToString() }
            for (none in listOf(discs.z, discs.vz, discs.wx, discs.wy)) {
                assertTrue(none.all { it.toRawBits() == 0L }) { "out of the plane: ${settings.joinToString()}" }
            }
            assertTrue(discs.wz.any { it != 0.0 })
        }
    }

    @Test
    fun `temperatures are those of two components, and of one spin`() {
        val setup = setup("""roughness={"type":"smooth"}""", "spins={\"type\":\"gaussian\",\"temperature\":2}")
        val p = setup.population
        assertEquals(1.0, granularTemperature(p, setup.boundary), 1e-12)
        assertEquals(1.0, VelocityMoments.within(setup.boundary, p).temperature, 1e-12)
        val speeds = (0 until p.size).sumOf { p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] } / p.size
        assertEquals(2.0 * (p.size - 1) / p.size, speeds, 1e-12)
        // Discs are as heavy as their area says, and turn as discs do.
        assertEquals(PI / 4, p.mass[0], 1e-15)
        assertEquals(0.5, setup.momentFactor)
        val turning = (0 until p.size).sumOf { 0.5 * p.mass[it] * 0.25 * p.wz[it] * p.wz[it] } / p.size
        assertEquals(2.0, turning, 4 * 2 * sqrt(2.0 / p.size))
    }

    @Test
    fun `the filling factor is the part of the area that discs cover`() {
        assertEquals(220, setup().population.size)
        val dense = setup("particles.fillingFactor=0.86", """placement={"type":"lattice","lattice":"hexagonal"}""")
        assertEquals(0.86, dense.population.size * PI / 4 / (24 * 18), 0.002)
        val square = setup("particles.fillingFactor=0.7", """placement={"type":"lattice","lattice":"square"}""")
        assertEquals(0.7, square.population.size * PI / 4 / (24 * 18), 0.002)
        val hexagonal = setup("particles.fillingFactor=0.86", """placement={"type":"lattice"}""")
        assertEquals(stateDigest(dense.population), stateDigest(hexagonal.population))
        // Random placement goes on where that of spheres has long given up.
        val random = setup("particles.fillingFactor=0.5")
        assertEquals(0.5, random.population.size * PI / 4 / (24 * 18), 0.002)
    }

    @Test
    fun `the pressure of hard discs is that of Henderson`() {
        val setup =
            setup("box.lengths=[40,40]", "particles={\"count\":576,\"sizes\":{\"type\":\"equal\",\"radius\":0.5}}")
        val forcing = setup.collisions(recordCollisions = true)
        val statistics = CollisionStatistics(from = 5.0)
        val outputs = listOf(statistics)
        Simulation(setup.population, setup.boundary, forcing, setup.endlessTimeStep(), emptyList(), outputs).use {
            while (it.time < 45) it.advance()
            // p A / (N m T) of T = 1 and equal masses: 1 + half the trace of the virial over N m t.
            val mass = it.population.mass.sum()
            val virial = (statistics.virial[0] + statistics.virial[4]) / 2 / mass / (it.time - 5.0)
            // 40,000 collisions; the scatter over seeds is .007.
            assertEquals(1.963, 1 + virial, 0.03)
            assertEquals(0.0, statistics.virial[8])
        }
    }

    @Test
    fun `what has no place in the plane is refused by its name`() {
        val cases = mapOf(
            "box.lengths=[24,18,9]" to "box.lengths: is [24.0, 18.0, 9.0]; must be two numbers",
            "dimensions=3" to "discs in a plane need dimensions 2",
            "dimensions=4" to "dimensions: is 4; must be 2 or 3",
            "frame={\"type\":\"hill\",\"angularSpeed\":1}" to "frame: is of a ring",
            "boundary={\"type\":\"walls\",\"axes\":\"z\"}" to "boundary.axes: is z; must name x, y",
            "forces=[{\"type\":\"self-gravity\",\"constant\":1}]" to "forces[0]: is a force in three dimensions",
            "forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[0,0,1]}]" to "forces[0].acceleration",
            "placement={\"type\":\"lattice\",\"lattice\":\"fcc\"}" to "placement.lattice: is of spheres",
            "particles.fillingFactor=0.91" to "closest packing",
            "particles.fillingFactor=0.8" to "equal discs at random jam at 0.547",
            "bodies=[{\"radius\":2,\"position\":[0,0,1]}]" to "bodies[0].position",
        )
        val fixed = "timeStep={\"type\":\"fixed\",\"dt\":0.05}"
        for ((setting, words) in cases) {
            val boxed = if ("fillingFactor=0.8" in setting) arrayOf("box.lengths=[60,60]") else emptyArray()
            val message = problem(setting, fixed, *boxed)
            assertTrue(words in message) { "$setting: $message" }
            assertTrue('\n' !in message)
        }
        val spins = problem("roughness={\"type\":\"smooth\"}", "spins={\"type\":\"rest\",\"mean\":[1,0,0]}")
        assertTrue("spins.mean" in spins) { spins }
        val hollow = setup("roughness={\"type\":\"smooth\",\"momentFactor\":1}")
        assertEquals(1.0, hollow.momentFactor)
        assertTrue("that of a ring" in problem("roughness={\"type\":\"smooth\",\"momentFactor\":1.1}"))
    }

    @Test
    fun `discs whose mass is near their rims collide, and lose nothing where nothing slides for good`() {
        for (factor in listOf(0.86, 1.0)) {
            val setup = setup("""roughness={"type":"constant","coefficient":1,"momentFactor":$factor}""")
            val p = run(setup, setup.boundary, 60)
            val energy = (0 until p.size).sumOf {
                val turning = factor * p.radius[it] * p.radius[it] * p.wz[it] * p.wz[it]
                0.5 * p.mass[it] * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + turning)
            }
            assertEquals((p.size - 1) * p.mass[0], energy, 1e-11 * energy)
            assertTrue(p.wz.any { it != 0.0 })
        }
    }

    @Test
    fun `a file of discs has no heights`(@TempDir directory: Path) {
        val text = """{
            "dimensions": 2, "box": { "lengths": [10, 10] }, "boundary": { "type": "periodic" },
            "placement": { "type": "file", "path": "${directory.resolve("discs.csv")}" },
            "restitution": { "type": "constant", "coefficient": 1.0 }, "until": 10
        }"""
        Files.writeString(directory.resolve("discs.csv"), "x,y,z,vx,vy,vz,radius\n0,0,0,1,0,0,0.5\n3,0,0,0,1,0,0.5\n")
        val population = setup(text = text).population
        assertEquals(Space.PLANE.volume(0.5), population.mass[0])
        // Without heights it is of discs alone.
        Files.writeString(directory.resolve("discs.csv"), "x,y,vx,vy,radius\n0,0,1,0,0.5\n3,0,0,1,0.5\n")
        val flat = setup(text = text)
        assertEquals(stateDigest(population), stateDigest(flat.population))
        assertEquals(population.mass.toList(), flat.population.mass.toList())
        assertTrue(flat.notices.none { "velocities" in it }) { "${flat.notices}" }
        assertEquals(2 * PI * 0.25, ParticleCsv.population(directory.resolve("discs.csv"), 2.0).mass[1], 1e-15)
        val told = problem("box.lengths=[10,10,10]", "dimensions=3", text = text)
        assertTrue("these are discs, which need dimensions 2" in told) { told }
        for ((row, words) in listOf("3,0,1e-9,0,1,0,0.5" to "z = 1.0E-9", "3,0,0,0,1,-2,0.5" to "vz = -2.0")) {
            Files.writeString(directory.resolve("discs.csv"), "x,y,z,vx,vy,vz,radius\n0,0,0,1,0,0,0.5\n$row\n")
            val message = problem(text = text)
            assertTrue("particle 1 has $words; it must be 0, with dimensions 2" in message) { message }
        }
    }
}
