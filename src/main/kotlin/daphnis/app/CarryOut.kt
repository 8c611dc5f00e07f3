package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.plot.RunPlot
import daphnis.analysis.table.UnitNames
import daphnis.app.describe.counted
import daphnis.app.describe.goals
import daphnis.app.describe.spheres
import daphnis.app.live.Ending
import daphnis.app.live.LivePage
import daphnis.app.printing.printLine
import daphnis.app.printing.reasonInWords
import daphnis.app.printing.warn
import daphnis.app.progress.PlacementLine
import daphnis.app.progress.Progress
import daphnis.app.progress.TimesInWords
import daphnis.core.cluster.FleetException
import daphnis.core.population.Population
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunException
import daphnis.core.run.Summary
import daphnis.core.run.Version
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.ResolvedScenario
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions
import java.util.Locale
import kotlin.concurrent.thread

/**
 * Carries out what [start] makes, with progress, a plot and the closing lines; Ctrl-C ends it with a checkpoint.
 *
 * @param live where it can be looked at meanwhile
 * @param fleet of the nodes that may compute; null for none
 */
internal fun CliktCommand.carryOut(
    quiet: Boolean,
    live: LivePage? = null,
    fleet: FleetOptions? = null,
    start: () -> Run,
) {
    val interruption = Interruption { fleet?.giveUp() }
    preparePlot()
    try {
        PlacementLine.shown(quiet, start).use { run ->
            for (notice in run.notices) warn(notice)
            val directory = run.directory.path
            if (!quiet) {
                val from = if (run.resumedFrom > 0) "from step ${run.resumedFrom}, " else originOf(run)
                val count = run.simulation.let { spheres(it.population.size, it.boundary.space) }
                val times = timesOf(run)
                val isOver = run.simulation.time >= run.until
                val now = if (isOver) "already at the end, " else ""
                val span = if (isOver) times.text(run.simulation.time) else times.span(run.simulation.time, run.until)
                printLine("$count, $from${now}time $span, into $directory")
            }
            interruption.armed = true
            val units = UnitsOfDimensions(run.scenario?.units)
            val able = { fleet?.able ?: Long.MAX_VALUE }
            val progress = Progress(quiet, run.until, timesOf(run), named(units, Dimension.ENERGY), able)
            fun interrupted(where: String): Nothing {
                val words = "interrupted $where; continue with: ${Version.command} resume ${quoted("$directory")}"
                live?.endsWith(Ending.Kind.INTERRUPTED, words)
                printLine(words)
                throw ProgramResult(EXIT_INTERRUPTED)
            }
            val summary = try {
                run.execute(live?.watching(run, progress) ?: progress) {
                    progress.beginStep()
                    interruption.requested
                }
            } catch (e: RunException) {
                if (interruption.requested && e.cause is FleetException) interrupted("while it waited for nodes")
                throw e
            } finally {
                live?.showLast()
            }
            if (!summary.finished) interrupted("after step ${summary.steps}")
            val end = "after step ${summary.steps}, time ${timesOf(run).text(summary.time)}"
            live?.endsWith(Ending.Kind.COMPLETE, "complete $end, state digest ${summary.stateDigest}")
            if (run.hasSeries) run.scenario?.let { drawPlot(run.directory, it, run.simulation.population) }
            report(summary, timesOf(run), units)
            val goals = run.scenario?.growth?.goals().orEmpty()
            // Steps up to the end may fall short of it by rounding.
            if (goals.isNotEmpty() && summary.time < run.until * (1 - 1e-9)) {
                printLine("ended before time ${timesOf(run).text(run.until)}, at ${goals.joinToString(" or ")}")
            }
            if (interruption.requested) {
                printLine("interrupted at the end: the run is complete, there is nothing to resume")
                throw ProgramResult(EXIT_INTERRUPTED)
            }
        }
    } catch (e: Throwable) {
        // An end with a code of its own has been told.
        if (e !is ProgramResult) live?.endsWith(Ending.Kind.FAILED, "failed: ${reasonInWords(e)}")
        throw e
    } finally {
        // A page that is looked at hears how it ended before the program does.
        live?.close()
        interruption.done()
    }
}

