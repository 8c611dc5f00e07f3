package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.run.CollisionStatistics
import daphnis.core.run.WallStatistics
import daphnis.core.surface.ConstantRestitution
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallMotion
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Gases between walls: under gravity, at a piston, and between thermal walls. The equation of state is that of Carnahan
 * & Starling (1969, J. Chem. Phys. 51, 635): Z = (1 + φ + φ² − φ³)/(1 − φ)³.
 */
class DrivenWallsTest {
    private fun gas(count: Int, box: Box, walled: BooleanArray, seed: Long): Population {
        val random = SeededRandom(seed)
        val radii = DoubleArray(count) { RADIUS }
        val places = RandomPlacement().place(radii, box, walled, random)
        fun gauss() = DoubleArray(count) { random.nextGaussian() }
        return Population(places.x, places.y, places.z, gauss(), gauss(), gauss(), radii, DoubleArray(count) { 1.0 })
    }

    private fun energy(p: Population) = (0 until p.size).sumOf {
        0.5 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it])
    }

    private fun z(filling: Double) = (1 + filling + filling * filling - filling * filling * filling) /
        (1 - filling).let { it * it * it }

    @Test
    fun `a gas at a slow piston follows the adiabat of its equation of state`() {
        val edge = 8.5
        val count = 200
        val box = Box.centred(edge, edge, 24.0)
        val p = gas(count, box, booleanArrayOf(false, false, true), 1)
        val speed = -0.02
        val walls = Walls(
            box,
            1.0,
            booleanArrayOf(false, false, true),
            faces = List(6) { if (it == 5) WallFace(motion = WallMotion.Steady(speed)) else null },
        )
        val simulation = Simulation(p, walls, CollisionForcing(ConstantRestitution(1.0)), FixedTimeStep(0.5))
        val before = energy(p)
        while (simulation.time < 500) simulation.advance()
        // d ln T = −(2/3) Z d ln V, V the volume in which centres can be.
        var expected = 0.0
        val parts = 1000
        for (k in 0 until parts) {
            val length = 24.0 + speed * 500 * (k + 0.5) / parts
            val filling = count * 4.0 / 3 * Math.PI * RADIUS * RADIUS * RADIUS / (edge * edge * (length - 2 * RADIUS))
            expected += 2.0 / 3 * z(filling) * -speed * 500 / parts / (length - 2 * RADIUS)
        }
        val measured = Math.log(energy(p) / before)
        assertTrue(measured > 0.4)
        // Beside walls the gas is denser than elsewhere.
        assertEquals(1.0, measured / expected, 0.03) { "$measured for $expected" }
    }

    @Test
    fun `a gas between thermal walls takes their temperature`() {
        val temperature = 2.5
        val box = Box.centred(8.0, 8.0, 8.0)
        val means = (1L..4L).map { seed ->
            val p = gas(60, box, BooleanArray(3) { true }, seed)
            val walls = Walls(box, faces = List(6) { WallFace(temperature = temperature) }, seed = seed)
            val simulation = Simulation(p, walls, CollisionForcing(ConstantRestitution(1.0)), FixedTimeStep(0.5))
            while (simulation.time < 30) simulation.advance()
            var sum = 0.0
            repeat(250) {
                simulation.advance()
                sum += energy(p) / (1.5 * p.size)
            }
            sum / 250
        }
        val mean = means.average()
        val error = sqrt(means.sumOf { (it - mean) * (it - mean) } / 3 / 4)
        assertTrue(error < 0.1) { "error $error" }
        assertTrue(abs(mean - temperature) < 4 * error + 0.005) { "$mean ± $error" }
    }

    @Test
    fun `an elastic gas under gravity has the profile of its equation of state`() {
        val edge = 10.0
        val count = 250
        val gravity = 0.25
        val height = 60.0
        val box = Box(0.0, 0.0, 0.0, edge, edge, height)
        val walled = booleanArrayOf(false, false, true)
        val p = gas(count, Box(0.0, 0.0, 0.0, edge, edge, 20.0), walled, 2)
        val walls = Walls(box, 1.0, walled)
        val forces = listOf(UniformAcceleration(0.0, 0.0, -gravity))
        val simulation = Simulation(p, walls, CollisionForcing(ConstantRestitution(1.0)), FixedTimeStep(0.5), forces)
        while (simulation.time < 100) simulation.advance()
        val blocks = List(BLOCKS) { DoubleArray(20) }
        var thermal = 0.0
        for (block in blocks) {
            repeat(SAMPLES) {
                simulation.advance()
                for (z in p.z) if (z < 20) block[z.toInt()] += 1.0 / SAMPLES
                thermal += energy(p) / (1.5 * count) / (SAMPLES * BLOCKS)
            }
        }
        val expected = profile(thermal, gravity, count / (edge * edge), height.toInt())
        // Without the layers at the floor.
        for (k in 4 until 20) {
            val mean = blocks.sumOf { it[k] } / BLOCKS
            val error = sqrt(blocks.sumOf { (it[k] - mean) * (it[k] - mean) } / (BLOCKS * (BLOCKS - 1)))
            val theory = expected[k] * edge * edge
            assertTrue(error < 0.08 * theory) { "from $k: error $error of $theory" }
            assertTrue(abs(mean - theory) < 4 * error + 0.01 * theory) { "from $k: $mean ± $error, expected $theory" }
            // The ideal gas is elsewhere.
            if (k > 4) continue
            val ideal = count * gravity / thermal * Math.exp(-gravity * 4.0 / thermal)
            assertTrue(abs(mean - ideal) > 8 * error) { "$mean ± $error and $ideal" }
        }
    }

    /** Number per area in layers of thickness 1 above the lowest centres, by dp/dz = −n g with p = n T Z. */
    private fun profile(t: Double, g: Double, column: Double, layers: Int): DoubleArray {
        val volume = 4.0 / 3 * Math.PI * RADIUS * RADIUS * RADIUS
        fun pressure(n: Double) = n * t * z(n * volume)
        val fine = 100
        fun from(floor: Double): DoubleArray {
            val sums = DoubleArray(layers)
            var n = floor
            for (k in (RADIUS * fine).toInt() until layers * fine) {
                sums[k / fine] += n / fine
                val slope = (pressure(n * 1.0001) - pressure(n)) / (n * 0.0001)
                n -= n * g / slope / fine
            }
            return sums
        }
        var low = 0.0
        var high = 0.9
        repeat(60) {
            val middle = (low + high) / 2
            if (from(middle).sum() < column) low = middle else high = middle
        }
        return from(low)
    }

    @Test
    fun `a vibrated bed takes from its floor what its collisions take`() {
        val box = Box(0.0, 0.0, 0.0, 6.0, 6.0, 60.0)
        val walled = booleanArrayOf(false, false, true)
        val floor = WallFace(motion = WallMotion.Sine(0.3, 1.0))
        val walls = Walls(box, 1.0, walled, faces = List(6) { if (it == 4) floor else null })
        val balances = (1L..4L).map { seed ->
            val p = gas(100, Box(0.0, 0.0, 0.0, 6.0, 6.0, 15.0), walled, seed)
            val forcing = CollisionForcing(ConstantRestitution(0.95), recordCollisions = true)
            val forces = listOf(UniformAcceleration(0.0, 0.0, -1.0))
            val simulation = Simulation(p, walls, forcing, FixedTimeStep(0.1), forces)
            while (simulation.time < 40) simulation.advance()
            val given = WallStatistics()
            val taken = CollisionStatistics()
            while (simulation.time < 100) {
                simulation.advance()
                given.write(simulation)
                taken.write(simulation)
            }
            given.given / taken.dissipated
        }
        val mean = balances.average()
        val error = sqrt(balances.sumOf { (it - mean) * (it - mean) } / 3 / 4)
        assertTrue(error < 0.02) { "error $error" }
        assertTrue(abs(mean - 1) < 4 * error + 0.002) { "$mean ± $error" }
    }

    private companion object {
        const val RADIUS = 0.5
        const val BLOCKS = 10
        const val SAMPLES = 100
    }
}
