package daphnis.core.parallel

/** Runs a loop over indices in pieces. */
public interface RangeLoop {
    /** Number of workers; a body gets a worker in `0 until workers`. */
    public val workers: Int

    /**
     * Calls [body] for ranges that together cover `0 until size` once, from several threads at once; returns when all
     * are done. Pieces have about [grain] indices; a loop no longer than that runs on the caller's thread.
     */
    public fun run(size: Int, grain: Int, body: RangeBody)

    /** The same in pieces of about [GRAIN] indices. */
    public fun run(size: Int, body: RangeBody) {
        run(size, GRAIN, body)
    }

    /**
     * The same for a loop of some nanoseconds an index, which threads share only where it is worth waking them: from
     * some thousand indices on.
     */
    public fun runLight(size: Int, body: RangeBody) {
        run(size, if (size <= FEW) FEW else GRAIN, body)
    }

    public companion object {
        /** Indices per piece: some ten microseconds of work. */
        public const val GRAIN: Int = 2048

        /** Indices per piece of a loop that is one piece, whatever its size. */
        internal const val WHOLE: Int = Int.MAX_VALUE

        /** Indices of a light loop which takes as long as it takes to begin it on several threads. */
        internal const val FEW: Int = 4 * GRAIN

        /** [InlineLoop], for Java. */
        @JvmStatic
        public fun inline(): RangeLoop = InlineLoop
    }
}

/**
 * Calls [use] with pieces of the range [from] until [to] which are small enough to stay in the cache while several
 * things are done with them.
 */
internal inline fun forEachPiece(from: Int, to: Int, use: (first: Int, end: Int) -> Unit) {
    var first = from
    while (first < to) {
        val end = minOf(first + RangeLoop.GRAIN, to)
        use(first, end)
        first = end
    }
}

/** The body of a loop over a range. */
public fun interface RangeBody {
    /**
     * Processes the indices [from] until [to]. [worker] is the number of this worker, so that each can have its own
     * scratch arrays.
     */
    public fun run(worker: Int, from: Int, to: Int)
}

/** A loop on one thread, the caller's: one piece, all indices. */
public object InlineLoop : RangeLoop {
    override val workers: Int get() = 1

    override fun run(size: Int, grain: Int, body: RangeBody) {
        if (size > 0) body.run(0, 0, size)
    }
}
