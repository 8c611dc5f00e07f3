package daphnis.core.parallel

/** Runs a loop over indices in pieces. */
public interface RangeLoop {
    /** Number of workers; a body is told 0 until this. */
    public val workers: Int

    /**
     * Calls [body] for ranges that together cover `0 until size` once, from several threads at once; returns when all
     * is done. Pieces have about [grain] indices; a loop no longer than that runs on the caller's thread.
     */
    public fun run(size: Int, grain: Int = GRAIN, body: RangeBody)

    public companion object {
        /** Indices a piece: some ten microseconds of light work. */
        public const val GRAIN: Int = 2048
    }
}

/** The body of a loop over a range. */
public fun interface RangeBody {
    /**
     * Does the indices [from] until [to]; [worker] says which of the workers this is, so that each can have scratch of
     * its own.
     */
    public fun run(worker: Int, from: Int, to: Int)
}

/** The loop of who has one thread: all at once, on the caller's. */
public object InlineLoop : RangeLoop {
    override val workers: Int get() = 1

    override fun run(size: Int, grain: Int, body: RangeBody) {
        if (size > 0) body.run(0, 0, size)
    }
}
