package daphnis.core.search

import daphnis.core.boundary.Images
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

class RowBoundsTest {
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
