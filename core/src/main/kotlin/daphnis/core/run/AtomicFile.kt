package daphnis.core.run

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption

/**
 * Writes a file beside its place, forces it to the disk and renames it, so that whoever looks sees the old file or the new one, whole.
 *
 * @throws IOException when it cannot be written, a full disk for one; the old file is untouched then
 */
internal fun writeAtomically(path: Path, write: (Path) -> Unit) {
    val beside = path.resolveSibling("${path.fileName}.tmp")
    try {
        write(beside)
        FileChannel.open(beside, StandardOpenOption.WRITE).use { it.force(true) }
        Files.move(beside, path, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING)
    } catch (e: IOException) {
        deleteQuietly(beside)
        throw e
    } catch (e: RuntimeException) {
        // Libraries wrap the reason, such as a full disk; give it back its name.
        deleteQuietly(beside)
        throw generateSequence(e as Throwable) { it.cause }.firstOrNull { it is IOException } ?: e
    }
}

/** Forces renames in [directory] to the disk, where the system can. */
internal fun forceDirectory(directory: Path) {
    try {
        FileChannel.open(directory, StandardOpenOption.READ).use { it.force(true) }
    } catch (e: IOException) {
        // Not every system opens directories; the rename itself has happened.
    }
}

private fun deleteQuietly(path: Path) {
    try {
        Files.deleteIfExists(path)
    } catch (e: IOException) {
        // What matters is the error that led here.
    }
}
