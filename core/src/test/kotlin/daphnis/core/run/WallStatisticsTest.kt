package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.Roughness
import daphnis.core.wall.WallContact
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallMotion
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What walls give to spheres, against what the spheres have. */
class WallStatisticsTest {
    private val box = Box.centred(12.0, 12.0, 12.0)
    private val pull = listOf(0.2, -0.1, -0.4)
    private val moment = 0.4

    private val faces = listOf(
        WallFace(temperature = 0.7),
        WallFace(restitution = 0.4, motion = WallMotion.Steady(-0.05)),
        WallFace(motion = WallMotion.Sawtooth(0.1, 0.8, rise = 0.7)),
        WallFace(temperature = 1.5, motion = WallMotion.BiParabolic(0.1, 0.6)),
        WallFace(motion = WallMotion.Sine(0.2, 1.1)),
        null,
    )

    private class Bed(val simulation: Simulation, val walls: WallStatistics, val pairs: CollisionStatistics) {
        val population: Population get() = simulation.population

        fun advance(): Unit = simulation.run {
            advance()
            walls.write(this)
            pairs.write(this)
        }
    }

    private fun bed(faces: List<WallFace?>, rough: Roughness? = null): Bed {
        val isThermal = { face: Int -> faces[face]?.temperature != null }
        val roughness = if (rough == null) emptyList() else List(6) { if (isThermal(it)) null else rough }
        val boundary = Walls(box, 1.0, roughness = roughness, faces = faces, seed = 9)
        val smooth = randomSpheres(40, boundary, 3, 1.0) { 0.5 }
        val random = SeededRandom(4)
        fun spin() = DoubleArray(smooth.size) { random.nextGaussian() }
        val spheres = if (rough == null) smooth else smooth.withSpin(spin(), spin(), spin())
        val forcing = CollisionForcing(
            ConstantRestitution(0.9),
            recordCollisions = true,
            roughness = rough,
            momentFactor = moment,
        )
        val forces = listOf(UniformAcceleration(pull[0], pull[1], pull[2]))
        val simulation = Simulation(spheres, boundary, forcing, FixedTimeStep(0.4), forces)
        return Bed(simulation, WallStatistics(), CollisionStatistics())
    }

    private fun energy(p: Population): Double = (0 until p.size).sumOf { k ->
        val u = p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
        val turns = if (p.hasSpin) p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k] else 0.0
        val height = -(pull[0] * p.x[k] + pull[1] * p.y[k] + pull[2] * p.z[k])
        p.mass[k] * (0.5 * u + 0.5 * moment * p.radius[k] * p.radius[k] * turns + height)
    }

    @Test
    fun `what spheres have is what walls gave less what collisions took`() {
        for (rough in listOf(null, ConstantRoughness(0.5))) {
            val bed = bed(faces, rough)
            val before = energy(bed.population)
            repeat(200) { bed.advance() }
            val gained = energy(bed.population) - before
            val scale = Math.abs(bed.walls.given) + bed.pairs.dissipated
            assertTrue(bed.pairs.dissipated > 20 && bed.walls.count > 1000) { "${bed.pairs.dissipated}" }
            assertEquals(gained, bed.walls.given - bed.pairs.dissipated, 1e-11 * scale) { "rough: ${rough != null}" }
            assertEquals(bed.simulation.collisions!!.counters.wallCollisions, bed.walls.count)
        }
    }

    @Test
    fun `perfectly rough elastic walls at rest keep the energy of spheres that fall along them`() {
        // A steady motion with no speed: recorded, at rest.
        val resting = List(6) { WallFace(motion = WallMotion.Steady(0.0)) }
        for (roughness in listOf(1.0, -1.0)) {
            val bed = bed(resting, ConstantRoughness(roughness))
            val before = energy(bed.population)
            repeat(100) { bed.advance() }
            assertTrue(bed.walls.count > 500)
            assertEquals(0.0, bed.walls.given, 1e-11 * before)
        }
    }

    @Test
    fun `impulses are what changes the momentum of all`() {
        val bed = bed(List(6) { if (it == 4) WallFace(motion = WallMotion.Sine(0.2, 1.1)) else null })
        fun momentum(axis: Int) = (0 until bed.population.size).sumOf { k ->
            bed.population.mass[k] * bed.population.velocity(axis)[k]
        }
        val before = DoubleArray(3) { momentum(it) }
        repeat(100) { bed.advance() }
        val mass = bed.population.mass.sum()
        for (axis in 0..2) {
            val ofWalls = bed.walls.impulse(2 * axis) - bed.walls.impulse(2 * axis + 1)
            val gained = momentum(axis) - before[axis] - mass * pull[axis] * bed.simulation.time
            assertEquals(gained, ofWalls, 1e-9) { "axis $axis" }
            assertTrue(bed.walls.impulse(2 * axis) > 0.0 && bed.walls.impulse(2 * axis + 1) > 0.0)
        }
    }

    @Test
    fun `sums that are saved go on with the same bits`() {
        val whole = bed(faces)
        val first = bed(faces)
        repeat(20) {
            whole.advance()
            first.advance()
        }
        val state = OutputState("walls")
        first.walls.save(state)
        val second = WallStatistics().apply { restore(state) }
        repeat(20) {
            whole.advance()
            first.simulation.advance()
            second.write(first.simulation)
        }
        assertEquals(whole.walls.count, second.count)
        val sums = { s: WallStatistics -> (0 until WallContact.FACES).map { s.impulse(it) } + s.given }
        assertEquals(sums(whole.walls), sums(second))
    }

    @Test
    fun `walls that rest are not recorded`() {
        val bed = bed(List(6) { null })
        repeat(20) { bed.advance() }
        assertTrue(bed.simulation.collisions!!.counters.wallCollisions > 50)
        assertEquals(0L, bed.walls.count)
    }
}
