package daphnis.app.bench

import java.util.Locale

/**
 * Table 1 of Lewis & Massingill, *Multithreaded Collision Detection in Java*: one thread on the paper's three systems,
 * beside what is known of the authors' programs. What is not known is left out.
 */
internal object PaperTable {
    /** CPU seconds of a whole run of the authors' public C++, and microseconds per collision, as they were noted. */
    private class Authors(val seconds: Double, val microseconds: String)

    private val AUTHORS = mapOf(
        "paper-figure-1" to Authors(7.9, "17.9"),
        "paper-figure-2" to Authors(14.2, "8.5"),
        "paper-figure-3" to Authors(20.2, "46.1"),
    )

    /** Of [all], whole runs of unchanged scenarios, those that the paper has, on one thread; null if there are none. */
    fun of(all: List<List<Timing>>): String? {
        val ours = all.flatten().filter { it.threads == 1 && it.scenario in AUTHORS }
        if (ours.isEmpty()) return null
        return "$HEADER\n${ours.joinToString("\n", transform = ::row)}\n\n$SOURCES"
    }

    private fun row(ours: Timing): String {
        val authors = AUTHORS.getValue(ours.scenario)
        return listOf(
            ours.scenario,
            ours.engine,
            significant(ours.fastest),
            hundredths(ours.processorOfFastest),
            significant(ours.microsecondsPerCollision),
            significant(authors.seconds),
            authors.microseconds,
            "%.1f".format(Locale.ROOT, authors.seconds / ours.fastest),
            "1.06 to 1.20",
        ).joinToString(" | ", "| ", " |")
    }

    private const val HEADER =
        "| system | engine | ours, s | processor, s | µs per collision | authors' C++ [1], s | µs per collision | " +
            "[1] / ours | Java / C++ [2] |\n|---|---|--:|--:|--:|--:|--:|--:|--:|"

    private val SOURCES = """
        Ours is the fastest round: wall-clock time of all steps on one thread, without the start of Java and files, and
        what that round took of all processors, with what Java's compilers and its collector did meanwhile.

        [1] HardSphereCollSims, the public C++ of the paper's authors, commit 157ca72, g++ 12.2 -O3 -march=native: CPU
        time on one core of an AMD EPYC, measured by this project, on another day than ours. Beside another machine it
        says little; beside the same kind of machine it is good to a factor of 1.8.

        [2] Lewis & Massingill say that their Java took 6 to 20 % longer than their C++, on their machine. The seconds
        in the paper's own table are not known to this project, and are left out.
    """.trimIndent() + "\n"
}
