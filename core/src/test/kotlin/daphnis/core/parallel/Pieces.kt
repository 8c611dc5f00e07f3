package daphnis.core.parallel

/** A loop in pieces of two at most, however light the work is said to be, the last first. */
internal object Pieces : RangeLoop {
    override val workers: Int get() = 1

    override fun run(size: Int, grain: Int, body: RangeBody) {
        for (from in (0 until size step 2).reversed()) body.run(0, from, minOf(from + 2, size))
    }
}
