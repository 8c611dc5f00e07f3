package daphnis.analysis.report

import daphnis.core.format.WholeFile
import daphnis.core.input.InputException
import daphnis.core.run.Links
import daphnis.core.run.RunLock
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import kotlin.io.path.name

/**
 * Files that appear in [directory], which is made where there is none, all together, at [keep]: until then they are in a
 * hidden directory in it. Those that were kept there before and are not among them go then: the file [LIST] says which.
 * What was there before stays as it was if that never comes, also when the program is ended by a signal. A process that is killed
 * leaves its hidden directory, and the next one takes it away: a [RunLock] on each says whether somebody writes there.
 */
internal class NewFiles(private val directory: Path) : AutoCloseable {
    private val lock: RunLock

    /** Where to write them. */
    val place: Path

    private val hook = Thread(::clear)

    init {
        Files.createDirectories(directory)
        Links.check(directory, replaces = true)
        sweep()
        val (path, held) = make()
        place = path
        lock = held
        Runtime.getRuntime().addShutdownHook(hook)
    }

    /** Deletes what killed processes have left. Each is locked meanwhile: a process that has just made it makes another. */
    private fun sweep() {
        val found = Files.newDirectoryStream(directory, "$PREFIX*").use { it.toList() }
        for (path in found.filter { Files.isDirectory(it, NOFOLLOW_LINKS) }) {
            try {
                RunLock.take(path).use { isDeleted(path) }
                deleteEmpty(path)
            } catch (e: InputException) {
                // Somebody writes there, or it is not ours to delete.
            }
        }
    }

    private fun make(): Pair<Path, RunLock> {
        for (k in 1..TRIES) {
            val path = Files.createTempDirectory(directory, PREFIX)
            try {
                val held = RunLock.take(path)
                if (Files.exists(path)) return path to held
                held.close()
            } catch (e: InputException) {
                isDeleted(path)
                if (k == TRIES) throw e
            }
        }
        throw IOException("directories whose names begin with $PREFIX vanish as soon as they are made")
    }

    /**
     * Moves all files to the directory, each in the place of its predecessor; those in subdirectories come first. What
     * was kept before and is not among them is deleted.
     */
    @Throws(IOException::class)
    @Synchronized
    fun keep() {
        val files = Files.walk(place).use { all -> all.filter(Files::isRegularFile).toList() }
            .filter { "${place.relativize(it)}" !in RunLock.FILES }
        // With / on every system, as a directory may be read on another one than that which wrote it.
        val names = files.map { place.relativize(it).joinToString("/") }.sorted()
        val old = listed() - names.toSet()
        // Both, in case this process is killed on the way.
        list(names + old)
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
        for (name in old) Files.deleteIfExists(directory.resolve(name))
        list(names)
    }

    /** Files in the directory that were kept there before. A line that leads elsewhere is nothing we wrote. */
    private fun listed(): List<String> {
        val list = directory.resolve(LIST)
        if (!Files.isRegularFile(list, NOFOLLOW_LINKS)) return emptyList()
        return Files.readAllLines(list).filter { name ->
            val path = directory.resolve(name).normalize()
            name.isNotEmpty() && path.startsWith(directory.normalize()) && Files.isRegularFile(path, NOFOLLOW_LINKS)
        }
    }

    private fun list(names: List<String>) {
        WholeFile.write(directory.resolve(LIST), names.joinToString("\n", postfix = "\n"))
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

    /** Deletes [path] with all that is in it, unless something else is written there or deletes it at the same time. */
    private fun isDeleted(path: Path): Boolean = try {
        if (Files.exists(path)) {
            Files.walk(path).use { all -> all.sorted(Comparator.reverseOrder()).forEach(Files::deleteIfExists) }
        }
        true
    } catch (e: IOException) {
        false
    } catch (e: UncheckedIOException) {
        false
    }

    @Synchronized
    private fun clear() {
        // Another thread may be writing.
        for (k in 1..TRIES) {
            if (isDeleted(place) || hasLockOnly(place)) break
            Thread.sleep(PAUSE_MILLISECONDS)
        }
        lock.close()
        deleteEmpty(place)
        deleteEmpty(directory)
    }

    /** Windows keeps a file that is deleted until it is closed. */
    private fun hasLockOnly(path: Path): Boolean = try {
        Files.list(path).use { all -> all.allMatch { it.name in RunLock.FILES } }
    } catch (e: IOException) {
        false
    }

    private fun deleteEmpty(path: Path) {
        try {
            Files.deleteIfExists(path)
        } catch (e: IOException) {
            // There is something in it: in the directory as there should be.
        }
    }

    companion object {
        /** Name of the file with the names of those that were kept, a line each. */
        const val LIST = ".report-files"
        private const val PREFIX = ".analysis-"
        private const val TRIES = 50
        private const val PAUSE_MILLISECONDS = 10L
    }
}
