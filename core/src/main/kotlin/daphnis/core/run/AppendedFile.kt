package daphnis.core.run

import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path

/**
 * A table as text that only grows, line by whole line. What has gathered is written at every checkpoint, when it is
 * much, and when it has waited for a second ([flushIfDue]). On resume the file is cut back to the length that the
 * checkpoint knew, so no line is there twice.
 *
 * @param header names of the columns, separated by commas
 * @param keep the length to cut back to, or null to begin anew
 * @param clock nanoseconds
 */
internal class AppendedFile(path: Path, header: String, keep: Long?, private val clock: () -> Long = System::nanoTime) : AutoCloseable {
    private val file: RandomAccessFile
    private val pending = StringBuilder()
    private var writtenAt = clock()

    init {
        val exists = keep != null && Files.exists(path) && Files.size(path) >= keep
        file = RandomAccessFile(path.toFile(), "rw")
        file.setLength(if (exists) keep else 0)
        file.seek(file.length())
        if (!exists) pending.append(header).append('\n')
    }

    fun line(): StringBuilder = pending

    /** Ends the line; writes when much has gathered. */
    fun endLine() {
        pending.append('\n')
        if (pending.length > BLOCK) flush()
    }

    /**
     * Writes what has gathered when the last time is a second ago. To be called between lines, after each step; costs a
     * look at the clock at most.
     */
    fun flushIfDue() {
        if (pending.isNotEmpty() && clock() - writtenAt >= SECOND) flush()
    }

    /** Writes what has gathered. @return the length of the file */
    fun flush(): Long {
        file.write(pending.toString().toByteArray(Charsets.UTF_8))
        pending.setLength(0)
        writtenAt = clock()
        return file.filePointer
    }

    /** Forces everything to the disk, so that a checkpoint may count on it. */
    fun force(): Long = flush().also { file.fd.sync() }

    override fun close() {
        file.use { flush() }
    }

    private companion object {
        const val BLOCK = 1 shl 16
        const val SECOND = 1_000_000_000L
    }
}
