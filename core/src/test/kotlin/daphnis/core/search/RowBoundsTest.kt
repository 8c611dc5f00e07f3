package daphnis.core.search

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.randomSpheres
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs

class RowBoundsTest {
    @Tag("thorough")
    @Test
    fun `close bounds name everybody who is met on straight ways, and after a third of them has changed course`() {
        var met = 0
        for (seed in 1L..120L) {
            val random = SeededRandom(seed)
            val boundary = drawnBoundary(random, longest = 14.0)
            val p = randomSpheres(2 + random.nextInt(40), boundary, seed, 1.0) { it.nextDouble(0.1, 0.9) }
            // A mean flow on top, which close bounds follow.
            for (k in 0 until p.size) p.vx[k] += 2 * p.y[k] / 10
            val duration = random.nextDouble(0.1, 1.5)
            val reach = Reach().apply { measure(p, boundary, duration) }
            val grid = Grid().apply { build(p, boundary, random.nextDouble(0.0, 9.0), duration, reach.bound) }
            val rows = StepRows().apply { load(p, grid.order, duration, false) }
            val bounds = RowBounds().apply { measure(grid, rows, duration, InlineLoop, fewest = 0.0) }
            val near = CellRuns(grid, bounds)
            val codes = imagesWithin(3, boundary)
            val story = "seed $seed, ${boundary.javaClass.simpleName}, ${p.size} spheres"

            val named = HashSet<Triple<Int, Int, Int>>()
            for (i in 0 until p.size) for (hit in query(near, rows, i, 0.0, duration, ahead = true)) named += hit
            for (i in 0 until p.size) {
                for (j in i + 1 until p.size) {
                    for (code in codes) {
                        if (!meet(rows, grid.images, i, j, code, 0.0, duration)) continue
                        met++
                        assertTrue(Triple(i, j, code) in named || Triple(j, i, Images.negated(code)) in named) {
                            "$story: $i and $j are not found from the start"
                        }
                    }
                }
            }

            val now = duration * random.nextDouble(0.2, 0.8)
            val changed = (0 until p.size).filter { random.nextInt(3) == 0 }
            for (i in changed) {
                for (axis in 0..2) {
                    rows.state[i * STRIDE + axis] += rows.state[i * STRIDE + VX + axis] * now
                    rows.state[i * STRIDE + VX + axis] = random.nextDouble(-reach.speed[axis], reach.speed[axis])
                }
                rows.state[i * STRIDE + TIME] = now
                bounds.include(i, rows, i)
            }
            for (i in changed) {
                val around = query(near, rows, i, now, duration, ahead = false).toSet()
                for (j in 0 until p.size) {
                    if (j == i) continue
                    for (code in codes) {
                        if (!meet(rows, grid.images, i, j, code, now, duration)) continue
                        met++
                        assertTrue(Triple(i, j, code) in around) {
                            "$story: $j is not found from $i after it changed course"
                        }
                    }
                }
            }
        }
        assertTrue(met > 2000) { "only $met meetings" }
    }

    /** Row of [slot] among those of a grid of one class, from its cells. */
    private fun rowOf(grid: Grid, slot: Int): Int {
        val cells = grid.levels[0].cells
        return (0 until cells[0] * cells[1] * cells[2]).first { grid.cellStart[it + 1] > slot } / cells[0]
    }

