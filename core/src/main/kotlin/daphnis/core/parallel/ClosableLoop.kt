package daphnis.core.parallel

/**
 * The [loop] of somebody who can be closed, after which it throws [IllegalStateException] with [message] and starts
 * nothing.
 */
internal class ClosableLoop(private val loop: RangeLoop, private val message: String) : RangeLoop {
    @Volatile
    private var closed = false

    override val workers: Int get() = loop.workers

    override fun run(size: Int, grain: Int, body: RangeBody) {
        requireOpen()
        loop.run(size, grain, body)
    }

    /** @throws IllegalStateException after [close] */
    fun requireOpen() {
        check(!closed) { message }
    }

    /** Loops under way are finished. Closing twice is allowed. */
    fun close() {
        closed = true
    }
}
