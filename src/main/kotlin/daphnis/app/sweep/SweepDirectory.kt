package daphnis.app.sweep

import daphnis.core.input.InputException
import daphnis.core.run.RunLock
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
    fun run(name: String): Path = path.resolve("runs").resolve(name)

    /**
     * Takes the directory, new or with the same sweep in it, until the lock is closed.
     *
     * @throws InputException when it holds something else, or a sweep of which [mine] is not the record, or another
     *   process works in it; it is as it was then
     */
    fun claim(mine: SweepRecord): RunLock {
        check(mine)
        Files.createDirectories(path)
        val lock = RunLock.take(path)
        try {
            check(mine)
            if (!Files.exists(record)) mine.write(record)
            return lock
        } catch (e: Throwable) {
            lock.use { throw e }
        }
    }

    private fun check(mine: SweepRecord) {
        if (!Files.exists(path)) {
            if (Files.isSymbolicLink(path)) throw InputException("--out", null, "$path is a link without a target")
            return
        }
        if (!Files.isDirectory(path)) throw InputException("--out", null, "$path is no directory")
        if (Files.exists(record)) {
            val difference = mine.difference(SweepRecord.read(record)) ?: return
            val mend = "repeat its command to go on with it, or give another directory"
            throw InputException("--out", null, "$path holds another sweep: $difference; $mend")
        }
        val others = Files.list(path).use { files -> files.filter { "${it.fileName}" !in OWN }.findAny() }
        if (others.isPresent) throw InputException("--out", null, "$path is not empty and holds no sweep")
    }

    private companion object {
        /** What a start that was cut short leaves. */
        val OWN = RunLock.FILES + "sweep.json.tmp"
    }
}
