package daphnis.core.parallel

/**
 * The [loop] of an object that can be closed. After [close] it throws [IllegalStateException] with [message] and starts
 * nothing.
 */
public class ClosableLoop(private val loop: RangeLoop, private val message: String) : RangeLoop {
    /** Whether [close] has been called. */
    @Volatile
    public var isClosed: Boolean = false
        private set

    override val workers: Int get() = loop.workers

    override fun run(size: Int, grain: Int, body: RangeBody) {
        requireOpen()
        loop.run(size, grain, body)
    }

    override fun runLight(size: Int, body: RangeBody) {
        requireOpen()
        loop.runLight(size, body)
    }

    /** @throws IllegalStateException after [close] */
    public fun requireOpen() {
        check(!isClosed) { message }
    }

    /** Loops in progress are finished. Closing twice is allowed. */
    public fun close() {
        isClosed = true
    }
}
