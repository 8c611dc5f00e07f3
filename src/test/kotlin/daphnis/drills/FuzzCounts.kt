package daphnis.drills

import daphnis.app.CommandResult
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/**
 * What became of the cases of a fuzz.
 *
 * @property worked cases that were right after all
 * @property refused cases answered with exit code 2 and one line
 * @property failed cases that were right and whose simulation then ended with one line, such as a collapse
 * @property faults all others, a line or more each, with what is needed to do them again
 */
internal class FuzzCounts {
    var worked = 0
    var refused = 0
    var failed = 0
    val faults = ArrayList<String>()

    override fun toString() =
        "$worked worked, $refused refused in a line, $failed failed in a line, ${faults.size} faults" +
            faults.joinToString("") { "\n$it" }
}

/** Cases one after the other, each under a watchdog; one that hangs ends the fuzz, for nothing can end it. */
internal class Fuzz(private val cases: Int, private val seed: Long) {
    private val counts = FuzzCounts()

    /** @param case number of the case, counts to add to → what else is known of the case, for a fault */
    fun run(case: (number: Int, counts: FuzzCounts) -> Unit): FuzzCounts {
        for (number in 0 until cases) {
            if (!ends(number) { case(number, counts) }) break
        }
        return counts
    }

    private fun ends(number: Int, work: () -> Unit): Boolean {
        val worker = Thread(null, {
            try {
                work()
            } catch (e: Throwable) {
                counts.faults += "seed $seed case $number: ${e.stackTraceToString().take(MOST_SHOWN)}"
            }
        }, "fuzz-$number", STACK)
        worker.isDaemon = true
        worker.start()
        worker.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS))
        if (!worker.isAlive) return true
        val frames = worker.stackTrace.take(FRAMES).joinToString(" | ")
        counts.faults += "seed $seed case $number takes more than $PATIENCE_SECONDS s: $frames"
        return false
    }

    private companion object {
        const val PATIENCE_SECONDS = 60L
        const val MOST_SHOWN = 1500
        const val FRAMES = 20

        /** That of a main thread. */
        const val STACK = 1L shl 20
    }
}

/**
 * What a command said: null when it did what it should, or refused in one line; else what is wrong with that. [file]
 * may be named.
 */
internal fun FuzzCounts.count(result: CommandResult, file: Path): Boolean {
    if (result.code == 0) return true
    val line = result.err.trimEnd()
    val isOneLine = result.code == 2 && '\n' !in line && line.length < MOST_LINE + file.toString().length * 2
    val isPlain = line.none { it.isISOControl() } && "Exception" !in line
    if (isOneLine && isPlain) refused++ else faults += "$file: exit code ${result.code}: ${line.take(MOST_LINE)}"
    return false
}

private const val MOST_LINE = 1200
