package daphnis.app.live

import daphnis.core.format.FormatException
import daphnis.core.input.InputException
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** States by their numbers, as [StateBytes] makes them. Any thread may call. */
internal fun interface StateSource {
    /**
     * The state [number]; null where there is none.
     *
     * @throws FormatException when it is damaged
     * @throws InputException when it cannot be read
     */
    fun bytes(number: Long): ByteArray?

    companion object {
        val NONE = StateSource { null }
    }
}

/** Why there is no state, in one line. */
internal fun inWords(e: Throwable): String = e.message ?: e.javaClass.simpleName

/**
 * The newest state of a run that goes on; those before it are given up. All fields are guarded by [lock].
 */
internal class NewestState : StateSource {
    private val lock = ReentrantLock()
    private val asked = lock.newCondition()
    private var number = -1L
    private var bytes: ByteArray? = null
    private var timesAsked = 0

    fun put(number: Long, bytes: ByteArray): Unit = lock.withLock {
        this.number = number
        this.bytes = bytes
        timesAsked = 0
    }

    override fun bytes(number: Long): ByteArray? = lock.withLock {
        if (number != this.number) return null
        timesAsked++
        asked.signalAll()
        bytes
    }

    /** Waits until it, if there is one, has been asked for so many [times], at most [milliseconds]. */
    fun awaitAsked(times: Int, milliseconds: Long): Unit = lock.withLock {
        var left = TimeUnit.MILLISECONDS.toNanos(milliseconds)
        while (bytes != null && timesAsked < times && left > 0) left = asked.awaitNanos(left)
    }
}
