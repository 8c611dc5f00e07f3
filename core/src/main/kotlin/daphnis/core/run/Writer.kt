package daphnis.core.run

/**
 * Carries out what a run writes, one piece after the other, in the order in which the run hands it over. After a
 * failure nothing further is written. One thread hands over, waits and closes.
 */
internal interface Writer : AutoCloseable {
    /** Hands over [write], which owns what it writes, [bytes] of memory. */
    fun rows(bytes: Long, write: () -> Unit)

    /**
     * Takes a [copy] of the state, of [bytes], and hands it over to [write]. [copy] is called before this returns, and
     * what it throws is passed on.
     */
    fun <S> state(bytes: Long, copy: () -> S, write: (S) -> Unit)

    /** Throws what a piece threw, if it has not been thrown before. */
    fun check()

    /** Returns when all that was handed over is written, and does [check]. */
    fun await()

    /** Ends with [await]. */
    override fun close()
}

/** Writes at once, on the thread that calls, and passes on what is thrown. */
internal object DirectWriter : Writer {
    override fun rows(bytes: Long, write: () -> Unit) = write()

    override fun <S> state(bytes: Long, copy: () -> S, write: (S) -> Unit) = write(copy())

    override fun check() = Unit

    override fun await() = Unit

    override fun close() = Unit
}
