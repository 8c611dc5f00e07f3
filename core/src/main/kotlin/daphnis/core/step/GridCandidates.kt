package daphnis.core.step

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.closingWithin
import daphnis.core.collision.ifApproaching
import daphnis.core.collision.waitUntilContact
import daphnis.core.queue.EventSink
import daphnis.core.search.CellRuns

/**
 * The fast [Candidates], over the runs of slots that the grid gives. Computes exactly
 * [daphnis.core.collision.contactTime], term by term, without the terms that are known: at the start all local times
 * are 0, and a sphere that has just collided is the later of any pair.
 */
internal class GridCandidates(private val step: PreparedStep) : Candidates {
    private val rows = step.rows
    private val near = CellRuns(step.grid, step.bounds)
    private val atEdges = EdgeCandidates(step, near)

    override fun start(from: Int, to: Int, sink: EventSink) {
        step.states?.let { return atEdges.start(from, to, sink, it) }
        for (slot in from until to) {
            startFrom(slot, sink)
            step.queueWalls(rows, slot, sink)
        }
    }

    private fun startFrom(slot: Int, sink: EventSink) {
        val state = rows.state
        val p = slot * STRIDE
        val runs = near.ahead(slot, state, p, step.duration)
        forEachApproaching(runs, state, p, 0.0, hasMoved = false) { other, image, a, b, c ->
            addIfInTime(sink, 0.0, slot, other, image, a, b, c)
        }
    }

    override fun around(own: StepRows, place: Int, except: Int, sink: EventSink) {
        step.states?.let { return atEdges.around(own, place, except, sink, it) }
        val state = own.state
        val p = place * STRIDE
        val time = state[p + TIME]
        val runs = runsAround(state, p)
        // The sphere itself is in one of the runs; with itself b is 0, or unknown.
        forEachApproaching(runs, state, p, time, hasMoved = true) { other, image, a, b, c ->
            if (other != except) addIfInTime(sink, time, place, other, image, a, b, c)
        }
        step.queueWalls(own, place, sink)
    }

    private fun runsAround(own: DoubleArray, p: Int): Int = near.around(own, p, step.duration - own[p + TIME])

    /**
     * Calls [found] for each sphere in the first [runs] of [near] that the sphere in the row at [p] of [own], at
     * [time], approaches fast enough. At the start, when no sphere [hasMoved], other spheres are at the positions in
     * their rows. Inlined twice with a constant for [hasMoved], of which the compiler keeps one branch.
     */
    private inline fun forEachApproaching(
        runs: Int,
        own: DoubleArray,
        p: Int,
        time: Double,
        hasMoved: Boolean,
        found: (other: Int, image: Int, a: Double, b: Double, c: Double) -> Unit,
    ) {
        val state = rows.state
        val images = step.images
        val closing = closingWithin(step.duration - time, step.duration)
        val x = own[p]
        val y = own[p + 1]
        val z = own[p + 2]
        val vx = own[p + VX]
        val vy = own[p + VX + 1]
        val vz = own[p + VX + 2]
        val radius = own[p + RADIUS]
        for (r in 0 until runs) {
            val image = near.image[r]
            val wx = images.slide(image, 0)
            val wy = images.slide(image, 1)
            val wz = images.slide(image, 2)
            val sx = images.shift(image, 0) + wx * time
            val sy = images.shift(image, 1) + wy * time
            val sz = images.shift(image, 2) + wz * time
            var q = near.from[r] * STRIDE
            val end = near.to[r] * STRIDE
            while (q < end) {
                val vqx = state[q + VX]
                val vqy = state[q + VX + 1]
                val vqz = state[q + VX + 2]
                val elapsed = if (hasMoved) time - state[q + TIME] else 0.0
                val dx = (if (hasMoved) state[q] + vqx * elapsed else state[q]) - x + sx
                val dy = (if (hasMoved) state[q + 1] + vqy * elapsed else state[q + 1]) - y + sy
                val dz = (if (hasMoved) state[q + 2] + vqz * elapsed else state[q + 2]) - z + sz
                val s = radius + state[q + RADIUS]
                ifApproaching(dx, dy, dz, vqx - vx + wx, vqy - vy + wy, vqz - vz + wz, s, closing) { a, b, c ->
                    found(q / STRIDE, image, a, b, c)
                }
                q += STRIDE
            }
        }
    }

    /** For the few candidates that are near and approach. No comparison dismisses a time that is [StepRows.UNKNOWN]. */
    private fun addIfInTime(
        sink: EventSink,
        time: Double,
        place: Int,
        other: Int,
        image: Int,
        a: Double,
        b: Double,
        c: Double,
    ) {
        val t = time + waitUntilContact(a, b, c)
        if (!(t > step.duration)) sink.add(t, place, other, image)
    }

    override fun view(slot: Int, viewer: Candidates.Viewer): Boolean {
        val runs = runsAround(rows.state, slot * STRIDE)
        for (r in 0 until runs) {
            for (other in near.from[r] until near.to[r]) if (!viewer.look(other, near.image[r])) return false
        }
        return true
    }
}
