package daphnis.core.parallel

/**
 * The [loop] of somebody who can be closed, after which it throws [IllegalStateException] with [message] and starts
 * nothing.
 */
internal class ClosableLoop(private val loop: RangeLoop, private val message: String) : RangeLoop {
    @Volatile
    var isClosed = false
        private set

    override val workers: Int get() = loop.workers

    override fun run(size: Int, grain: Int, body: RangeBody) {
        requireOpen()
        loop.run(size, grain, body)
    }

    /** @throws IllegalStateException after [close] */
    fun requireOpen() {
        check(!isClosed) { message }
    }

    /** Loops under way are finished. Closing twice is allowed. */
    fun close() {
        isClosed = true
    }
}
