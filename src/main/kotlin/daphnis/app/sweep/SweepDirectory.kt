package daphnis.app.sweep

import daphnis.core.input.InputException
import daphnis.core.run.RunLock
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** The files of a sweep and where they are. */
internal class SweepDirectory(val path: Path) {
    val means: Path get() = path.resolve("sweep.csv")
    val text: Path get() = path.resolve("sweep.md")
    val runs: Path get() = path.resolve("runs.csv")
    val plots: Path get() = path.resolve("plots")
    private val record: Path get() = path.resolve("sweep.json")

    /** The directory of the run called [name]. */
    fun run(name: String): Path = allRuns.resolve(name)

    /** Whether any have begun. */
    val hasRuns: Boolean get() = Files.isDirectory(allRuns)
    private val allRuns: Path get() = path.resolve("runs")

    /** Why the last try of the run called [name] failed, in a line; null when it did not. */
    fun failure(name: String): String? = try {
        Files.readString(failures.resolve(name)).trim()
    } catch (e: IOException) {
        null
    }

    /** Notes [why] the run called [name] failed, for [failure]; null when it is tried again. */
    fun noteFailure(name: String, why: String?) {
        try {
            if (why == null) {
                Files.deleteIfExists(failures.resolve(name))
            } else {
                Files.writeString(Files.createDirectories(failures).resolve(name), "$why\n")
            }
        } catch (e: IOException) {
            // A full disk may be why it failed; the note is no more than a help.
        }
    }

    private val failures: Path get() = path.resolve("failures")

    /**
     * Takes the directory, new or with the same sweep in it, until the lock is closed.
     *
     * @param mayHaveRuns whether there may be runs without a record, made one by one
     * @throws InputException when it holds something else, or a sweep of which [mine] is not the record, or another
     *   process works in it; it is as it was then
     */
    fun claim(mine: SweepRecord, mayHaveRuns: Boolean = false): RunLock {
        check(mine, mayHaveRuns)
        Files.createDirectories(path)
        val lock = RunLock.take(path)
        try {
            check(mine, mayHaveRuns)
            if (!Files.exists(record)) mine.write(record)
            return lock
        } catch (e: Throwable) {
            lock.use { throw e }
        }
    }

    /**
     * Makes the directory that of the sweep of [mine], where it is not yet. Other processes may do so at the same time,
     * and work in it.
     *
     * @throws InputException as [claim], but for other processes
     */
    fun join(mine: SweepRecord) {
        check(mine)
        Files.createDirectories(path)
        if (!Files.exists(record)) mine.writeIfFirst(record)
        check(mine)
    }

    /**
     * The record of the sweep that is here.
     *
     * @throws InputException when there is none
     */
    fun known(): SweepRecord {
        if (!Files.exists(record)) throw InputException("--out", null, "$path holds no sweep")
        return SweepRecord.read(record)
    }

    private fun check(mine: SweepRecord, mayHaveRuns: Boolean = false) {
        if (!Files.exists(path)) {
            if (Files.isSymbolicLink(path)) throw InputException("--out", null, "$path is a link without a target")
            return
        }
        if (!Files.isDirectory(path)) throw InputException("--out", null, "$path is no directory")
        // Another process may write the record meanwhile, and then its runs.
        if (isOf(mine)) return
        val others = Files.list(path).use { files ->
            files.filter {
                !isOwn("${it.fileName}") &&
                    !(mayHaveRuns && it == allRuns)
            }.findAny()
        }
        if (others.isPresent &&
            !isOf(mine)
        ) {
            throw InputException("--out", null, "$path is not empty and holds no sweep")
        }
    }

    /** Whether the sweep of [mine] is here; false when there is none. */
    private fun isOf(mine: SweepRecord): Boolean {
        if (!Files.exists(record)) return false
        val difference = mine.difference(SweepRecord.read(record)) ?: return true
        val mend = "repeat its command to go on with it, or give another directory"
        throw InputException("--out", null, "$path holds another sweep: $difference; $mend")
    }

    /** Whether a start that was cut short may have left [name]. */
    private fun isOwn(name: String) = name in RunLock.FILES || name.startsWith("${record.fileName}")
}
