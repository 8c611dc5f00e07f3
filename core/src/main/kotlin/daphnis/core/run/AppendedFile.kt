package daphnis.core.run

import java.io.RandomAccessFile
import java.nio.file.Path
import java.util.zip.CRC32C
import kotlin.io.path.name

/**
 * A table as text that only grows, line by whole line. What has gathered is written at every checkpoint, when it is
 * much, and when it has waited for a second ([flushIfDue]). On resume the file is cut back to the length that the
 * checkpoint knew, so no line is there twice. Its checksum is kept as it grows; nothing is read again.
 *
 * @param header names of the columns, separated by commas
 * @param kept the beginning to go on from, or null to begin anew
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

    /** Writes what has gathered. */
    fun flush() {
        val bytes = pending.toString().toByteArray(Charsets.UTF_8)
        file.write(bytes)
        checksum.update(bytes)
        pending.setLength(0)
        writtenAt = clock()
    }

    /** Forces everything to the disk, so that a checkpoint may count on it. @return what the file is now */
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
