package daphnis.core.step

import daphnis.core.boundary.ContactFaces
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.contactTime
import daphnis.core.queue.EventSink
import daphnis.core.space.Images
import kotlin.math.abs
import kotlin.math.ceil

/**
 * The contract of [Candidates] in its plainest form: asks [contactTime] for every pair and every image that the bounds
 * of the step allow. Slow; the oracle of the tests.
 */
class ExactCandidates(private val prepared: PreparedStep) : Candidates {
    private val rows = prepared.rows
    private var version = 0L
    private var codes = IntArray(0)

    override fun start(from: Int, to: Int, sink: EventSink) {
        for (slot in from until to) {
            for (other in slot + 1 until rows.size) add(rows, slot, other, sink)
            prepared.queueWalls(rows, slot, sink)
        }
    }

    override fun around(own: StepRows, place: Int, except: Int, sink: EventSink) {
        for (other in 0 until rows.size) if (other != except) add(own, place, other, sink)
        prepared.queueWalls(own, place, sink)
    }

    private fun add(own: StepRows, place: Int, other: Int, sink: EventSink) {
        for (image in codes()) {
            val t = contactTime(own.state, place * STRIDE, rows.state, other * STRIDE, image, prepared.images)
            if (!(t > prepared.duration)) sink.add(t, place, other, image)
        }
    }

    override fun view(slot: Int, viewer: Candidates.Viewer): Boolean = (0 until rows.size).all { other ->
        codes().all { viewer.look(other, it) }
    }

    /** The images that may matter in the step at hand. */
    private fun codes(): IntArray {
        if (version == prepared.version) return codes
        version = prepared.version
        val far = IntArray(3) { boxes(it) }
        prepared.step.boundary.shear?.let { shear ->
            val slid = abs(shear.velocity) * prepared.duration / prepared.step.boundary.box.length(shear.slideAxis)
            far[shear.slideAxis] += ceil(far[shear.normalAxis] * (1 + slid)).toInt()
        }
        codes = (-far[0]..far[0]).flatMap { x ->
            (-far[1]..far[1]).flatMap { y -> (-far[2]..far[2]).map { z -> Images.code(x, y, z) } }
        }.toIntArray()
        return codes
    }

    /** How many boxes away along [axis] a sphere can be met, both going as far as the bound. */
    private fun boxes(axis: Int): Int {
        val boundary = prepared.step.boundary
        if (boundary.contactFaces(axis) != ContactFaces.PERIODIC) return 0
        val largest = prepared.step.population.radius.maxOrNull() ?: 0.0
        return 1 + ceil(2 * (largest + prepared.reach.bound[axis]) / boundary.box.length(axis)).toInt()
    }
}
