package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.long
import daphnis.app.bench.BenchDirectory
import daphnis.app.bench.Contest
import daphnis.app.bench.Contestant
import daphnis.app.bench.Overview
import daphnis.app.bench.PaperTable
import daphnis.app.bench.Timing
import daphnis.app.bench.TimingComparison
import daphnis.app.bench.TimingFile
import daphnis.app.bench.Verdict
import daphnis.app.bench.significant
import daphnis.app.bench.timingTable
import daphnis.app.bench.timingTitle
import daphnis.app.printing.printLine
import daphnis.app.printing.printLines
import daphnis.app.printing.warn
import daphnis.core.input.InputException
import daphnis.core.parallel.Cores
import daphnis.core.run.adviceOn
import daphnis.core.scenario.BuiltIn
import java.nio.file.Files
import java.nio.file.Path

/** `daphnis bench`. */
class BenchCommand : CliktCommand(name = "bench") {
    private val words by argument(
        "scenarios",
        help = "scenario files or built-in names (default: those of the paper's three figures)",
        completionCandidates = Candidates.scenario,
    ).multiple()
    private val engines by option(
        "--engines",
        metavar = "name,…",
        help = "engines that take part (default: ${allEngines.names.joinToString()})",
        completionCandidates = Candidates.engines,
    )
    private val threads by option(
        "--threads",
        metavar = "number,…",
        help = "numbers of threads (default: 1, 2, 4, … up to one per core)",
    )
    private val steps by option("--steps", help = "steps of a round (default: the whole scenario)").long()
    private val roundsAsked by option(
        "--rounds",
        metavar = "number",
        help = "rounds that count (default: $ROUNDS)",
    ).int()
    private val rounds get() = roundsAsked ?: ROUNDS
    private val warmUpAsked by option(
        "--warm-up",
        metavar = "seconds",
        help = "how long each engine works before rounds count, one turn at least (default: $WARM_UP)",
    ).double()
    private val warmUp get() = warmUpAsked ?: WARM_UP
    private val settings by option(
        "--set",
        metavar = "path=value",
        help = "replace any key of the scenarios",
        completionCandidates = Candidates.setting,
    ).multiple()
    private val out by option(
        "--out",
        metavar = "dir",
        help = "where tables and plots go (default: runs/bench, numbered when it exists)",
        completionCandidates = Candidates.files,
    )
    private val compare by option("--compare", help = "compare two earlier results, old and new").flag()
    private val quiet by option("--quiet", help = "no progress").flag()

    override fun help(context: Context) =
        "Time engines against one another on the same steps, or say what became slower since."

    override fun run() {
        if (compare) return compareResults()
        if (rounds < 1) throw InputException("--rounds", null, "is $rounds; it must be at least 1")
        steps?.let { if (it < 1) throw InputException("--steps", null, "is $it; it must be at least 1") }
        if (warmUp !in 0.0..LONGEST) {
            throw InputException(
                "--warm-up",
                null,
                "is $warmUp; it must be 0 or more seconds, ${LONGEST.toInt()} at most",
            )
        }
        val contestants = contestants()
        val names = words.ifEmpty { PAPER }.distinct()
        val contests = names.map { Contest(allEngines, contestants, scenarioNamed(it, settings), it, steps) }
        val path = out?.let { pathOf(it, "--out") } ?: freeDirectory(Path.of("runs", "bench"))
        val directory = BenchDirectory(path)
        writing(path) { directory.prepare() }
        val overview = Overview(contests, contestants, rounds, warmUp)
        if (!quiet) overview.lines().forEach(::warn)
        val all = ArrayList<List<Timing>>()
        val plots = LastWords { directory.interrupted() }.use {
            for (index in contests.indices) {
                all += timed(contests[index], { round, seconds -> overview.left(index, round, seconds) }) {
                    writing(path) { directory.writeTables(all + listOf(it)) }
                }
            }
            val isWhole = steps == null && settings.isEmpty()
            val known = if (isWhole) all.filter { isBuiltIn(it.first().scenario) } else emptyList()
            PaperTable.of(known)?.let { table ->
                printLines(fitted(table))
                writing(path) { directory.writePaperTable(table) }
            }
            writing(path) { directory.drawAll(all) }
        }
        if (!quiet) printLine("${if (plots == 0) "tables" else "tables and plots"} are in $path")
    }