/** The state of another run from which this one starts, in words; empty without one. */
private fun originOf(run: Run): String {
    val placement = run.scenario?.placement?.file ?: return ""
    return placement.run?.let { "from step ${placement.step ?: 0} of $it, " }.orEmpty()
}

/** A run of a program has no scenario that tells its units. */
private fun timesOf(run: Run): TimesInWords = run.scenario?.let { TimesInWords.of(it) } ?: TimesInWords(null, null)

/** Why a run has no plot, in one line. */
internal fun noPlot(e: Throwable): String = "no plot: ${reasonInWords(e)}; the run is complete"

/** The numbers are safe when it comes to this; a missing plot is no reason to call the run failed. */
internal fun drawPlot(
    directory: RunDirectory,
    scenario: ResolvedScenario,
    population: Population,
    tell: (String) -> Unit = ::warn,
) {
    fun none(e: Throwable) = tell(noPlot(e))
    try {
        RunPlot.write(directory.series, directory.plots, scenario.name, PlotScale.of(scenario, population))
    } catch (e: Exception) {
        none(e)
    } catch (e: LinkageError) {
        none(e)
    } catch (e: OutOfMemoryError) {
        none(e)
    }
}

/** As a shell takes it for one word. */
private fun quoted(word: String) =
    if (word.all { it.isLetterOrDigit() || it in "/._-+:@%=," }) word else "'${word.replace("'", "'\\''")}'"

/**
 * Loads what the plot needs beside the start of the run. What fails here fails again when the plot is drawn, and is
 * said then.
 */
internal fun preparePlot() {
    thread(isDaemon = true, name = "daphnis-plot", priority = Thread.MIN_PRIORITY) {
        try {
            RunPlot.prepare()
        } catch (e: Throwable) {
            return@thread
        }
    }
}

/** The unit of [dimension] if it has a name, readable; else empty. */
private fun named(units: UnitsOfDimensions, dimension: String): String =
    UnitNames.raised(units.of(dimension)).takeUnless { it.startsWith(UnitsOfDimensions.UNNAMED) }.orEmpty()

private fun report(summary: Summary, times: TimesInWords, units: UnitsOfDimensions) {
    fun say(format: String, vararg values: Any) = printLine(String.format(Locale.ROOT, format, *values))
    val end = times.text(summary.time)
    val edges = if (summary.edgeEvents > 0) ", ${counted(summary.edgeEvents, "event")} at edges" else ""
    val mergers = if (summary.mergers > 0) ", ${counted(summary.mergers, "merger")}" else ""
    val broken = if (summary.broken > 0) ", ${counted(summary.broken, "broken sphere")}" else ""
    val tried = summary.swapAttempts
    val swaps = if (tried > 0) ", ${counted(summary.swaps, "swap")} of $tried tried" else ""
    val collisions = counted(summary.collisions, "collision") + mergers + broken + edges + swaps
    say("%s to time %s in %.1f s, %s", counted(summary.steps, "step"), end, summary.wallSeconds, collisions)
    val ofSpeeds = named(units, Dimension.SPEED_SQUARED)
    val ofEnergy = named(units, Dimension.ENERGY).ifEmpty { "in the scenario's units" }
    val temperature = String.format(Locale.ROOT, "%.6g %s", summary.temperature, ofSpeeds).trim()
    say("temperature %s, kinetic energy %.6g %s", temperature, summary.energy, ofEnergy)
    if (summary.maxOverlap > 0) say("deepest overlap %.2g of the sum of two radii", summary.maxOverlap)
    val guarded = counted(summary.guardActivations, "collision")
    if (summary.guardActivations > 0) say("the collapse guard made %s elastic", guarded)
    printLine("state digest ${summary.stateDigest}")
}
