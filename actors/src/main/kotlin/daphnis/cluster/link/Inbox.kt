package daphnis.cluster.link

import java.nio.ByteBuffer

/**
 * The receiving half of a link: puts chunks together in their order, and says how far it has come. Chunks out of order,
 * twice, or damaged are dropped, since the sender begins again behind the last in order. While more than
 * [LinkLimits.waiting] bytes of whole messages wait, it lets no more chunks in than it has promised already. Not safe
 * for threads: see [Link].
 */
internal class Inbox(
    private val crew: Long,
    private val from: Int,
    private val to: Int,
    private val limits: LinkLimits,
    private val wire: (LinkMessage) -> Unit,
) {
    private val whole = ArrayDeque<ByteBuffer>()
    private var waiting = 0L
    private var expected = 0L
    private var promised = limits.first

    /** The message that is put together; null between two. */
    private var part: ByteArray? = null
    private var filled = 0

    private var chunksSince = 0
    private var bytesSince = 0L
    private var owed = false

    /** Bytes of whole messages that nobody has taken. */
    val bytesWaiting: Long get() = waiting

    /** Whether a message has come. */
    val hasMessage: Boolean get() = whole.isNotEmpty()

    /**
     * Takes [chunk] on. @return whether a message is whole with it
     *
     * @throws LinkException when its place in its message is impossible
     */
    fun take(chunk: Chunk): Boolean {
        if (!chunk.isWhole) return false
        if (chunk.number != expected) {
            // Sent before its receipt came, or after a lost one.
            owed = true
            return false
        }
        val size = chunk.bytes.remaining()
        val bytes = part ?: begin(chunk)
        requirePlace(chunk, bytes, size)
        chunk.bytes.duplicate().get(bytes, filled, size)
        filled += size
        expected++
        chunksSince++
        bytesSince += size
        val isLast = filled == bytes.size
        if (isLast) finish(bytes)
        if (chunksSince >= limits.receiptAfter || bytesSince >= limits.window / 4) acknowledge()
        return isLast
    }

    /** The next message; null when none is whole. */
    fun poll(): ByteBuffer? {
        val message = whole.removeFirstOrNull() ?: return null
        val wasFull = waiting > limits.waiting
        waiting -= message.remaining()
        if (wasFull && waiting <= limits.waiting) acknowledge()
        return message
    }

    /** Sends a receipt: what has come, and what may. */
    fun acknowledge() {
        promised = maxOf(promised, expected + room())
        wire(Receipt(crew, to, from, expected, promised))
        chunksSince = 0
        bytesSince = 0
        owed = false
    }

    /** Chunks that may come, so that no more than a window stands behind the limit: at least as many as fill one. */
    private fun room(): Long {
        if (waiting > limits.waiting) return 0
        return minOf(limits.chunks.toLong(), (limits.waiting + limits.window - waiting) / limits.chunk)
    }

    /** Sends the receipt that is due. */
    fun tick() {
        if (owed || chunksSince > 0) acknowledge()
    }

    private fun begin(chunk: Chunk): ByteArray {
        if (chunk.length !in 0..limits.message) {
            throw LinkException("a message of ${chunk.length} bytes came; at most ${limits.message} are taken")
        }
        filled = 0
        return ByteArray(chunk.length).also { part = it }
    }

    private fun requirePlace(chunk: Chunk, bytes: ByteArray, size: Int) {
        val fits = chunk.length == bytes.size && chunk.offset == filled && size <= bytes.size - filled
        if (!fits || (size == 0 && bytes.isNotEmpty())) {
            val place = "${chunk.offset}+$size of ${chunk.length}"
            throw LinkException("a piece of a message came that does not fit: $place after $filled of ${bytes.size}")
        }
    }

    private fun finish(bytes: ByteArray) {
        whole.addLast(ByteBuffer.wrap(bytes))
        waiting += bytes.size
        part = null
    }
}
