package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.engine.Draws
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.search.SearchStructure.LEVELS
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

@Tag("jdk-neutral")
class GridTest {
    private class Pair(val a: Int, val b: Int, val code: Int) {
        override fun equals(other: Any?) = other is Pair && a == other.a && b == other.b && code == other.code

        override fun hashCode() = (a * 31 + b) * 31 + code

        override fun toString() = "$a-$b (${(0..2).map { Images.component(code, it) }})"
    }

    /** Seen from the lower id; two images of one sphere from the one with the positive code. */
    private fun canonical(a: Int, b: Int, code: Int) = if (a < b || (a == b && code >= Images.negated(code))) {
        Pair(a, b, code)
    } else {
        Pair(b, a, Images.negated(code))
    }

    @Test
    fun `both kinds of runs hold every pair within range, in every boundary, once`() {
        val draws = Draws.share(usual = 100, long = 100)
        for (seed in 1L..draws) {
            val random = SeededRandom(seed)
            val boundary = drawnBoundary(random, longest = 12.0)
            val p = randomSpheres(1 + random.nextInt(30), boundary, seed, 1.0) { it.nextDouble(0.1, 0.9) }
            val reach = DoubleArray(3) { random.nextDouble(0.0, 2.0) }
            compare(
                p,
                boundary,
                random.nextDouble(0.0, 20.0),
                random.nextDouble(0.0, 2.0),
                reach,
                "seed $seed, ${boundary.javaClass.simpleName}, ${p.size} spheres",
            )
        }
        assertTrue(near > 10 * draws && met > 5 * draws) {
            "$near pairs within reach, $met that meet: too few to test anything"
        }
    }

    private var near = 0
    private var met = 0

    private fun compare(
        p: Population,
        boundary: BoundaryConditions,
        time: Double,
        duration: Double,
        reach: DoubleArray,
        story: String,
    ) {
        val grid = Grid().apply { build(p, boundary, time, duration, reach) }
        assertEquals((0 until p.size).toSet(), grid.order.take(p.size).toSet()) { story }
        val runs = CellRuns(grid)
        // Ways within the reach, by index.
        val random = SeededRandom(p.size.toLong())
        val way = Array(3) { axis -> DoubleArray(p.size) { random.nextDouble(-reach[axis], reach[axis]) } }
        val forward = ArrayList<Pair>()
        val all = HashSet<Pair>()
        for (slot in 0 until p.size) {
            val k = grid.order[slot]
            fun name(other: Int) = p.id[grid.order[other]]
            val row = DoubleArray(STRIDE)
            doubleArrayOf(p.x[k], p.y[k], p.z[k]).copyInto(row)
            for (axis in 0..2) row[VX + axis] = way[axis][k]
            row[RADIUS] = p.radius[k]
            val ahead = runs.ahead(slot, row, 0, 1.0)
            each(runs, ahead) { other, code -> forward += canonical(p.id[k], name(other), code) }
            val around = runs.around(row, 0, 1.0)
            each(runs, around) { other, code -> all += Pair(p.id[k], name(other), code) }
        }
        val once = forward.filter { it.a != it.b }
        assertEquals(once.size, once.toSet().size) { "$story: a pair is named twice" }
        val found = once.toSet()
        eachImage(p, boundary) { i, j, code ->
            val apart = (0..2).map { axis -> gap(p, grid.images, i, j, code, axis, way[axis][i], duration) }
            // Whoever may be anywhere within its reach must be found from the way of the one; who goes its own way,
            // from either.
            if ((0..2).all { apart[it](reach[it], reach[it]) }) {
                near++
                assertTrue(Pair(p.id[i], p.id[j], code) in all) { "$story: ${p.id[j]} is not found from ${p.id[i]}" }
            }
            val meet = (0..2).all { axis -> apart[axis](maxOf(0.0, -way[axis][j]), maxOf(0.0, way[axis][j])) }
            if (meet) {
                met++
                assertTrue(canonical(p.id[i], p.id[j], code) in found) {
                    "$story: ${p.id[i]} and ${p.id[j]} are not found forward"
                }
            }
        }
    }

    /**
     * Whether, along [axis], sphere j, spread by so much down and up and slid by its image, comes as near as touching
     * to the way of i.
     */
    private fun gap(
        p: Population,
        images: Images,
        i: Int,
        j: Int,
        code: Int,
        axis: Int,
        way: Double,
        duration: Double,
    ): (Double, Double) -> Boolean {
        val positions = listOf(p.x, p.y, p.z)[axis]
        val from = positions[j] + images.shift(code, axis) - positions[i]
        val slide = images.slide(code, axis) * duration
        return { down, up ->
            val low = minOf(from, from + slide) - down
            val high = maxOf(from, from + slide) + up
            val s = p.radius[i] + p.radius[j]
            low - s <= maxOf(0.0, way) && high + s >= minOf(0.0, way)
        }
    }

    private inline fun each(near: CellRuns, runs: Int, action: (Int, Int) -> Unit) {
        for (r in 0 until runs) for (other in near.from[r] until near.to[r]) action(other, near.image[r])
    }

    private inline fun eachImage(p: Population, boundary: BoundaryConditions, action: (Int, Int, Int) -> Unit) {
        val codes = imagesWithin(6, boundary)
        for (i in 0 until p.size) {
            for (j in 0 until p.size) {
                if (i != j) for (code in codes) action(i, j, code)
            }
        }
    }

