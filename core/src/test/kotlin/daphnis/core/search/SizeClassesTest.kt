package daphnis.core.search

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
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
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
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

    @Tag("thorough")
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

    private class SizeClass(val spheres: Int, val largest: Double)

    /** What all searches check, by the definition: each class looks at itself and at those of larger spheres. */
    private fun cost(classes: List<SizeClass>, reach: DoubleArray, size: DoubleArray): Double {
        var sum = 0.0
        for ((k, a) in classes.withIndex()) {
            for (b in classes.drop(k)) {
                var others = if (b === a) a.spheres / 2.0 else b.spheres.toDouble()
                for (axis in 0..2) {
                    val range = 2 * (a.largest + b.largest + 2 * reach[axis])
                    if (size[axis] > 0) others *= minOf(1.0, range / size[axis])
                }
                sum += a.spheres * (12 + others)
            }
        }
        return sum
    }

    private fun classes(radii: DoubleArray, structure: SearchStructure, reach: DoubleArray, size: DoubleArray) =
        SizeClasses().also {
            val zero = DoubleArray(radii.size)
            val p = Population(zero, zero, zero, zero, zero, zero, radii, DoubleArray(radii.size) { 1.0 })
            it.divide(p, radii.minOrNull() ?: 1.0, radii.maxOrNull() ?: 0.0, structure, reach, size)
        }

    private fun SizeClasses.list() = List(count) { listOf(spheres[it], largest[it]) }

    @Test
    fun `neighbouring octaves are merged, the best two first, while that is not dearer`() {
        val seen = IntArray(8)
        for (seed in 1L..200L) {
            val random = SeededRandom(seed)
            val octaves = 2 + random.nextInt(5)
            val counts = List(octaves) { 1 + random.nextInt(if (random.nextInt(3) == 0) 3 else 400) }
            val radii = counts.flatMapIndexed { o, n -> List(n) { Math.scalb(random.nextDouble(1.0, 1.999), -o) } }
            val reach = DoubleArray(3) { random.nextDouble(0.0, 0.2) }
            val size = DoubleArray(3) { random.nextDouble(4.0, 40.0) }
            if (seed % 5 == 0L) size[2] = 0.0
            for (structure in listOf(SearchStructure.LEVELS, SearchStructure.AUTO)) {
                var wanted = radii.groupBy { Math.getExponent(it) }.toSortedMap().values.map {
                    SizeClass(it.size, it.max())
                }
                while (wanted.size > if (structure == SearchStructure.LEVELS) 2 else 1) {
                    val merged = (0 until wanted.size - 1).map { c ->
                        val both = SizeClass(wanted[c].spheres + wanted[c + 1].spheres, wanted[c + 1].largest)
                        wanted.take(c) + both + wanted.drop(c + 2)
                    }
                    val best = merged.minBy { cost(it, reach, size) }
                    if (cost(best, reach, size) > cost(wanted, reach, size)) break
                    wanted = best
                }
                val found = classes(radii.toDoubleArray(), structure, reach, size)
                assertEquals(wanted.map { listOf(it.spheres, it.largest) }, found.list()) { "seed $seed, $structure" }
                for (r in radii) assertEquals(wanted.indexOfFirst { r <= it.largest }, found.of(r)) { "radius $r" }
                if (structure == SearchStructure.AUTO) seen[wanted.size]++
            }
        }
        assertTrue((1..3).all { seen[it] > 10 }) { seen.toList().toString() }
    }

    @Test
    fun `one octave is one class, the lowest of 24 takes all smaller spheres, and nothing is one class too`() {
        val reach = DoubleArray(3)
        val size = DoubleArray(3) { 100.0 }
        for (structure in SearchStructure.entries) {
            val octave = doubleArrayOf(1.0, 1.999, 1.5)
            assertEquals(listOf(listOf(3, 1.999)), classes(octave, structure, reach, size).list())
            assertEquals(listOf(listOf(0, 0.0)), classes(doubleArrayOf(), structure, reach, size).list())
        }
        val wide = doubleArrayOf(Math.scalb(1.0, -30), 1.0, Math.scalb(1.5, -25))
        assertEquals(
            listOf(listOf(2, Math.scalb(1.5, -25)), listOf(1, 1.0)),
            classes(wide, SearchStructure.LEVELS, reach, size).list(),
        )
        assertEquals(listOf(listOf(3, 1.0)), classes(wide, SearchStructure.GRID, reach, size).list())
    }

    @Test
    fun `classes of a step know nothing of the step before`() {
        val reach = DoubleArray(3)
        val size = DoubleArray(3) { 100.0 }
        val used = classes(doubleArrayOf(0.6, 0.9, 1.2, 1.9, 3.0), SearchStructure.LEVELS, reach, size)
        val radii = doubleArrayOf(0.5, 1.0, 1.1)
        val zero = DoubleArray(3)
        used.divide(
            Population(zero, zero, zero, zero, zero, zero, radii, DoubleArray(3) { 1.0 }),
            0.5,
            1.1,
            SearchStructure.LEVELS,
            reach,
            size,
        )
        assertEquals(listOf(listOf(1, 0.5), listOf(2, 1.1)), used.list())
    }
}
