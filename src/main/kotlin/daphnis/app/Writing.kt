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
