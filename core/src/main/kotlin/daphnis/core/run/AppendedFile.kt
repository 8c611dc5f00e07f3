package daphnis.core.run

import java.io.IOException
import java.io.OutputStream
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.util.zip.CRC32C

/**
 * A text table that only grows, by whole lines. Buffered lines are handed over to [writer] at every checkpoint, when
 * there are many, and when they have waited for a second ([flushIfDue]). On resume the file is cut back to the length
 * in the checkpoint, so no line is there twice. The checksum is updated as the file grows, so nothing is read again.
 *
 * @param header names and units of the columns, separated by commas; a file that is continued keeps its own units
 * @param kept the beginning to continue from, or null to start a new file
 * @param clock nanoseconds
 */
internal class AppendedFile(
    private val path: Path,
    header: String,
    kept: Beginning?,
    private val files: FileOperations,
    private val writer: Writer,
    private val clock: () -> Long = System::nanoTime,
) : AutoCloseable {
    private val file: OutputStream
    private var length = kept?.length ?: 0
    private val checksum = kept?.checksum ?: CRC32C()
    private val pending = StringBuilder()
    private var handedOverAt = clock()

    /** Blocks handed over, and those of them that [writer] has written. */
    private var handedOver = 0L
    private var written = 0L

    init {
        FileChannel.open(unlinked(path), CREATE, WRITE).use { it.truncate(length) }
        // Unlike a channel this stays open when the thread is interrupted.
        file = Files.newOutputStream(path, WRITE, APPEND)
        if (length == 0L) pending.append(header).append('\n')
    }

    fun line(): StringBuilder = pending

    /** Ends the line; hands over when much is buffered. */
    fun endLine() {
        pending.append('\n')
        if (pending.length > BLOCK) flush()
    }

    /**
     * Hands over what is buffered when the last time is a second ago. To be called between lines, after each step;
     * costs at most one reading of the clock.
     */
    fun flushIfDue() {
        if (pending.isNotEmpty() && isDue()) flush()
    }

    /** Whether the last time that lines were handed over is a second ago. */
    fun isDue(): Boolean = clock() - handedOverAt >= SECOND

    /** Hands over what is buffered. */
    fun flush() {
        handedOverAt = clock()
        if (pending.isEmpty()) return
        val bytes = bytesOf(pending)
        handOver(bytes.size.toLong()) { append(bytes) }
    }

    /**
     * Hands over [count] lines that are not yet in words. The writer makes line k with [line], from what is its own
     * from now on: [bytes] of memory.
     */
    fun handOver(bytes: Long, count: Int, line: (k: Int, line: StringBuilder) -> Unit) {
        flush()
        handOver(bytes) {
            val block = StringBuilder()
            for (k in 0 until count) {
                line(k, block)
                block.append('\n')
                if (block.length > BLOCK || k == count - 1) append(bytesOf(block))
            }
        }
    }

    private fun handOver(bytes: Long, append: () -> Unit) {
        handedOver++
        writer.rows(bytes) {
            append()
            written++
        }
    }

    /** Takes the text out of [block]. */
    private fun bytesOf(block: StringBuilder): ByteArray =
        block.toString().toByteArray(Charsets.UTF_8).also { block.setLength(0) }

    private fun append(bytes: ByteArray) {
        file.write(bytes)
        length += bytes.size
        checksum.update(bytes)
    }

    /**
     * Forces what was handed over to the disk, so that a checkpoint may rely on it. To be called by the writer.
     *
     * @return the mark of the file as it is now
     */
    fun force(): FileMark {
        files.force(path)
        return FileMark(length, checksum.value)
    }

    /** To be called when the writer is done. What is buffered is written, unless a block before it could not be. */
    override fun close() {
        file.use { if (written == handedOver) append(bytesOf(pending)) }
    }

    private companion object {
        const val BLOCK = 1 shl 16
        const val SECOND = 1_000_000_000L
    }
}

/** @throws IOException for a link, which would lead what is appended elsewhere ([Links]) */
private fun unlinked(path: Path): Path = path.also { if (Files.isSymbolicLink(it)) throw IOException("$it is a link") }
