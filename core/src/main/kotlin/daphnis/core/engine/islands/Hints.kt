package daphnis.core.engine.islands

import daphnis.core.queue.EventSink
import daphnis.core.queue.EventStore
import daphnis.core.queue.EventStore.Companion.NONE

/**
 * The potential collisions that one worker has found and that lie beyond the present window, by slices of time. A hint
 * says that a pair may touch at a time; whether it still will is decided when its slice comes, by computing the contact
 * time again. The same bits mean that neither sphere has changed since. So no hint ever has to be removed.
 *
 * Each slice is a linked list in the [store], newest first. Written and read by one worker at a time.
 */
internal class Hints : EventSink {
    /** All hints of the step; the link of one leads to the next of its slice. */
    val store = EventStore()
    private val heads = IntArray(SLICES)
    private val counts = IntArray(SLICES)
    private var duration = 0.0
    private var slicesPerTime = 0.0
    private var most = 0L

    /** Removes all, for a step of [duration] with at most as many hints as [limits] allow. */
    fun reset(duration: Double, limits: IslandLimits) {
        this.duration = duration
        most = limits.hints
        slicesPerTime = SLICES / duration
        store.clear()
        heads.fill(NONE)
        counts.fill(0)
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        if (store.size >= most) throw IslandsTooLargeException("potential collisions to come", most)
        val slice = sliceOf(time)
        val e = store.size
        store.add(time, first, second, image)
        store.link(e, heads[slice])
        heads[slice] = e
        counts[slice]++
    }

    /** Number of hints in [slice]. */
    fun count(slice: Int): Int = counts[slice]

    /** The first hint of [slice], −1 when there is none. */
    fun head(slice: Int): Int = heads[slice]

    private fun sliceOf(time: Double): Int {
        var slice = (time * slicesPerTime).toInt().coerceIn(0, SLICES - 1)
        while (slice > 0 && time <= endOf(slice - 1, duration)) slice--
        while (slice < SLICES - 1 && time > endOf(slice, duration)) slice++
        return slice
    }

    companion object {
        /** Slices per step; a window is one or more of them. */
        const val SLICES = 256

        /** Last moment of [slice] in a step of [duration]. */
        fun endOf(slice: Int, duration: Double): Double = if (slice == SLICES - 1) {
            duration
        } else {
            (slice + 1) * (duration / SLICES)
        }
    }
}
