package daphnis.core.step

import daphnis.core.collision.PairStates
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.closingWithin
import daphnis.core.queue.EventSink
import daphnis.core.search.CellRuns

/**
 * The same as [GridCandidates] for spheres with interactions, whose pairs come to edges as well, on approach and as they
 * recede, see [PairStates.time]. Cells are as wide as the outermost edge asks for.
 */
internal class EdgeCandidates(private val step: PreparedStep, private val near: CellRuns) {
    private val rows = step.rows

    fun start(from: Int, to: Int, sink: EventSink, states: PairStates) {
        for (slot in from until to) {
            val runs = near.ahead(slot, rows.state, slot * STRIDE, step.duration)
            look(runs, rows, slot, NOBODY, sink, states)
            step.queueWalls(rows, slot, sink)
        }
    }

    fun around(own: StepRows, place: Int, except: Int, sink: EventSink, states: PairStates) {
        val p = place * STRIDE
        look(near.around(own.state, p, step.duration - own.state[p + TIME]), own, place, except, sink, states)
        step.queueWalls(own, place, sink)
    }

    private fun look(runs: Int, own: StepRows, place: Int, except: Int, sink: EventSink, states: PairStates) {
        val images = step.images
        val mine = own.state
        val theirs = rows.state
        val p = place * STRIDE
        val time = mine[p + TIME]
        val closing = closingWithin(step.duration - time, step.duration)
        val reach = states.reach * WIDER
        for (r in 0 until runs) {
            val image = near.image[r]
            val wx = images.slide(image, 0)
            val wy = images.slide(image, 1)
            val wz = images.slide(image, 2)
            val sx = images.shift(image, 0) + wx * time
            val sy = images.shift(image, 1) + wy * time
            val sz = images.shift(image, 2) + wz * time
            for (other in near.from[r] until near.to[r]) {
                if (other == except) continue
                val q = other * STRIDE
                val elapsed = time - theirs[q + TIME]
                val dx = theirs[q] + theirs[q + VX] * elapsed - mine[p] + sx
                val dy = theirs[q + 1] + theirs[q + VX + 1] * elapsed - mine[p + 1] + sy
                val dz = theirs[q + 2] + theirs[q + VX + 2] * elapsed - mine[p + 2] + sz
                val ux = theirs[q + VX] - mine[p + VX] + wx
                val uy = theirs[q + VX + 1] - mine[p + VX + 1] + wy
                val uz = theirs[q + VX + 2] - mine[p + VX + 2] + wz
                val b = dx * ux + dy * uy + dz * uz
                val d2 = dx * dx + dy * dy + dz * dz
                val contact = mine[p + RADIUS] + theirs[q + RADIUS]
                val s = contact * reach
                val c = d2 - s * s
                // Beyond all edges, and receding or too far away to come to one in time. No comparison dismisses a
                // number that is UNKNOWN.
                if (c > 0.0 && (b >= 0.0 || c > b * closing)) continue
                val state = states.of(own, place, rows, other)
                val t = time + states.wait(state, contact, d2, b, ux * ux + uy * uy + uz * uz)
                if (!(t > step.duration)) sink.add(t, place, other, image)
            }
        }
    }

    private companion object {
        const val NOBODY = -1

        /** Room for pairs that rounding has put beyond their outer edge. */
        const val WIDER = 1 + 1e-9
    }
}
