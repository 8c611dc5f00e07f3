package daphnis.core.format

import java.io.IOException
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.function.Consumer

/**
 * Writes files so that under their names stands what was there or what is new, and nothing half done, whatever ends the
 * program. Until then it is in `NAME.part` beside the file. A link to a file, or to nothing, is replaced and its target
 * stays: somebody else may have put it there. What is no file, such as a pipe, is written itself. It is not forced to
 * the disk.
 */
public object WholeFile {
    internal const val ENDING = ".part"

    /** Replaces [path] by what [write] writes to the path that it is given. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(path: Path, write: Consumer<Path>): Unit = wholeFile(path) { write.accept(it) }

    /** Replaces [path] by [bytes]. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(path: Path, bytes: ByteArray) {
        wholeFile(path) { Files.write(it, bytes) }
    }

    /** Replaces [path] by [text] in UTF-8. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(path: Path, text: String) {
        wholeFile(path) { Files.writeString(it, text) }
    }
}

/**
 * Lets [write] write under another name and renames when it is done. What was at [path] stays if a state cannot be read,
 * the disk is full or the program ends: a trajectory that ends between two states looks like a complete one. A link is
 * replaced, and what is no file, such as a pipe, is written itself.
 *
 * @throws IOException when [path] cannot be written
 */
internal inline fun <T> wholeFile(path: Path, write: (Path) -> T): T {
    if (Files.exists(path) && !Files.isRegularFile(path)) return write(path)
    val part = path.resolveSibling("${path.fileName}${WholeFile.ENDING}")
    // A link of that name, symbolic or hard, would lead what is written elsewhere.
    Files.deleteIfExists(part)
    // An interrupted program leaves nothing behind.
    if (isOnDisk(part)) part.toFile().deleteOnExit()
    try {
        return write(part).also { Files.move(part, path, ATOMIC_MOVE, REPLACE_EXISTING) }
    } catch (e: RuntimeException) {
        // A library wraps the reason, such as a full disk; restore it.
        throw generateSequence(e as Throwable) { it.cause }.firstOrNull { it is IOException } ?: e
    } finally {
        Files.deleteIfExists(part)
    }
}

/** Whether [path] is a file of the system, as `java.io.File` is, and not of a program's own file system. */
internal fun isOnDisk(path: Path): Boolean = path.fileSystem === FileSystems.getDefault()
