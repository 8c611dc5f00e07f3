package daphnis.core.engine

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.queue.EventSink
import daphnis.core.search.CellRuns
import daphnis.core.search.Grid
import daphnis.core.search.RowBounds
import kotlin.math.sqrt

/**
 * The two searches of a step, over the runs of slots that the grid names. Both compute exactly
 * [daphnis.core.collision.contactTime], term for term, with what is known left out: at the start all local times are 0,
 * and a sphere that has just collided is the later of any pair. `SerialEngineTest` holds the engine against one that
 * calls that function, by digest.
 *
 * Nine of ten candidates are dismissed without a square root and with one well-predicted branch. For c > 0 the contact
 * comes c / (√(b² − ac) − b) from now, which is not before c / (−2b), so a contact within a time τ has c ≤ −2bτ; in the
 * same floating-point numbers this holds with τ larger by a few units of rounding, for which [ROUNDING] leaves ample
 * room.
 */
internal class NeighbourSearch(
    private val rows: StepRows,
    private val grid: Grid,
    private val queue: EventSink,
    bounds: RowBounds? = null,
) {
    private val near = CellRuns(grid, bounds)
    private var duration = 0.0

    /** For a step of [duration]. */
    fun prepare(duration: Double) {
        this.duration = duration
    }

    /**
     * Queues every potential collision there is before anybody has moved, each from that of its slots which comes first
     * in the grid; slots [from] until [to].
     */
    fun queueStart(from: Int = 0, to: Int = rows.size) {
        for (slot in from until to) queueForward(slot)
    }

    private fun queueForward(slot: Int) {
        val state = rows.state
        val images = grid.images
        val closing = -2.0 * duration * (1.0 + ROUNDING)
        val p = slot * STRIDE
        val x = state[p]
        val y = state[p + 1]
        val z = state[p + 2]
        val vx = state[p + VX]
        val vy = state[p + VX + 1]
        val vz = state[p + VX + 2]
        val radius = state[p + RADIUS]
        val runs = near.ahead(slot, x, y, z, vx * duration, vy * duration, vz * duration, radius)
        for (r in 0 until runs) {
            val image = near.image[r]
            val sx = images.shift(image, 0)
            val sy = images.shift(image, 1)
            val sz = images.shift(image, 2)
            val wx = images.slide(image, 0)
            val wy = images.slide(image, 1)
            var q = near.from[r] * STRIDE
            val end = near.to[r] * STRIDE
            while (q < end) {
                val ux = state[q + VX] - vx + wx
                val uy = state[q + VX + 1] - vy + wy
                val uz = state[q + VX + 2] - vz
                val dx = state[q] - x + sx
                val dy = state[q + 1] - y + sy
                val dz = state[q + 2] - z + sz
                val b = dx * ux + dy * uy + dz * uz
                val s = radius + state[q + RADIUS]
                val c = dx * dx + dy * dy + dz * dz - s * s
                if (c <= b * closing && b < 0.0) {
                    queueIfInTime(slot, q / STRIDE, image, 0.0, b, c, ux * ux + uy * uy + uz * uz)
                }
                q += STRIDE
            }
        }
    }

    /** Queues the potential collisions of [slot], whose local time is [time], with everybody but [except]. */
    fun queueAll(slot: Int, time: Double, except: Int) {
        val state = rows.state
        val images = grid.images
        val closing = -2.0 * (duration - time + duration * ROUNDING)
        val p = slot * STRIDE
        val x = state[p]
        val y = state[p + 1]
        val z = state[p + 2]
        val vx = state[p + VX]
        val vy = state[p + VX + 1]
        val vz = state[p + VX + 2]
        val radius = state[p + RADIUS]
        val rest = duration - time
        val runs = near.around(x, y, z, vx * rest, vy * rest, vz * rest, radius, time)
        val exceptRow = except * STRIDE
        for (r in 0 until runs) {
            val image = near.image[r]
            val wx = images.slide(image, 0)
            val wy = images.slide(image, 1)
            val sx = images.shift(image, 0) + wx * time
            val sy = images.shift(image, 1) + wy * time
            val sz = images.shift(image, 2)
            var q = near.from[r] * STRIDE
            val end = near.to[r] * STRIDE
            while (q < end) {
                val vqx = state[q + VX]
                val vqy = state[q + VX + 1]
                val vqz = state[q + VX + 2]
                val elapsed = time - state[q + TIME]
                val ux = vqx - vx + wx
                val uy = vqy - vy + wy
                val uz = vqz - vz
                val dx = (state[q] + vqx * elapsed) - x + sx
                val dy = (state[q + 1] + vqy * elapsed) - y + sy
                val dz = (state[q + 2] + vqz * elapsed) - z + sz
                val b = dx * ux + dy * uy + dz * uz
                val s = radius + state[q + RADIUS]
                val c = dx * dx + dy * dy + dz * dz - s * s
                // The sphere itself is in one of the runs; against itself b is 0.
                if (c <= b * closing && b < 0.0 && q != exceptRow) {
                    queueIfInTime(slot, q / STRIDE, image, time, b, c, ux * ux + uy * uy + uz * uz)
                }
                q += STRIDE
            }
        }
    }

    /**
     * The rest of the contact time, for the few candidates that are near and approach: a t² + 2 b t + c = 0 with b < 0,
     * from [time] on.
     */
    private fun queueIfInTime(slot: Int, other: Int, image: Int, time: Double, b: Double, c: Double, a: Double) {
        var t = time
        if (c > 0.0) {
            val discriminant = b * b - a * c
            if (discriminant < 0.0) return
            t += c / (sqrt(discriminant) - b)
        }
        if (t <= duration) queue.add(t, slot, other, image)
    }

    private companion object {
        const val ROUNDING = 1e-12
    }
}