    /** Unless a file has its name. */
    private fun isBuiltIn(name: String) = name in BuiltIn.names && !Files.exists(Path.of(name))

    private fun timed(
        contest: Contest,
        left: (round: Int, seconds: Double) -> String?,
        keep: (List<Timing>) -> Unit,
    ): List<Timing> {
        val warm = contest.warmUp(warmUp) { contestant, own ->
            if (!quiet) warn("warming up: ${contestant.engine} on ${contestant.threads}: ${warmed(own)}")
        }
        if (!quiet) left(0, warm)?.let(::warn)
        for (round in 1..rounds) {
            val begin = System.nanoTime()
            contest.round { contestant, turn ->
                val who = "${contestant.engine} on ${contestant.threads}"
                if (!quiet) warn("round $round of $rounds: $who: ${significant(turn.seconds)} s")
            }
            keep(contest.timings())
            if (!quiet) left(round, (System.nanoTime() - begin) * 1e-9)?.let(::warn)
        }
        val timings = contest.timings()
        printLines(fitted(timingTitle(timings) + "\n\n" + timingTable(timings) + "\n"))
        return timings
    }

    /** `0.287 s`, `14 turns, the first 0.287 s, the last 0.0702 s`. */
    private fun warmed(own: Contest.WarmUp): String {
        val (first, last) = listOf(own.first, own.last).map { "${significant(it.seconds)} s" }
        return if (own.turns == 1) first else "${own.turns} turns, the first $first, the last $last"
    }

    private fun fitted(text: String): String = outputColumns()?.let { fitted(text, it) } ?: text

    /** Those that work with fewer threads than asked for take part once, and are named. */
    private fun contestants(): List<Contestant> {
        val names = engines?.split(',')?.map { it.trim() } ?: allEngines.names
        val asked = threads?.split(',')?.map { threadsOf(it.trim()) }
        val counts = asked ?: usualThreads()
        val all = names.flatMap { name -> counts.map { Contestant(name, actualThreads(name, it)) } }.distinct()
        val other = all.filter { asked != null && it.threads !in asked }.ifEmpty { return all }
        val works = if (other.size == 1) "works" else "work"
        warn("${other.joinToString { it.engine }} $works on one thread, whatever --threads says")
        return all
    }

    private fun threadsOf(word: String): Int = word.toIntOrNull()?.also(::requireThreads)
        ?: throw InputException("--threads", null, "is '$word'; numbers with commas between are needed")

    private fun usualThreads(): List<Int> {
        val cores = Cores.ofJob
        return generateSequence(1) { it * 2 }.takeWhile { it < cores }.toList() + cores
    }

    private fun actualThreads(name: String, threads: Int): Int {
        val engine = allEngines.create(name, threads) ?: throw InputException(
            "--engines",
            null,
            "'$name' is no engine; ${adviceOn(name, allEngines)}",
        )
        return engine.use { it.threads }
    }

    private fun compareResults() {
        for ((option, value) in listOf(
            "--engines" to engines,
            "--threads" to threads,
            "--steps" to steps,
            "--rounds" to roundsAsked,
            "--warm-up" to warmUpAsked,
            "--set" to settings.firstOrNull(),
            "--out" to out,
        )) {
            if (value != null) throw InputException(option, null, "has no meaning with --compare, which times nothing")
        }
        if (words.size != 2) throw InputException("--compare", null, "needs two results, the old one first")
        val (old, new) = words.map { TimingFile.read(fileOf(it)) }
        val comparison = TimingComparison(old, new)
        if (comparison.pairs.isEmpty()) {
            val what = "has no timing in common with ${words[0]}${comparison.difference()}"
            throw InputException(words[1], null, what)
        }
        printLines(fitted(comparison.table()))
        comparison.unmatched.forEach(::printLine)
        comparison.otherJava()?.let(::printLine)
        printLine(comparison.closing())
        if (comparison.pairs.any { it.verdict == Verdict.SLOWER }) throw ProgramResult(EXIT_FAILED)
    }

    private fun fileOf(word: String): Path = pathOf(word, "results").let {
        if (Files.isDirectory(it)) it.resolve(BenchDirectory.CSV) else it
    }

    private companion object {
        const val ROUNDS = 3
        const val WARM_UP = 3.0
        const val LONGEST = 3600.0
        val PAPER = listOf("paper-figure-1", "paper-figure-2", "paper-figure-3")
    }
}
