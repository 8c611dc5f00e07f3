package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.PatchState
import java.nio.file.Files
import java.nio.file.Path

/**
 * What an analysis is asked for.
 *
 * @property from averages begin at this time; null for three eighths of the run, when it is hoped to be steady
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
 * Computes everything this module knows for one [input] and writes tables (CSV), plots (SVG and PNG) and `report.html`. One thread; holds one state in memory at a
 * time.
 */
public class Analysis(private val input: AnalysisInput, private val options: AnalysisOptions = AnalysisOptions()) {
    /**
     * Writes into [directory]: `tables/`, `plots/`, `report.html`.
     *
     * @throws daphnis.core.format.FormatException when a state cannot be read
     */
    public fun write(directory: Path, progress: AnalysisProgress = AnalysisProgress { _, _, _ -> }) {
        require(options.frames >= 1) { "${options.frames} frames; there must be one at least" }
        val end = maxOf(input.times.last(), input.transport?.let { if (it.size == 0) null else it["time"].last() } ?: Double.NEGATIVE_INFINITY)
        val begin = input.times.first()
        val from = options.from ?: (begin + (end - begin) * UNSTEADY)
        val chosen = chosenFrames(from)
        val last = input.state(input.size - 1)
        val measures = Measures(last, input, options)
        val all = chosen.size + PARTS
        for ((done, k) in chosen.withIndex()) {
            progress.next(done, all, "state at time ${input.times[k]}")
            measures.add(input.state(k))
        }
        val numbers = Numbers(input, from, measures.ofState)
        progress.next(chosen.size, all, "tables and plots")
        val sections = Sections(input, measures, numbers, directory, options)
        val page = ReportPage(input.name)
        sections.write(page, last, from, chosen.size)
        progress.next(all - 1, all, "report")
        Files.writeString(directory.resolve("report.html"), page.html(subtitle(last)))
        progress.next(all, all, "done")
    }

    private fun subtitle(last: PatchState): String {
        val what = input.scenario?.description?.takeIf { it.isNotEmpty() && input.directory != null } ?: "${last.population.size} spheres"
        return "$what. daphnis ${daphnis.core.run.Version.text}."
    }

    /** States from [from] on, or the last when there are none; at most as many as asked for. */
    private fun chosenFrames(from: Double): List<Int> {
        val late = input.times.indices.filter { input.times[it] >= from }.ifEmpty { listOf(input.size - 1) }
        if (late.size <= options.frames) return late
        return List(options.frames) { late[late.size - 1 - (it.toLong() * late.size / options.frames).toInt()] }.sorted()
    }

    private companion object {
        /** The first 15 of 40 orbits. */
        const val UNSTEADY = 0.375
        const val PARTS = 2
    }
}
