package daphnis.cluster.link

import daphnis.core.cluster.Mail

/**
 * How much a link takes on at a time.
 *
 * @property chunk largest piece of a message, bytes
 * @property window most bytes on the way, and most chunks times [chunk] / 16, so that many short messages have room
 * @property waiting bytes of whole messages that wait for their receiver before no more are let in
 * @property message longest message, bytes
 * @property patience nanoseconds without an answer until chunks are sent again, doubled each time up to [longest]
 */
internal data class LinkLimits(
    val chunk: Int = 256 shl 10,
    val window: Int = 4 shl 20,
    val waiting: Long = 32L shl 20,
    val message: Int = Mail.LONGEST,
    val patience: Long = 300_000_000,
    val longest: Long = 5_000_000_000,
) {
    /** Most chunks on the way. */
    val chunks: Int get() = maxOf(1, window / chunk * SHORT)

    /** Chunks that may come before the first receipt. */
    val first: Long get() = minOf(chunks.toLong(), (waiting + window) / chunk)

    /** After so many chunks, or a quarter of the window, a receipt is sent at once. */
    val receiptAfter: Int get() = maxOf(1, first.toInt() / 4)

    init {
        require(chunk in 1..window) { "a chunk of $chunk bytes does not fit a window of $window bytes" }
    }

    private companion object {
        const val SHORT = 16
    }
}

/** What has come over a link cannot be part of it. */
internal class LinkException(message: String) : RuntimeException(message)
