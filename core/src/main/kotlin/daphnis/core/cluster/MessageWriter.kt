package daphnis.core.cluster

import java.nio.ByteBuffer

/** Writes a message into a buffer that grows. Big-endian. */
internal class MessageWriter(capacity: Int = INITIAL) {
    private var buffer = ByteBuffer.allocate(capacity)

    /** Bytes so far. */
    val size: Int get() = buffer.position()

    /** Makes room for [bytes] more. */
    fun room(bytes: Long): ByteBuffer {
        if (buffer.remaining() < bytes) {
            val needed = buffer.position() + bytes
            require(needed <= MOST) { "a message of $needed bytes; $MOST are possible: take more nodes" }
            val larger = ByteBuffer.allocate(maxOf(needed, minOf(buffer.capacity() * 2L, MOST)).toInt())
            buffer = larger.put(buffer.flip())
        }
        return buffer
    }

    fun byte(value: Int): MessageWriter = apply { room(1).put(value.toByte()) }

    fun int(value: Int): MessageWriter = apply { room(Int.SIZE_BYTES.toLong()).putInt(value) }

    fun long(value: Long): MessageWriter = apply { room(Long.SIZE_BYTES.toLong()).putLong(value) }

    fun double(value: Double): MessageWriter = apply { room(Double.SIZE_BYTES.toLong()).putDouble(value) }

    /** Text of any length. */
    fun text(value: String): MessageWriter = apply {
        val bytes = value.toByteArray(Charsets.UTF_8)
        int(bytes.size)
        room(bytes.size.toLong()).put(bytes)
    }

    /** Entries [from] until [to] of [values], without their number. */
    fun doubles(values: DoubleArray, from: Int = 0, to: Int = values.size): MessageWriter = apply {
        val bytes = (to - from).toLong() * Double.SIZE_BYTES
        val room = room(bytes)
        room.asDoubleBuffer().put(values, from, to - from)
        room.position(room.position() + bytes.toInt())
    }

    /** The same. */
    fun ints(values: IntArray, from: Int = 0, to: Int = values.size): MessageWriter = apply {
        val bytes = (to - from).toLong() * Int.SIZE_BYTES
        val room = room(bytes)
        room.asIntBuffer().put(values, from, to - from)
        room.position(room.position() + bytes.toInt())
    }

    /** All that remains in [bytes], without its length; [bytes] stays as it is. */
    fun bytes(bytes: ByteBuffer): MessageWriter = apply { room(bytes.remaining().toLong()).put(bytes.duplicate()) }

    /** What [write] puts into a buffer, at most [most] bytes. */
    inline fun put(most: Int, write: (ByteBuffer) -> Unit): MessageWriter = apply { write(room(most.toLong())) }

    /** What was written. The writer is not to be used any more. */
    fun message(): ByteBuffer = buffer.flip()

    private companion object {
        const val INITIAL = 256
        const val MOST = Mail.LONGEST.toLong()
    }
}

/** The next [count] doubles. */
internal fun ByteBuffer.doubles(count: Int): DoubleArray = DoubleArray(count).also { doubles(count, it, 0) }

/** The same, to entries [at] and following of [into]. */
internal fun ByteBuffer.doubles(count: Int, into: DoubleArray, at: Int) {
    asDoubleBuffer().get(into, at, count)
    position(position() + count * Double.SIZE_BYTES)
}

/** The next [count] ints. */
internal fun ByteBuffer.ints(count: Int): IntArray = IntArray(count).also { ints(count, it, 0) }

/** The same, to entries [at] and following of [into]. */
internal fun ByteBuffer.ints(count: Int, into: IntArray, at: Int) {
    asIntBuffer().get(into, at, count)
    position(position() + count * Int.SIZE_BYTES)
}

/** The next text. */
internal fun ByteBuffer.text(): String {
    val bytes = ByteArray(int)
    get(bytes)
    return String(bytes, Charsets.UTF_8)
}
