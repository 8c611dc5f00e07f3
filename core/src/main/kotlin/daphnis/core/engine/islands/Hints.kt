package daphnis.core.engine.islands

import daphnis.core.queue.EventSink

/**
 * The potential collisions that one worker has found and that lie beyond the window at hand, by slices of time. A hint
 * says that a pair may touch at a time; whether it still will is asked when its slice comes, by computing the contact
 * time again: the same bits mean that neither sphere has changed since. So nothing has ever to be removed.
 *
 * Each slice is a linked list, newest first. Written and read by one worker at a time.
 */
internal class Hints : EventSink {
    /** Three longs a hint: time as bits | first, second | image, next of the slice. */
    private var store = LongArray(INITIAL * WIDTH)
    private var size = 0
    private val heads = IntArray(SLICES)
    private val counts = IntArray(SLICES)
    private var duration = 0.0
    private var slicesPerTime = 0.0
    private var most = 0L

    /** Forgets all, for a step of [duration] with so many hints as [limits] say. */
    fun reset(duration: Double, limits: IslandLimits) {
        this.duration = duration
        most = limits.hints
        slicesPerTime = SLICES / duration
        size = 0
        heads.fill(NONE)
        counts.fill(0)
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        if ((size + 1) * WIDTH > store.size) grow()
        val slice = sliceOf(time)
        val p = size * WIDTH
        store[p] = time.toRawBits()
        store[p + 1] = (first.toLong() shl 32) or (second.toLong() and LOW)
        store[p + 2] = (image.toLong() shl 32) or (heads[slice].toLong() and LOW)
        heads[slice] = size++
        counts[slice]++
    }

    private fun grow() {
        if (size >= most) throw IslandsTooLargeException("potential collisions to come", most)
        store = store.copyOf(store.size * 2)
    }

    /** Number of hints in [slice]. */
    fun count(slice: Int): Int = counts[slice]

    /** The first hint of [slice], −1 when there is none. */
    fun head(slice: Int): Int = heads[slice]

    fun next(hint: Int): Int = store[hint * WIDTH + 2].toInt()

    fun time(hint: Int): Double = Double.fromBits(store[hint * WIDTH])

    fun first(hint: Int): Int = (store[hint * WIDTH + 1] shr 32).toInt()

    fun second(hint: Int): Int = store[hint * WIDTH + 1].toInt()

    fun image(hint: Int): Int = (store[hint * WIDTH + 2] shr 32).toInt()

    private fun sliceOf(time: Double): Int {
        var slice = (time * slicesPerTime).toInt().coerceIn(0, SLICES - 1)
        while (slice > 0 && time <= endOf(slice - 1, duration)) slice--
        while (slice < SLICES - 1 && time > endOf(slice, duration)) slice++
        return slice
    }

    companion object {
        /** Slices a step; a window is one or more of them. */
        const val SLICES = 256
        private const val NONE = -1
        private const val INITIAL = 1024
        private const val WIDTH = 3
        private const val LOW = 0xffffffffL

        /** Last moment of [slice] in a step of [duration]. */
        fun endOf(slice: Int, duration: Double): Double = if (slice == SLICES - 1) {
            duration
        } else {
            (slice + 1) * (duration / SLICES)
        }
    }
}
