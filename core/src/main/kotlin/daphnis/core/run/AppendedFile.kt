package daphnis.core.run

import java.io.RandomAccessFile
import java.nio.file.Path
import java.util.zip.CRC32C
import kotlin.io.path.name

/**
 * A text table that only grows, by whole lines. Buffered lines are written at every checkpoint, when there are many,
 * and when they have waited for a second ([flushIfDue]). On resume the file is cut back to the length in the
 * checkpoint, so no line is there twice. The checksum is updated as the file grows, so nothing is read again.
 *
 * @param header names of the columns, separated by commas
 * @param kept the beginning to continue from, or null to start a new file
 * @param clock nanoseconds
 */
internal class AppendedFile(
    private val path: Path,
    header: String,
    kept: Beginning?,
    private val files: FileOperations,
    private val clock: () -> Long = System::nanoTime,
) : AutoCloseable {
    private val file = RandomAccessFile(path.toFile(), "rw")
    private val checksum = kept?.checksum ?: CRC32C()
    private val pending = StringBuilder()
    private var writtenAt = clock()

    init {
        file.setLength(kept?.length ?: 0)
        file.seek(file.length())
        if (file.length() == 0L) pending.append(header).append('\n')
    }

    fun line(): StringBuilder = pending

    /** Ends the line; writes when much is buffered. */
    fun endLine() {
        pending.append('\n')
        if (pending.length > BLOCK) flush()
    }

    /**
     * Writes what is buffered when the last time is a second ago. To be called between lines, after each step; costs at
     * most one reading of the clock.
     */
    fun flushIfDue() {
        if (pending.isNotEmpty() && clock() - writtenAt >= SECOND) flush()
    }

    /** Writes what is buffered. */
    fun flush() {
        val bytes = pending.toString().toByteArray(Charsets.UTF_8)
        file.write(bytes)
        checksum.update(bytes)
        pending.setLength(0)
        writtenAt = clock()
    }

    /** Forces everything to the disk, so that a checkpoint may rely on it. @return the mark of the file as it is now */
    fun force(): FileMark {
        flush()
        files.force(path.name, file.fd)
        return FileMark(file.filePointer, checksum.value)
    }

    override fun close() {
        file.use { flush() }
    }

    private companion object {
        const val BLOCK = 1 shl 16
        const val SECOND = 1_000_000_000L
    }
}
