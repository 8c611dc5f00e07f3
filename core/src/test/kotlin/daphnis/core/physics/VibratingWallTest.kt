package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallMotion
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/** Steps of many cycles of a wall, or of many bounces, change nothing: contacts within a step are exact. */
class VibratingWallTest {
    /** Small spheres, far apart, between [lower] and a wall at rest above it. */
    private fun simulation(seed: Long, lower: WallFace, dt: Double, restitution: Double, gravity: Double): Simulation {
        val random = SeededRandom(seed)
        fun drawn(draw: () -> Double) = DoubleArray(COUNT) { draw() }
        val along = DoubleArray(COUNT)
        val p = Population(
            DoubleArray(COUNT) { it + 0.5 },
            along.clone(),
            drawn { random.nextDouble(0.2, 0.8) },
            along.clone(),
            along.clone(),
            drawn { 0.1 * random.nextGaussian() },
            drawn { RADIUS },
            drawn { 1.0 },
        )
        val box = Box(0.0, -1.0, 0.0, COUNT.toDouble(), 1.0, 1.0)
        val walled = booleanArrayOf(false, false, true)
        val faces = List(6) { if (it == 4) lower else null }
        val forces = if (gravity == 0.0) emptyList() else listOf(UniformAcceleration(0.0, 0.0, -gravity))
        val walls = Walls(box, restitution, walled, faces = faces)
        return Simulation(p, walls, CollisionForcing(ConstantRestitution(1.0)), FixedTimeStep(dt), forces)
    }

    /** The mean square of the velocity along z, at the [times]; of four seeds, with its error. */
    private fun squares(times: IntRange, lower: WallFace, dt: Double, e: Double, gravity: Double = 0.0): DoubleArray {
        val means = (1L..4L).map { seed ->
            val simulation = simulation(seed, lower, dt, e, gravity)
            var sum = 0.0
            for (time in times) {
                while (simulation.time < time - dt / 2) simulation.advance()
                sum += simulation.population.vz.sumOf { it * it } / COUNT
            }
            sum / times.count()
        }
        val mean = means.average()
        return doubleArrayOf(mean, sqrt(means.sumOf { (it - mean) * (it - mean) } / 12))
    }

    @Test
    fun `a gas at a wall that vibrates has one temperature, whether steps are short or of ten cycles`() {
        val shaken = WallFace(motion = WallMotion.Sine(0.02, 10.0))
        for (e in listOf(0.9, 1.0)) {
            val (fine, error) = squares(5..14, shaken, 0.01, e)
            val (long, other) = squares(5..14, shaken, 1.0, e)
            assertTrue(error < 0.1 * fine && other < 0.1 * fine) { "$e: $fine ± $error, $long ± $other" }
            assertTrue(abs(long - fine) < 4 * sqrt(error * error + other * other)) {
                "restitution $e: $fine ± $error in short steps, $long ± $other in long ones"
            }
        }
    }

    @Test
    fun `grains come to rest in steps of many bounces too`() {
        val simulation = simulation(1, WallFace(), 5.0, 0.5, 1.0)
        repeat(4) { simulation.advance() }
        val square = simulation.population.vz.sumOf { it * it } / COUNT
        // They hop with √(g r)/16 at the floor.
        assertTrue(square < RADIUS / 256 / 3 * 1.3) { "$square" }
    }

    @Test
    fun `a cold thermal wall under gravity is as cold in long steps`() {
        val cold = WallFace(temperature = 1e-4)
        val (fine, error) = squares(6..9, cold, 0.1, 0.5, 1.0)
        val (long, other) = squares(6..9, cold, 1.0, 0.5, 1.0)
        assertTrue(abs(long - 1e-4) < 4 * other && abs(fine - 1e-4) < 4 * error) { "$fine ± $error, $long ± $other" }
    }

    private companion object {
        const val COUNT = 100
        const val RADIUS = 0.01
    }
}
