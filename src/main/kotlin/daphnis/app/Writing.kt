package daphnis.app

import daphnis.core.format.reasonOf
import daphnis.core.run.RunException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes [directory] and does [work], which writes into it.
 *
 * @throws RunException naming the directory when it cannot be made or written, as on a full disk
 */
internal inline fun <T> writing(directory: Path, work: () -> T): T = try {
    Files.createDirectories(directory)
    work()
} catch (e: IOException) {
    throw RunException("cannot write to $directory: ${reasonOf(e, directory)}")
}

/**
 * The same for [work] that takes long before it writes: that [directory] can be written is known at once.
 *
 * @throws RunException as [writing]
 */
internal inline fun <T> writingLater(directory: Path, work: () -> T): T = writing(directory) {
    Files.delete(Files.createTempFile(directory, ".daphnis", null))
    work()
}
