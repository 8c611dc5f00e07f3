package daphnis.app.bench

import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.ScalingPlot
import daphnis.analysis.plot.Yardstick
import daphnis.core.format.WholeFile
import daphnis.core.input.InputException
import daphnis.core.run.Version
import java.nio.file.Files
import java.nio.file.Path

/** The files of a result in a directory. */
internal class BenchDirectory(private val path: Path) {
    private val csv = path.resolve(CSV)

    @Volatile
    private var hasTables = false

    /** Leaves a directory that holds something else alone, and removes what is not written over of an old result. */
    fun prepare() {
        if (!Files.exists(csv)) {
            val isEmpty = Files.list(path).use { it.findAny().isEmpty }
            if (!isEmpty) throw InputException("--out", null, "$path is not empty and holds no $CSV to replace")
            return
        }
        val taken = HashSet<String>()
        for (scenario in TimingFile.read(csv).map { it.scenario }.distinct()) {
            ScalingPlot.remove(path, fileName(scenario, taken))
        }
        Files.deleteIfExists(path.resolve(PAPER))
    }

    /** A list of timings for each scenario. */
    fun writeTables(all: List<List<Timing>>) {
        TimingFile.write(csv, all.flatten())
        hasTables = true
        val tables = all.joinToString("\n") { "## ${timingTitle(it)}\n\n${timingTable(it)}\n" }
        WholeFile.write(path.resolve(TABLES), "# daphnis bench\n\n${machine()}\n\n$tables")
    }

    /** What there is when not all rounds could be timed, in words. */
    fun interrupted(): String = when {
        hasTables -> "interrupted: the rounds that are done are in $path"
        Files.exists(csv) -> "interrupted: no round is done; the tables in $path are those of the earlier result"
        else -> "interrupted: no round is done"
    }

    fun writePaperTable(table: String) {
        WholeFile.write(path.resolve(PAPER), "# Beside the paper's authors\n\n${machine()}\n\n$table")
    }

    private fun machine(): String {
        val java = "${System.getProperty("java.vm.name")} ${System.getProperty("java.vm.version")}"
        val system = "${System.getProperty("os.name")} ${System.getProperty("os.arch")}"
        val cores = Runtime.getRuntime().availableProcessors()
        return "daphnis ${Version.text}, $java, $system, $cores processors"
    }

    /** How many scenarios have plots: those with an engine on several numbers of threads. */
    fun drawAll(all: List<List<Timing>>): Int {
        val taken = HashSet<String>()
        var drawn = 0
        for (timings in all) {
            val name = timings.first().scenario
            val file = fileName(name, taken)
            val curves = timings.groupBy { it.engine }.map { (engine, own) ->
                val sorted = own.sortedBy { it.threads }
                val threads = DoubleArray(sorted.size) { sorted[it].threads.toDouble() }
                Curve(engine, threads, DoubleArray(sorted.size) { sorted[it].fastest })
            }
            if (curves.all { it.x.size == 1 }) continue
            val yardstick = Ranking(timings).yardstick.let { Yardstick(it.engine, it.threads, it.fastest) }
            ScalingPlot.write(curves, yardstick, path, file, name)
            drawn++
        }
        return drawn
    }

    /** The last part of [scenario] without its extension; numbered when it is among those [taken]. */
    private fun fileName(scenario: String, taken: MutableSet<String>): String {
        val plain = scenario.substringAfterLast('/').removeSuffix(".json").replace(Regex("[^A-Za-z0-9._-]"), "-")
        return generateSequence(1) { it + 1 }.map { if (it == 1) plain else "$plain-$it" }.first(taken::add)
    }

    companion object {
        const val CSV = "bench.csv"
        private const val TABLES = "bench.md"
        private const val PAPER = "paper-table-1.md"
    }
}
