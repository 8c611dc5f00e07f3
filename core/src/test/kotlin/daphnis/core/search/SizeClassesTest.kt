package daphnis.core.search

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.BruteForceEngine
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.Obstacle
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SizeClassesTest {
    private val box = Box.centred(12.0, 14.0, 10.5)

    /** Small spheres around one that is a hundred times as large, and a few between. */
    private fun moonlet(boundary: BoundaryConditions, seed: Long): Population {
        val random = SeededRandom(seed)
        val radii = DoubleArray(100) { if (it % 40 == 0) 0.6 else random.nextDouble(0.05, 0.4) }
        val p = RandomPlacement(obstacles = listOf(Obstacle(1.0, -2.0, 0.0, 5.0))).place(
            radii,
            box,
            BooleanArray(3) {
                true
            },
            random,
        )
        val n = radii.size
        fun gauss(sigma: Double) = DoubleArray(n + 1) { if (it == n) 0.0 else sigma * random.nextGaussian() }
        val vy = gauss(3.0)
        val flow = boundary.meanFlow
        if (flow != null) for (k in 0 until n) vy[k] += flow.rate * p.x[k]
        val all = radii + 5.0
        return Population(
            p.x + 1.0,
            p.y + -2.0,
            p.z + 0.0,
            gauss(3.0),
            vy,
            gauss(1.0),
            all,
            DoubleArray(n + 1) {
                all[it] *
                    all[it] *
                    all[it]
            },
        )
    }

    @Test
    fun `a search by size finds what the grid and a check of every pair find, around a sphere 100 times as large`() {
        var collisions = 0L
        for (boundary in listOf(
            Open,
            Periodic(box),
            Walls(box),
            HillSheet(box, 0.3),
            HillSheet(box, 0.3, radiallyOpen = true),
        )) {
            for (dt in listOf(0.02, 0.15)) {
                val start = moonlet(boundary, 7)
                fun simulation(engine: CollisionEngine, search: SearchStructure) = Simulation(
                    start.copy(),
                    boundary,
                    CollisionForcing(ConstantRestitution(0.7), engine = engine, search = search),
                    FixedTimeStep(dt),
                    if (boundary is HillSheet) listOf(HillFrame(0.3)) else emptyList(),
                )
                val slow = simulation(BruteForceEngine(), SearchStructure.GRID)
                val fast =
                    SearchStructure.entries.map { simulation(SerialEngine(), it) } +
                        simulation(IslandsEngine(FixedPool(2), fewest = 0), SearchStructure.LEVELS)
                repeat(14) {
                    slow.advance()
                    for (other in fast) {
                        other.advance()
                        assertEquals(stateDigest(slow.population), stateDigest(other.population)) {
                            "${boundary.javaClass.simpleName}, dt $dt, step ${slow.step}"
                        }
                    }
                }
                collisions += slow.collisions!!.counters.collisions
                fast.forEach { it.close() }
            }
        }
        assertTrue(collisions > 400) { "only $collisions collisions" }
    }

    @Test
    fun `one size makes one class, a moonlet two or more, and the grid never more than one`() {
        val boundary = Periodic(box)
        fun classes(p: Population, search: SearchStructure) =
            Grid().also { it.build(p, boundary, 0.0, 0.01, DoubleArray(3) { 0.02 }, structure = search) }.classes
        val wide = moonlet(boundary, 3)
        val equal =
            Population(wide.x, wide.y, wide.z, wide.vx, wide.vy, wide.vz, DoubleArray(wide.size) { 0.05 }, wide.mass)
        for (search in SearchStructure.entries) assertEquals(1, classes(equal, search))
        assertEquals(1, classes(wide, SearchStructure.GRID))
        assertTrue(classes(wide, SearchStructure.LEVELS) >= 2)
        assertTrue(classes(wide, SearchStructure.AUTO) >= 2)
    }
}
