package daphnis.core.run

import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path

/**
 * A table as text that only grows, line by whole line. What has gathered is written at every checkpoint, when it is
 * much, and when it has waited for a second ([flushIfDue]). On resume the file is cut back to the length that the
 * checkpoint knew, so no line is there twice, and goes on with the columns that it has, if an older version began it
 * with fewer.
 *
 * @param header names of the columns, separated by commas
 * @param keep the length to cut back to, or null to begin anew
 * @param clock nanoseconds
 */
internal class AppendedFile(path: Path, header: String, keep: Long?, private val clock: () -> Long = System::nanoTime) : AutoCloseable {
    private val file: RandomAccessFile
    private val pending = StringBuilder()
    private var lineStart = 0
    private var writtenAt = clock()

    /** Columns that the lines of this file have; those beyond are left out of a line. */
    private val columns: Int

    /** Whether the file has all columns of its header, and was not begun by a version with fewer. */
    val isComplete: Boolean

    init {
        val exists = keep != null && Files.exists(path) && Files.size(path) >= keep
        val old = if (exists) Files.newBufferedReader(path).use { it.readLine() } else null
        val wanted = header.split(',').size
        columns = if (old != null && header.startsWith("$old,")) old.split(',').size else wanted
        isComplete = columns == wanted
        file = RandomAccessFile(path.toFile(), "rw")
        file.setLength(if (exists) keep else 0)
        file.seek(file.length())
        if (!exists) pending.append(header).append('\n')
        lineStart = pending.length
    }

    fun line(): StringBuilder = pending

    /** Ends the line; writes when much has gathered. */
    fun endLine() {
        if (!isComplete) cut()
        pending.append('\n')
        if (pending.length > BLOCK) flush() else lineStart = pending.length
    }

    /** Leaves out of the line what lies beyond the columns of the file. */
    private fun cut() {
        var cells = 0
        for (at in lineStart until pending.length) {
            if (pending[at] == ',' && ++cells == columns) {
                pending.setLength(at)
                return
            }
        }
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
        lineStart = 0
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