    @Test
    fun `far-flung spheres in open space cost no more cells than a few each`() {
        val p = randomSpheres(10, Open, 1, 1.0) { 0.1 }
        p.x[0] = 1e12
        p.y[1] = -1e9
        val grid = Grid().apply { build(p, Open, 0.0, 0.1, DoubleArray(3) { 0.1 }) }
        assertTrue(grid.cellsAlong(0).toLong() * grid.cellsAlong(1) * grid.cellsAlong(2) <= 80)
    }

    @Test
    fun `all spheres at one point fall into one cell`() {
        val p = randomSpheres(5, Open, 1, 1.0) { 0.1 }
        for (k in 0 until 5) {
            p.x[k] = 1.0
            p.y[k] = 2.0
            p.z[k] = 3.0
        }
        val grid = Grid().apply { build(p, Open, 0.0, 0.1, DoubleArray(3)) }
        val near = CellRuns(grid)
        assertEquals(1, near.aheadAt(0, 1.0, 2.0, 3.0, radius = 0.1))
        assertEquals(4, near.to[0] - near.from[0])
    }

    @Test
    fun `cells fill the box, and sight is out to the end of two ranges and a cell, by class`() {
        val box = Box.centred(10.0, 12.0, 9.0)
        for (boundary in listOf(Periodic(box), HillSheet(box, 1.0))) {
            val p = randomSpheres(60, Periodic(box), 5, 1.0) { if (it.nextInt(12) == 0) 0.9 else 0.1 }
            val grid = Grid().apply { build(p, boundary, 0.3, 0.1, DoubleArray(3) { 0.2 }, InlineLoop, LEVELS) }
            assertEquals(listOf(2, 0.1, 0.9), listOf(grid.classes, grid.largestRadius(0), grid.largestRadius(1)))
            for (axis in 0..2) {
                val widths = List(2) { grid.cellWidth(axis, it) }
                if (boundary.hasImages(axis)) {
                    for (c in 0..1) assertEquals(box.length(axis), grid.cellsAlong(axis, c) * widths[c], 1e-9)
                }
                val ranges = listOf(0.1 + 0.2, 0.9 + 0.2)
                assertEquals(2 * ranges[0] + widths[0], grid.sight(axis, 0.1, 0.1), 1e-6)
                assertEquals(2 * ranges[1] + widths[1], grid.sight(axis, 0.9, 0.9), 1e-6)
                for ((a, b) in listOf(0.1 to 0.9, 0.9 to 0.1)) {
                    assertEquals(ranges.sum() + maxOf(widths[0], widths[1]), grid.sight(axis, a, b), 1e-6)
                }
                assertEquals(ranges[1] + maxOf(ranges[0] + widths[0], ranges[1] + widths[1]), grid.sight(axis), 1e-6)
            }
        }
    }

    @Test
    fun `a sphere much larger than the cells finds all it can touch, from more rows than fit at first, each once`() {
        val box = Box.centred(10.0, 11.0, 9.0)
        for (boundary in listOf(Periodic(box), LeesEdwards(box, 0.6), Periodic(box, true, true, false))) {
            val n = 1500
            val random = SeededRandom(8)
            fun place(length: Double) = DoubleArray(n) { random.nextDouble(-length / 2, length / 2) }
            val zero = DoubleArray(n)
            val radii = DoubleArray(n) { 0.1 }
            val p = Population(place(10.0), place(11.0), place(9.0), zero, zero, zero, radii, radii)
            val grid = Grid().apply { build(p, boundary, 0.4, 0.5, DoubleArray(3) { REACH }) }
            val runs = CellRuns(grid)
            val codes = imagesWithin(1, boundary)
            for (way in listOf(0.0, 4.0)) {
                val row = DoubleArray(STRIDE)
                doubleArrayOf(3.0, -4.0, 2.0, way, -way / 2, way / 4).copyInto(row)
                row[RADIUS] = LARGE
                val count = runs.around(row, 0, 1.0)
                val found = ArrayList<Long>()
                each(runs, count) { slot, code -> found += code.toLong() * n + slot }
                assertEquals(found.size, found.toSet().size) { "a sphere is named twice" }
                val names = found.toSet()
                var touched = 0
                var cube = 0
                for (code in codes) {
                    for (slot in 0 until n) {
                        val k = grid.order[slot]
                        var isInCube = false
                        var isNear = false
                        for (m in 0..MOMENTS) {
                            fun gap(axis: Int): Double {
                                val at = p.position(axis)[k] + grid.images.shift(code, axis)
                                return maxOf(0.0, abs(at - row[axis] - row[VX + axis] * m / MOMENTS) - REACH)
                            }
                            val (a, b, c) = doubleArrayOf(gap(0), gap(1), gap(2))
                            isInCube = isInCube || maxOf(a, b, c) <= LARGE + 0.1
                            isNear = isNear || sqrt(a * a + b * b + c * c) <= LARGE + 0.1
                        }
                        if (isInCube) cube++
                        if (!isNear) continue
                        touched++
                        assertTrue(code.toLong() * n + slot in names) {
                            "$slot is not found, ${boundary.javaClass.simpleName}"
                        }
                    }
                }
                assertTrue(count > 64 && touched > 150) { "$count runs, $touched spheres" }
                if (way == 0.0) assertTrue(found.size < cube) { "${found.size} for a cube of $cube" }
            }
        }
    }

    private companion object {
        const val LARGE = 3.0
        const val REACH = 0.05
        const val MOMENTS = 10
    }
}
