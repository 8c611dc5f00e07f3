package daphnis.core.run

import java.io.FileDescriptor
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption

/**
 * The operations on files that starts, checkpoints and snapshots consist of. A process may be killed between any two of
 * them; [begin] is where a test does that.
 */
internal open class FileOperations {
    /** Called before each operation. */
    protected open fun begin(operation: String) = Unit

    fun write(path: Path, write: (Path) -> Unit) {
        begin("write ${path.fileName}")
        write(path)
    }

    /** Forces the contents of [path] to the disk. */
    fun force(path: Path) {
        begin("force ${path.fileName}")
        FileChannel.open(path, StandardOpenOption.WRITE).use { it.force(true) }
    }

    /** Forces an open file to the disk. */
    fun force(name: String, file: FileDescriptor) {
        begin("force $name")
        file.sync()
    }

    /** Renames, over [to] when it exists: whoever looks sees the old file or the new one. */
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
            // Not every system opens directories; the rename itself has happened.
        }
    }

    /**
     * Writes a file and forces it to the disk.
     *
     * @throws IOException when it cannot be written, a full disk for one; nothing is left of it then
     */
    fun writeWhole(path: Path, write: (Path) -> Unit) {
        try {
            write(path, write)
            force(path)
        } catch (e: IOException) {
            deleteQuietly(path)
            throw e
        } catch (e: RuntimeException) {
            // Libraries wrap the reason, such as a full disk; give it back its name.
            deleteQuietly(path)
            throw generateSequence(e as Throwable) { it.cause }.firstOrNull { it is IOException } ?: e
        }
    }

    /**
     * Writes a file beside its place, forces it to the disk and renames it, so that whoever looks sees the old file or
     * the new one, whole.
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

    /** Where [path] is written before it takes its place. */
    fun besideOf(path: Path): Path = path.resolveSibling("${path.fileName}.tmp")

    fun deleteQuietly(path: Path) {
        try {
            Files.deleteIfExists(path)
        } catch (e: IOException) {
            // What matters is the error that led here.
        }
    }
}
