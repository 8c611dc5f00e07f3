package daphnis.core.run

import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path

/** A text file that only grows. On resume it is cut back to the length that the checkpoint knew, so no line is there twice. */
internal class AppendedFile(private val path: Path, header: String, keep: Long?) : AutoCloseable {
    private val file: RandomAccessFile
    private val pending = StringBuilder()

    init {
        val exists = keep != null && Files.exists(path) && Files.size(path) >= keep
        file = RandomAccessFile(path.toFile(), "rw")
        file.setLength(if (exists) keep else 0)
        file.seek(file.length())
        if (!exists) pending.append(header).append('\n')
    }

    fun line(): StringBuilder = pending

    /** Ends the line; writes when enough has gathered. */
    fun endLine() {
        pending.append('\n')
        if (pending.length > BLOCK) flush()
    }

    /** Writes what has gathered. @return the length of the file */
    fun flush(): Long {
        file.write(pending.toString().toByteArray(Charsets.UTF_8))
        pending.setLength(0)
        return file.filePointer
    }

    /** Forces everything to the disk, so that a checkpoint may count on it. */
    fun force(): Long = flush().also { file.fd.sync() }

    override fun close() {
        file.use { flush() }
    }

    private companion object {
        const val BLOCK = 1 shl 16
    }
}
