package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.Images
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.setup.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

class GridTest {
    private class Pair(val a: Int, val b: Int, val code: Int) {
        override fun equals(other: Any?) = other is Pair && a == other.a && b == other.b && code == other.code

        override fun hashCode() = (a * 31 + b) * 31 + code

        override fun toString() = "$a-$b (${(0..2).map { Images.component(code, it) }})"
    }

    /** Seen from the lower id; two images of one sphere from the one with the positive code. */
    private fun canonical(a: Int, b: Int, code: Int) = if (a < b || (a == b && code >= Images.negated(code))) Pair(a, b, code) else Pair(b, a, Images.negated(code))

    @Test
    fun `both kinds of runs hold every pair within range, in every boundary, once`() {
        for (seed in 1L..150L) {
            val random = SeededRandom(seed)
            val box = Box.centred(random.nextDouble(4.0, 12.0), random.nextDouble(4.0, 12.0), random.nextDouble(2.1, 12.0))
            val boundary = listOf(Open, Periodic(box), Periodic(box, true, true, false), Walls(box), LeesEdwards(box, random.nextDouble(-1.0, 1.0)))[random.nextInt(5)]
            val p = randomSpheres(1 + random.nextInt(60), boundary, seed, 1.0) { it.nextDouble(0.1, 0.9) }
            val reach = DoubleArray(3) { random.nextDouble(0.0, 2.0) }
            compare(p, boundary, random.nextDouble(0.0, 20.0), random.nextDouble(0.0, 2.0), reach, "seed $seed, ${boundary.javaClass.simpleName}, ${p.size} spheres")
        }
    }

    private fun compare(p: Population, boundary: BoundaryConditions, time: Double, duration: Double, reach: DoubleArray, story: String) {
        val grid = Grid().apply { build(p, boundary, time, duration, reach) }
        assertEquals((0 until p.size).toSet(), grid.order.take(p.size).toSet()) { story }
        val forward = ArrayList<Pair>()
        val all = HashSet<Pair>()
        for (slot in 0 until p.size) {
            val id = p.id[grid.order[slot]]
            each(grid, grid.forwardRuns(slot)) { other, code -> forward += canonical(id, p.id[grid.order[other]], code) }
            each(grid, grid.allRuns(slot)) { other, code -> all += Pair(id, p.id[grid.order[other]], code) }
        }
        val once = forward.filter { it.a != it.b }
        assertEquals(once.size, once.toSet().size) { "$story: a pair is named twice" }
        val near = near(p, boundary, grid.images, duration, reach)
        for (pair in near) {
            assertTrue(pair in once) { "$story: $pair is not found forward" }
            assertTrue(pair in all) { "$story: $pair is not found from ${pair.a}" }
            assertTrue(Pair(pair.b, pair.a, Images.negated(pair.code)) in all) { "$story: $pair is not found from ${pair.b}" }
        }
    }

    private inline fun each(grid: Grid, runs: Int, action: (Int, Int) -> Unit) {
        for (r in 0 until runs) for (other in grid.runFrom[r] until grid.runTo[r]) action(other, grid.runImage[r])
    }

    /** Every pair and image closer along each axis than radii and reaches allow, at any time of the step. */
    private fun near(p: Population, boundary: BoundaryConditions, images: Images, duration: Double, reach: DoubleArray): List<Pair> {
        val far = IntArray(3) { if (boundary.contactFaces(it) == ContactFaces.PERIODIC) 6 else 0 }
        val found = ArrayList<Pair>()
        for (i in 0 until p.size) {
            for (j in 0 until p.size) {
                if (p.id[i] >= p.id[j]) continue
                for (x in -far[0]..far[0]) {
                    for (y in -far[1]..far[1]) {
                        for (z in -far[2]..far[2]) {
                            val code = Images.code(x, y, z)
                            val positions = listOf(p.x, p.y, p.z)
                            val close = (0..2).all { axis ->
                                val d = positions[axis][j] - positions[axis][i] + images.shift(code, axis)
                                val slide = images.slide(code, axis) * duration
                                val least = if (d * (d + slide) <= 0) 0.0 else minOf(abs(d), abs(d + slide))
                                least <= p.radius[i] + p.radius[j] + 2 * reach[axis]
                            }
                            if (close) found += Pair(p.id[i], p.id[j], code)
                        }
                    }
                }
            }
        }
        return found
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
        assertEquals(1, grid.forwardRuns(0))
        assertEquals(4, grid.runTo[0] - grid.runFrom[0])
    }
}
