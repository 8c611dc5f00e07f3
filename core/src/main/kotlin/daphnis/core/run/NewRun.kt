package daphnis.core.run

import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.format.WholeFile
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.ResolvedScenario
import daphnis.core.scenario.ScenarioJson
import java.io.IOException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * Takes a directory for a new run: one that does not exist or is empty, or with [force] one that holds a run. First
 * [claim] checks and locks, then [begin] writes. The run that was there is removed only when everything that the new
 * one needs has been written beside it. A process killed in between leaves the old run or an interrupted start. An
 * interrupted start is `scenario.json.tmp` without `scenario.json`, and may be started over. The same holds for the
 * `run.json` of a [Program].
 */
internal class NewRun(private val directory: RunDirectory, private val force: Boolean) {
    private val path = directory.path
    private val files = directory.files
    private var isMade = false

    /**
     * Locks the directory, which is created when there is none.
     *
     * @throws InputException when it is in use, holds something else, or cannot be written
     */
    fun claim(): RunLock = try {
        // Before the lock, which writes into it, since a directory that is refused must stay as it is.
        if (path.exists()) checkFree()
        make()
        locked()
    } catch (e: IOException) {
        throw InputException(path.toString(), null, "cannot be made: ${reasonOf(e, path)}")
    }

    private fun locked(): RunLock {
        val lock = try {
            RunLock.take(path)
        } catch (e: InputException) {
            // The lock file belongs to another process; a directory with one is not empty and stays.
            if (isMade) files.deleteQuietly(path)
            throw e
        }
        try {
            checkFree()
            return lock
        } catch (e: Throwable) {
            lock.close()
            throw e
        }
    }

    private fun make() {
        if (path.exists()) return
        if (Files.isSymbolicLink(path)) throw InputException(path.toString(), null, "is a link without a target")
        path.toAbsolutePath().parent?.let { Files.createDirectories(it) }
        isMade = try {
            Files.createDirectory(path)
            true
        } catch (e: FileAlreadyExistsException) {
            // Another process was quicker; the lock will tell.
            false
        }
    }

    private fun checkFree() {
        fun refuse(why: String, wayOut: WayOut? = null): Nothing =
            throw InputException(path.toString(), null, why, wayOut)
        if (!path.isDirectory()) refuse("exists and is no directory")
        if (directory.holdsRun()) {
            if (!force) refuse("exists", WayOut.REPLACE_RUN)
            checkReplaceable { refuse("cannot be replaced: $it") }
            return
        }
        if (directory.origins.any { files.besideOf(it).exists() }) return
        val others = path.listDirectoryEntries().filter { it.name !in RunLock.FILES && !isEmptyFolder(it) }
        if (others.isEmpty()) return
        if (force) refuse("is not empty and holds no run", WayOut.ONLY_RUNS_ARE_REPLACED)
        refuse("is not empty", WayOut.ANOTHER_DIRECTORY)
    }

    /** Checks that everything which [removeRun] removes can be removed, before anything is. */
    private inline fun checkReplaceable(refuse: (String) -> Nothing) {
        for (file in directory.ownFiles() + directory.origins) {
            if (Files.isDirectory(file, NOFOLLOW_LINKS)) refuse("$file is a directory")
        }
        for (part in parts()) {
            if (Files.isSymbolicLink(part)) {
                refuse("$part is a link, and its target is not touched; remove the link")
            }
            if (part.exists() && !part.isDirectory()) refuse("$part is no directory")
            if (part.exists() && !Files.isWritable(part)) refuse("$part is not writable")
        }
    }

    private fun isEmptyFolder(file: Path): Boolean =
        file in directory.folders && file.isDirectory() && file.listDirectoryEntries().isEmpty()

    private fun parts() = directory.folders + listOf(directory.plots, directory.tables)

    /**
     * Writes the files from which a run starts, and removes the run that was there. To be called with the lock that
     * [claim] returned.
     *
     * @param start the state of another run from which this one starts
     * @return [scenario] as the directory holds it: with its own copy of the particle file or of [start], so that the
     *   directory can be moved
     * @throws IOException when something cannot be written; the run that was there is as it was, unless only part of it
     *   could be removed
     */
    fun begin(scenario: ResolvedScenario, start: Snapshot? = null): ResolvedScenario {
        val original = scenario.placement.file?.path
        val copy = when {
            start != null -> Copy(directory.initial) { H5md.write(listOf(start), it, Version.text) }
            original != null -> Copy(directory.initial(Path.of(original))) {
                // Not Files.copy, which names the source when the disk of the copy is full.
                Files.newInputStream(Path.of(original)).use { from -> Files.newOutputStream(it).use(from::transferTo) }
            }
            else -> null
        }
        val resolved = if (copy == null) scenario else scenario.placedFrom(copy.path.name)
        replace(directory.scenario, ScenarioJson.write(resolved), copy)
        return resolved
    }

    /** The state from which a run starts, in its own directory. */
    private class Copy(val path: Path, val write: (Path) -> Unit)

    /** The same for a program; returns the text that the directory holds. */
    fun begin(program: ProgramRecord): String = program.text().also { replace(directory.program, it, null) }

    private fun replace(origin: Path, text: String, copy: Copy?) {
        val pending = files.besideOf(origin)
        try {
            files.writeWhole(pending) { Files.writeString(it, text) }
            if (copy != null) files.writeWhole(files.besideOf(copy.path), copy.write)
        } catch (e: IOException) {
            takeBack(pending, copy?.path)
            throw e
        }
        removeRun()
        for (folder in directory.folders) Files.createDirectories(folder)
        if (copy != null) files.move(files.besideOf(copy.path), copy.path)
        files.move(pending, origin)
        for (other in directory.origins - origin) files.deleteQuietly(files.besideOf(other))
        files.forceDirectory(path)
    }

    private fun takeBack(pending: Path, copy: Path?) {
        files.deleteQuietly(pending)
        if (copy != null) files.deleteQuietly(files.besideOf(copy))
        unmake()
    }

    /**
     * Removes a directory that was created in vain. One in which another process has started meanwhile is not empty and
     * stays.
     */
    private fun unmake() {
        if (!isMade) return
        files.deleteQuietly(path.resolve(RunLock.FILE))
        files.deleteQuietly(path)
    }

    private fun removeRun() {
        // The file that marks a run is removed first, so that a kill in between leaves nothing that looks like a
        // complete run.
        for (origin in directory.origins) if (origin.exists()) files.delete(origin)
        for (file in directory.ownFiles()) files.delete(file)
        for (part in parts()) {
            if (part.isDirectory()) for (file in part.listDirectoryEntries().filter(::isOwn)) files.delete(file)
        }
    }

    /** Whether it is a snapshot, plot or table of the run; other files beside them stay. */
    private fun isOwn(file: Path) = Files.isRegularFile(file, NOFOLLOW_LINKS) &&
        UNFINISHED.fold(file.name, String::removeSuffix).substringAfterLast('.') in OWN_ENDINGS

    private companion object {
        /** What a writer that was killed leaves behind the name of its file. */
        val UNFINISHED = listOf(".tmp", WholeFile.ENDING)
        val OWN_ENDINGS = setOf("h5", "png", "svg", "csv")
    }
}
