package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.long
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.ScalingPlot
import daphnis.app.bench.Contest
import daphnis.app.bench.Contestant
import daphnis.app.bench.Ranking
import daphnis.app.bench.Timing
import daphnis.app.bench.TimingComparison
import daphnis.app.bench.TimingFile
import daphnis.app.bench.significant
import daphnis.app.bench.timingTable
import daphnis.app.bench.timingTitle
import daphnis.core.parallel.ThreadHandler
import daphnis.core.run.Version
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Nearest
import java.nio.file.Files
import java.nio.file.Path

/** `daphnis bench`. */
class BenchCommand : CliktCommand(name = "bench") {
    private val words by argument(
        "scenarios",
        help = "scenario files or built-in names (default: those of the paper's three figures)",
    ).multiple()
    private val engines by option(
        "--engines",
        metavar = "name,…",
        help = "engines that take part (default: ${allEngines.names.joinToString()})",
    )
    private val threads by option(
        "--threads",
        metavar = "number,…",
        help = "numbers of threads (default: 1, 2, 4, … up to one per core)",
    )
    private val steps by option("--steps", help = "steps of a round (default: the whole scenario)").long()
    private val rounds by option("--rounds", help = "rounds that count (default: 3); one before them warms up")
        .int().default(ROUNDS)
    private val settings by option("--set", metavar = "path=value", help = "replace any key of the scenarios")
        .multiple()
    private val out by option(
        "--out",
        metavar = "dir",
        help = "where tables and plots go (default: runs/bench, numbered when it exists)",
    )
    private val compare by option("--compare", help = "compare two earlier results, old and new").flag()
    private val quiet by option("--quiet", help = "no progress").flag()

    override fun help(context: Context) =
        "Time engines against one another on the same steps, or say what became slower since."

    override fun run() {
        if (compare) return compareResults()
        if (rounds < 1) throw InputException("--rounds", null, "is $rounds; it must be >= 1")
        steps?.let { if (it < 1) throw InputException("--steps", null, "is $it; it must be >= 1") }
        val contestants = contestants()
        val names = words.ifEmpty { PAPER }.distinct()
        val contests = names.map { Contest(allEngines, contestants, scenarioNamed(it, settings), it, steps) }
        val directory = out?.let { pathOf(it, "--out") } ?: freeDirectory(Path.of("runs", "bench"))
        writing(directory) {
            requireOwn(directory)
            removePlots(directory)
        }
        val all = ArrayList<List<Timing>>()
        for (contest in contests) {
            all +=
                timed(contest) { writing(directory) { writeTables(directory, all + listOf(it)) } }
        }
        var plots = 0
        writing(directory) { plots = drawAll(directory, all) }
        if (!quiet) println("${if (plots == 0) "tables" else "tables and plots"} are in $directory")
    }

    private fun timed(contest: Contest, keep: (List<Timing>) -> Unit): List<Timing> {
        for (round in 0..rounds) {
            contest.round(isKept = round > 0) { contestant, seconds ->
                val which = if (round == 0) "warming up" else "round $round of $rounds"
                if (!quiet) say("$which: ${contestant.engine} on ${contestant.threads}: ${significant(seconds)} s")
            }
            if (round > 0) keep(contest.timings())
        }
        val timings = contest.timings()
        println(timingTitle(timings) + "\n\n" + timingTable(timings) + "\n")
        return timings
    }

    private fun say(line: String) = System.err.println("daphnis: $line")

    /** Those that work with fewer threads than asked for take part once. */
    private fun contestants(): List<Contestant> {
        val names = engines?.split(',')?.map { it.trim() } ?: allEngines.names
        val counts = threads?.split(',')?.map { threadsOf(it.trim()) } ?: usualThreads()
        return names.flatMap { name -> counts.map { Contestant(name, actualThreads(name, it)) } }.distinct()
    }

