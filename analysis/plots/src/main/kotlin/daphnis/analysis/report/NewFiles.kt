package daphnis.analysis.report

import daphnis.core.format.WholeFile
import daphnis.core.run.Links
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING

/**
 * Files that appear in [directory] all together, at [keep]: until then they are in a hidden directory in it. What was
 * there before stays as it was if that never comes, also when the program is ended by a signal.
 */
internal class NewFiles(private val directory: Path) : AutoCloseable {
    /** Where to write them. */
    val place: Path = Files.createTempDirectory(directory.also { Links.check(it, replaces = true) }, ".analysis-")

    private val hook = Thread(::clear)

    init {
        Runtime.getRuntime().addShutdownHook(hook)
    }

    /** Moves all files to the directory, each in the place of its predecessor; those in subdirectories come first. */
    @Throws(IOException::class)
    @Synchronized
    fun keep() {
        val files = Files.walk(place).use { all -> all.filter(Files::isRegularFile).toList() }
        for (file in files.sortedWith(compareByDescending<Path> { it.nameCount }.thenBy { it })) {
            val target = directory.resolve(place.relativize(file))
            Files.createDirectories(target.parent)
            try {
                Files.move(file, target, ATOMIC_MOVE, REPLACE_EXISTING)
            } catch (e: AtomicMoveNotSupportedException) {
                // A subdirectory that is a link to another disk.
                WholeFile.write(target) { Files.copy(file, it, REPLACE_EXISTING) }
            }
        }
    }

    /** Deletes what was not kept, and the directory too if there is nothing in it. */
    override fun close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (e: IllegalStateException) {
            // The hook runs already. What goes wrong because it takes the files away is not to be said.
            Thread.currentThread().join()
        }
        clear()
    }

    @Synchronized
    private fun clear() {
        // Another thread may be writing.
        for (k in 1..TRIES) {
            try {
                if (!Files.exists(place)) break
                Files.walk(place).use { all -> all.sorted(Comparator.reverseOrder()).forEach(Files::deleteIfExists) }
            } catch (e: IOException) {
                Thread.sleep(PAUSE_MILLISECONDS)
            } catch (e: UncheckedIOException) {
                Thread.sleep(PAUSE_MILLISECONDS)
            }
        }
        try {
            Files.delete(directory)
        } catch (e: IOException) {
            // There is something in it, as there should be.
        }
    }

    private companion object {
        const val TRIES = 50
        const val PAUSE_MILLISECONDS = 10L
    }
}
