package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.core.run.Version
import daphnis.core.run.TransportColumns
import daphnis.core.scenario.InputException
import java.nio.file.Files
import java.nio.file.Path

/**
 * What an analysis is asked for.
 *
 * @property from averages begin at this time, at most that of the last state; null for three eighths of the run, when
 * it is hoped to be steady
 * @property slabs of azimuth for streamlines; [groups] in each; 0 to choose by the number of particles
 * @property elevation of the rays above the x-y plane in degrees, in (0, 90]
 * @property frames states that are averaged at most, evenly spread
 * @property azimuth direction in which the rays climb, from x toward y, in degrees
 */
public class AnalysisOptions(
    public val from: Double? = null,
    public val slabs: Int = 0,
    public val groups: Int = 0,
    public val elevation: Double = 28.0,
    public val frames: Int = 40,
    public val azimuth: Double = 0.0,
)

/** Told how far a long analysis has come. */
public fun interface AnalysisProgress {
    /** [done] of [all] parts are done, [what] comes next. */
    public fun next(done: Int, all: Int, what: String)
}

/**
 * Computes everything this module knows for one [input] and writes tables (CSV), plots (SVG and PNG) and `report.html`.
 * One thread; holds one state in memory at a time.
 *
 * @throws InputException when averages are to begin after the last state, or that holds no particle
 */
public class Analysis(private val input: AnalysisInput, private val options: AnalysisOptions = AnalysisOptions()) {
    init {
        require(options.frames >= 1) { "${options.frames} frames; there must be one at least" }
        checkFrom()
    }

    private fun checkFrom() {
        val from = options.from ?: return
        val last = input.times.last()
        if (from <= last) return
        val value = ReportText.plain(from, DIGITS)
        val end = ReportText.plain(last, DIGITS)
        val why = "the last state is at time $end, so it must be at most that, in the scenario's unit of time"
        throw InputException("from", null, "is $value; $why", isArgument = true)
    }

    /**
     * Writes into [directory]: `tables/`, `plots/`, `report.html`.
     *
     * @throws daphnis.core.format.FormatException when a state cannot be read
     */
    public fun write(directory: Path, progress: AnalysisProgress = AnalysisProgress { _, _, _ -> }) {
        val from = options.from ?: steady()
        val chosen = chosenFrames(from)
        val last = input.state(input.size - 1)
        if (last.population.size == 0) {
            throw InputException(
                input.name,
                null,
                "has no particle left in its last state; there is nothing to measure",
            )
        }
        val measures = ReportAverages(last, input, options)
        val all = chosen.size + PARTS
        for ((done, k) in chosen.withIndex()) {
            progress.next(done, all, "state at time ${input.times[k]}")
            measures.add(input.state(k))
        }
        val numbers = Numbers(input, from, measures.ofState)
        progress.next(chosen.size, all, "tables and plots")
        val averaged = DoubleArray(chosen.size) { input.times[chosen[it]] }
        val study = Study(input, measures, numbers, last, from, averaged, options, directory)
        val page = ReportPage(input.name)
        Sections(study).write(page)
        progress.next(all - 1, all, "report")
        Files.writeString(directory.resolve("report.html"), page.html(subtitle(last)))
        progress.next(all, all, "done")
    }

    /** When a run is hoped to be steady. */
    private fun steady(): Double {
        val begin = input.times.first()
        val lastRow = input.transport?.let { it[TransportColumns.TIME].lastOrNull() } ?: Double.NEGATIVE_INFINITY
        val end = maxOf(input.times.last(), lastRow)
        return begin + (end - begin) * UNSTEADY
    }

    private fun subtitle(last: State): String {
        val description = input.scenario?.description?.takeIf { it.isNotEmpty() && input.directory != null }
        val what = description ?: ReportText.count(last.population.size, "sphere")
        return "$what. Analysed with daphnis ${Version.text}."
    }

    /** States from [from] on, or the last when there are none; at most as many as asked for. */
    private fun chosenFrames(from: Double): List<Int> {
        val late = input.times.indices.filter { input.times[it] >= from }.ifEmpty { listOf(input.size - 1) }
        if (late.size <= options.frames) return late
        return List(options.frames) {
            late[late.size - 1 - (it.toLong() * late.size / options.frames).toInt()]
        }.sorted()
    }

    private companion object {
        /** The first 15 of 40 orbits. */
        const val UNSTEADY = 0.375
        const val PARTS = 2
        const val DIGITS = 8
    }
}
