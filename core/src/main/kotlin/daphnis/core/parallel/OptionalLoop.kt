package daphnis.core.parallel

/**
 * A [loop] whose workers can be left out: while [isAlone], the caller's thread does everything, since a loop that is no
 * longer than its pieces runs there.
 */
internal class OptionalLoop(private val loop: RangeLoop) : RangeLoop by loop {
    /** Changed by the caller between two loops. */
    var isAlone = false

    /** How many workers take part. */
    val active: Int get() = if (isAlone) 1 else workers

    override fun run(size: Int, grain: Int, body: RangeBody) {
        loop.run(size, if (isAlone) RangeLoop.WHOLE else grain, body)
    }

    override fun run(size: Int, body: RangeBody) {
        if (isAlone) loop.run(size, RangeLoop.WHOLE, body) else loop.run(size, body)
    }

    override fun runLight(size: Int, body: RangeBody) {
        if (isAlone) loop.run(size, RangeLoop.WHOLE, body) else loop.runLight(size, body)
    }

    /** For what does not belong to the steps: only loops that are light are left to the caller's thread. */
    val forOthers: RangeLoop = object : RangeLoop by loop {
        override fun runLight(size: Int, body: RangeBody) {
            this@OptionalLoop.runLight(size, body)
        }
    }
}