    private fun threadsOf(word: String): Int = word.toIntOrNull()?.takeIf { it in 1..ThreadHandler.MOST }
        ?: throw InputException("--threads", null, "is '$word'; numbers in 1..${ThreadHandler.MOST} are needed")

    private fun usualThreads(): List<Int> {
        val cores = Runtime.getRuntime().availableProcessors()
        return generateSequence(1) { it * 2 }.takeWhile { it < cores }.toList() + cores
    }

    private fun actualThreads(name: String, threads: Int): Int {
        val engine = allEngines.create(name, threads) ?: throw InputException(
            "--engines",
            null,
            "'$name' is no engine; ${Nearest.question(
                name,
                allEngines.names,
            )}known are ${allEngines.names.joinToString()}",
        )
        return engine.use { it.threads }
    }

    /** A directory that holds something else is left alone. */
    private fun requireOwn(directory: Path) {
        if (Files.exists(directory.resolve(CSV))) return
        val isEmpty = Files.list(directory).use { it.findAny().isEmpty }
        if (!isEmpty) throw InputException("--out", null, "$directory is not empty and holds no $CSV to replace")
    }

    private fun writeTables(directory: Path, all: List<List<Timing>>) {
        TimingFile.write(directory.resolve(CSV), all.flatten())
        val tables = all.joinToString("\n") { "## ${timingTitle(it)}\n\n${timingTable(it)}\n" }
        Files.writeString(directory.resolve(TABLES), "# daphnis bench\n\n${machine()}\n\n$tables")
    }

    private fun machine(): String {
        val java = "${System.getProperty("java.vm.name")} ${System.getProperty("java.vm.version")}"
        val system = "${System.getProperty("os.name")} ${System.getProperty("os.arch")}"
        val cores = Runtime.getRuntime().availableProcessors()
        return "daphnis ${Version.text}, $java, $system, $cores processors"
    }

    /** Those of a result that is replaced; its tables are written over. */
    private fun removePlots(directory: Path) {
        val csv = directory.resolve(CSV)
        if (!Files.exists(csv)) return
        val taken = HashSet<String>()
        for (scenario in TimingFile.read(csv).map { it.scenario }.distinct()) {
            ScalingPlot.remove(directory, fileName(scenario, taken))
        }
    }

    /** How many scenarios have plots: those with an engine on several numbers of threads. */
    private fun drawAll(directory: Path, all: List<List<Timing>>): Int {
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
            ScalingPlot.write(curves, Ranking(timings).yardstick.fastest, directory, file, name)
            drawn++
        }
        return drawn
    }

    /** The last part of [scenario] without its extension; numbered when it is among those [taken]. */
    private fun fileName(scenario: String, taken: MutableSet<String>): String {
        val plain = scenario.substringAfterLast('/').removeSuffix(".json").replace(Regex("[^A-Za-z0-9._-]"), "-")
        return generateSequence(1) { it + 1 }.map { if (it == 1) plain else "$plain-$it" }.first(taken::add)
    }

    private fun compareResults() {
        if (words.size != 2) throw InputException("--compare", null, "needs two results, the old one first")
        val (old, new) = words.map { TimingFile.read(fileOf(it)) }
        val comparison = TimingComparison(old, new)
        if (comparison.pairs.isEmpty()) throw InputException(words[1], null, "has no timing in common with ${words[0]}")
        println(comparison.table())
        comparison.unmatched.forEach(::println)
        val slower = comparison.pairs.count { it.isSlower }
        println(if (slower == 0) "nothing became slower" else "$slower became slower")
        if (slower > 0) throw ProgramResult(EXIT_FAILED)
    }

    private fun fileOf(word: String): Path = pathOf(word, "results").let {
        if (Files.isDirectory(it)) it.resolve(CSV) else it
    }

    private companion object {
        const val ROUNDS = 3
        const val CSV = "bench.csv"
        const val TABLES = "bench.md"
        val PAPER = listOf("paper-figure-1", "paper-figure-2", "paper-figure-3")
    }
}
