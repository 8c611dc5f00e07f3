package daphnis.core.run

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption

/**
 * The operations on files of which starts, checkpoints and snapshots consist. A process may be killed between any two
 * of them; tests do that in [begin].
 */
internal open class FileOperations {
    /** Called before each operation. */
    protected open fun begin(operation: String) = Unit

    /** What does the operations of a run; tests take another. */
    open fun writer(): Writer = WriterThread()

    fun write(path: Path, write: (Path) -> Unit) {
        begin("write ${path.fileName}")
        write(path)
    }

    /** Forces the contents of [path] to the disk. */
    fun force(path: Path) {
        begin("force ${path.fileName}")
        FileChannel.open(path, StandardOpenOption.WRITE).use { it.force(true) }
    }

    /** Renames, and replaces [to] when it exists: a reader sees the old file or the new one. */
    fun move(from: Path, to: Path) {
        begin("move ${from.fileName} to ${to.fileName}")
        Files.move(from, to, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING)
    }

    fun delete(path: Path) {
        begin("delete ${path.fileName}")
        Files.deleteIfExists(path)
    }

    /** Forces renames in [directory] to the disk, where the system can. */
    fun forceDirectory(directory: Path) {
        begin("force ${directory.fileName}")
        try {
            FileChannel.open(directory, StandardOpenOption.READ).use { it.force(true) }
        } catch (e: IOException) {
            // Not every system can open directories; the rename itself has happened.
        }
    }

    /**
     * Writes a file and forces it to the disk.
     *
     * @throws IOException when it cannot be written, for example on a full disk; nothing is left of it then
     */
    fun writeWhole(path: Path, write: (Path) -> Unit) {
        try {
            // Somebody may have put a link there since the directory was looked at ([Links]), or a hard one before.
            if (Files.exists(path, NOFOLLOW_LINKS)) Files.delete(path)
            write(path, write)
            force(path)
        } catch (e: IOException) {
            deleteQuietly(path)
            throw e
        } catch (e: RuntimeException) {
            // Libraries wrap the reason, such as a full disk; restore it.
            deleteQuietly(path)
            throw generateSequence(e as Throwable) { it.cause }.firstOrNull { it is IOException } ?: e
        }
    }

    /**
     * Writes a file under another name, forces it to the disk and renames it, so that a reader sees the complete old
     * file or the complete new one.
     *
     * @throws IOException when it cannot be written; the old file is untouched then
     */
    fun writeAtomically(path: Path, write: (Path) -> Unit) {
        val beside = besideOf(path)
        writeWhole(beside, write)
        try {
            move(beside, path)
        } catch (e: IOException) {
            deleteQuietly(beside)
            throw e
        }
    }

    /** Makes [directory] where there is none. @throws IOException when no file can be written into it */
    fun requireWritable(directory: Path) {
        Files.createDirectories(directory)
        Files.delete(Files.createTempFile(directory, ".daphnis", null))
    }

    /** The path at which [path] is written before it is renamed. */
    fun besideOf(path: Path): Path = path.resolveSibling("${path.fileName}.tmp")

    fun deleteQuietly(path: Path) {
        try {
            Files.deleteIfExists(path)
        } catch (e: IOException) {
            // Only the error that led here matters.
        }
    }
}
