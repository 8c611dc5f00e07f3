package daphnis.core.wall

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI

/** A kind of wall that no file of the program knows, the inside of a [ConeWall], as a gas, engines, volumes and placements see it. */
class ConeWallTest {
    private val box = Box.centred(12.0, 12.0, 6.0)
    private val cones = listOf(
        ConeWall(listOf(0.0, 0.0, -3.0), listOf(0.0, 0.0, 2.0), 0.9),
        ConeWall(listOf(0.0, 0.0, 3.0), listOf(0.0, 0.0, -1.0), 0.9),
        ConeWall(listOf(-4.0, 1.0, -2.0), listOf(1.0, 0.3, 0.5), 0.6),
    )

    private fun gas(walls: Walls): Population {
        val random = SeededRandom(7)
        val radii = DoubleArray(COUNT) { random.nextDouble(0.1, 0.2) }
        val all = booleanArrayOf(true, true, true)
        val places = RandomPlacement().within(walls.walls.surfaces).place(radii, box, all, random)
        fun gauss() = DoubleArray(COUNT) { random.nextGaussian() }
        return Population(places.x, places.y, places.z, gauss(), gauss(), gauss(), radii, DoubleArray(COUNT) { 1.0 })
    }

    private fun energy(p: Population, g: Double) = (0 until p.size).sumOf {
        0.5 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) + g * p.z[it]
    }

    /** The state after some steps, and the impacts on walls. */
    private fun run(cone: ConeWall, g: Double, engine: CollisionEngine): Pair<String, Long> {
        val walls = Walls(box, surfaces = listOf(cone))
        val p = gas(walls)
        val before = energy(p, g)
        val forces = if (g == 0.0) emptyList() else listOf(UniformAcceleration(0.0, 0.0, -g))
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine)
        Simulation(p, walls, forcing, FixedTimeStep(0.2), forces).use { simulation ->
            repeat(STEPS) {
                simulation.advance()
                for (k in 0 until p.size) {
                    assertTrue(cone.distance(p.x[k], p.y[k], p.z[k]) > p.radius[k] * (1 - 1e-9)) { "$cone, $g" }
                }
            }
        }
        assertEquals(before, energy(p, g), 1e-9 * COUNT) { "$cone, $g" }
        return stateDigest(p) to forcing.counters.wallCollisions
    }

    @Test
    fun `a gas stays in it, keeps its energy, and is the same in every engine`() {
        for (cone in cones) {
            for (g in listOf(0.0, 1.5)) {
                val (serial, impacts) = run(cone, g, SerialEngine())
                assertTrue(impacts > 10 * COUNT) { "$impacts" }
                assertEquals(
                    serial,
                    run(cone, g, HorizonEngine(FixedPool(1), fewest = 0, tuning = HorizonTuning(3))).first,
                ) {
                    "$cone, $g"
                }
                assertEquals(serial, run(cone, g, IslandsEngine(FixedPool(2), fewest = 0)).first) { "$cone, $g" }
            }
        }
    }

    @Test
    fun `the room is what it cuts off`() {
        for (cone in cones.take(2)) {
            // At the end it is 5.4 wide, and the box 6.
            assertEquals(PI * 0.81 * 72, Walls(box, surfaces = listOf(cone)).volume, 0.1)
        }
    }

    private companion object {
        const val COUNT = 60
        const val STEPS = 150
    }
}
