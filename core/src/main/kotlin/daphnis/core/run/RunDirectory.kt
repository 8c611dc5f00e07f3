package daphnis.core.run

import daphnis.core.format.SnapshotFormat
import daphnis.core.scenario.InputException
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.FileLock
import java.nio.channels.OverlappingFileLockException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** The files of one run and where they lie. `docs/guide.md` has the table. */
public class RunDirectory(public val path: Path) {
    public val scenario: Path get() = path.resolve("scenario.json")
    public val summary: Path get() = path.resolve("summary.json")
    public val series: Path get() = path.resolve(SERIES)
    public val collisions: Path get() = path.resolve(COLLISIONS)

    /** Moments and sums for transport coefficients; only when the scenario asks for them. */
    public val transport: Path get() = path.resolve(TRANSPORT)

    /** Distribution of impact speeds, beside [transport]. */
    public val impacts: Path get() = path.resolve("impacts.csv")
    public val snapshots: Path get() = path.resolve("snapshots")
    public val plots: Path get() = path.resolve("plots")
    public val tables: Path get() = path.resolve("tables")
    public val report: Path get() = path.resolve("report.html")

    /** Copy of the particle file a scenario started from, if it did. */
    internal fun initial(original: Path): Path = path.resolve("initial." + SnapshotFormat.of(original).extensions.first())

    internal val checkpoint: Path get() = path.resolve("checkpoint")
    internal val previousCheckpoint: Path get() = path.resolve("checkpoint.previous")

    /** The file for the snapshot after [step]. */
    public fun snapshot(step: Long): Path = snapshots.resolve("%010d.h5".format(java.util.Locale.ROOT, step))

    /** Steps that have a snapshot, ascending. */
    public fun snapshotSteps(): List<Long> =
        if (!snapshots.isDirectory()) emptyList() else snapshots.listDirectoryEntries("*.h5").mapNotNull { it.name.removeSuffix(".h5").toLongOrNull() }.sorted()

    /**
     * Makes the directory.
     *
     * @param force whether an existing run in it may be replaced
     * @throws InputException when it exists and is not empty
     */
    internal fun create(force: Boolean) {
        try {
            if (path.exists() && !path.isDirectory()) throw InputException(path.toString(), null, "exists and is no directory")
            if (path.isDirectory() && path.listDirectoryEntries().isNotEmpty()) {
                if (!force) throw InputException(path.toString(), null, "exists; give another directory with --out, or --force to replace the run in it")
                if (!scenario.exists()) throw InputException(path.toString(), null, "is not empty and holds no run; --force replaces runs only")
                removeRun()
            }
            Files.createDirectories(snapshots)
        } catch (e: IOException) {
            throw InputException(path.toString(), null, "cannot be made: ${reason(e)}")
        }
    }

    private fun removeRun() {
        // The scenario goes first: a directory without one is no run, so a kill in between leaves nothing that looks whole.
        for (file in listOf(scenario, summary, checkpoint, previousCheckpoint, series, transport, impacts, collisions, report)) Files.deleteIfExists(file)
        for (directory in listOf(snapshots, plots, tables)) {
            if (directory.isDirectory()) for (file in directory.listDirectoryEntries()) Files.deleteIfExists(file)
        }
    }

    /** @throws InputException when there is no run here */
    internal fun requireRun() {
        if (!path.isDirectory()) throw InputException(path.toString(), null, "no such directory")
        if (!scenario.exists()) throw InputException(path.toString(), null, "is no run directory: it has no scenario.json")
    }

    /** Keeps other processes from writing into the same run. @throws InputException when one already does */
    internal fun lock(): AutoCloseable {
        val channel = try {
            FileChannel.open(path.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE)
        } catch (e: IOException) {
            throw InputException(path.toString(), null, "cannot be written: ${reason(e)}")
        }
        val lock: FileLock? = try {
            channel.tryLock()
        } catch (e: OverlappingFileLockException) {
            null
        } catch (e: IOException) {
            // Some file systems know no locks; then nobody is kept out.
            return channel
        }
        if (lock == null) {
            channel.close()
            throw InputException(path.toString(), null, "another process is running in this directory")
        }
        return AutoCloseable {
            lock.close()
            channel.close()
            Files.deleteIfExists(path.resolve(LOCK))
        }
    }

    internal companion object {
        const val SERIES = "series.csv"
        const val TRANSPORT = "transport.csv"
        const val COLLISIONS = "collisions.csv"
        private const val LOCK = ".lock"

        fun reason(e: IOException): String = if (e is FileSystemException) e.reason ?: e.javaClass.simpleName else e.message ?: e.javaClass.simpleName
    }
}