    @Test
    fun `bounds are the least and greatest velocities of the spheres of each row, and grow by what is included`() {
        for (seed in 1L..10L) {
            val boundary = Periodic(Box.centred(10.0, 12.0, 8.0))
            val p = randomSpheres(60, boundary, seed, 1.0) { 0.5 }
            val grid = Grid().apply { build(p, boundary, 0.0, 0.5, DoubleArray(3) { 0.5 }) }
            val rows = StepRows().apply { load(p, grid.order, 0.5, false) }
            val bounds = RowBounds().apply { measure(grid, rows, 0.5, InlineLoop, fewest = 0.0) }
            assertTrue(bounds.isInUse)
            assertEquals(0.5, bounds.duration)
            // Rows lie along x, then z, then y.
            val axes = listOf(0, 2, 1)
            fun velocity(slot: Int, k: Int) = rows.state[slot * STRIDE + VX + axes[k]]
            val members = (0 until 60).groupBy { rowOf(grid, it) }
            val wanted = DoubleArray(grid.levels.rowCount * RowBounds.WIDTH) {
                if (it % 2 == 0) Double.POSITIVE_INFINITY else Double.NEGATIVE_INFINITY
            }
            fun widen(row: Int, slot: Int) {
                for (k in 0..2) {
                    val at = row * RowBounds.WIDTH + 2 * k
                    wanted[at] = minOf(wanted[at], velocity(slot, k))
                    wanted[at + 1] = maxOf(wanted[at + 1], velocity(slot, k))
                }
            }
            for ((row, slots) in members) for (slot in slots) widen(row, slot)
            assertEquals(wanted.toList(), bounds.values.take(wanted.size)) { "seed $seed" }
            val random = SeededRandom(seed)
            for (slot in 0 until 60 step 3) {
                for (k in 0..2) rows.state[slot * STRIDE + VX + k] = random.nextDouble(-4.0, 4.0)
                bounds.include(slot, rows, slot)
                widen(rowOf(grid, slot), slot)
            }
            assertEquals(wanted.toList(), bounds.values.take(wanted.size)) { "seed $seed, included" }
        }
    }

    @Test
    fun `bounds are used from the given number of candidates on, and not while there are no rows`() {
        val boundary = Periodic(Box.centred(10.0, 12.0, 8.0))
        val p = randomSpheres(60, boundary, 1, 1.0) { 0.5 }
        val grid = Grid().apply { build(p, boundary, 0.0, 0.5, DoubleArray(3) { 0.5 }) }
        val rows = StepRows().apply { load(p, grid.order, 0.5, false) }
        // 60 spheres spread over the box; a search covers both ranges and a cell along each axis.
        val candidates = (0..2).fold(60.0) { n, axis ->
            n * minOf(1.0, (2 * (0.5 + 0.5) + grid.cellWidth(axis)) / boundary.box.length(axis))
        }
        assertEquals(candidates, grid.levels.candidates(), 1e-6)
        val bounds = RowBounds()
        for ((fewest, isInUse) in listOf(candidates - 1e-3 to true, candidates + 1e-3 to false)) {
            bounds.measure(grid, rows, 0.5, InlineLoop, fewest)
            assertEquals(isInUse, bounds.isInUse)
        }
        bounds.measure(grid, rows, 0.5, InlineLoop, 0.0)
        val before = bounds.values.copyOf()
        bounds.rest()
        assertFalse(bounds.isInUse)
        rows.state[VX] = 100.0
        bounds.include(0, rows, 0)
        assertArrayEquals(before, bounds.values)
    }

    private fun query(
        near: CellRuns,
        rows: StepRows,
        i: Int,
        now: Double,
        duration: Double,
        ahead: Boolean,
    ): List<Triple<Int, Int, Int>> {
        val p = i * STRIDE
        val runs = if (ahead) near.ahead(i, rows.state, p, duration) else near.around(rows.state, p, duration - now)
        return (0 until runs).flatMap { r -> (near.from[r] until near.to[r]).map { Triple(i, it, near.image[r]) } }
    }

    /** Whether the cubes around two spheres overlap at any of many moments from [now] to [end]. */
    private fun meet(rows: StepRows, images: Images, i: Int, j: Int, code: Int, now: Double, end: Double): Boolean {
        val s = rows.state
        val touch = s[i * STRIDE + RADIUS] + s[j * STRIDE + RADIUS]
        return (0..MOMENTS).any { m ->
            val t = now + (end - now) * m / MOMENTS
            (0..2).all { axis ->
                fun at(k: Int) = s[k * STRIDE + axis] + s[k * STRIDE + VX + axis] * (t - s[k * STRIDE + TIME])
                abs(at(j) + images.shift(code, axis) + images.slide(code, axis) * t - at(i)) <= touch
            }
        }
    }

    private companion object {
        const val MOMENTS = 20
    }
}
