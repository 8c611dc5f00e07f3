package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.format.WholeFile
import daphnis.core.input.InputException
import daphnis.core.run.TransportColumns
import daphnis.core.run.Version
import java.io.IOException
import java.nio.file.Path

/**
 * Computes everything this module knows for one [input] and writes tables (CSV), plots (SVG and PNG) and `report.html`.
 * One thread; reads each state once, and holds two in memory at a time: the last, and the one that is measured.
 *
 * @throws InputException when averages are to begin after the last state, or that holds no particle
 */
public class Analysis @JvmOverloads constructor(
    private val input: AnalysisInput,
    private val options: AnalysisOptions = AnalysisOptions(),
) {
    init {
        require(options.frames >= 1) { "${options.frames} frames; there must be one at least" }
        checkFrom()
    }

    private fun checkFrom() {
        val from = options.from ?: return
        val last = input.times.last()
        if (from <= last) return
        val why = "the last state is at time ${typed(last)}, so it must be at most that, in the scenario's unit of time"
        throw InputException("from", null, "is ${typed(from)}; $why", isArgument = true)
    }

    private fun typed(time: Double) = "$time".removeSuffix(".0")

    /** Why the last [write] made no PNGs, as where this Java has no fonts; null when it did. */
    public var missing: String? = null
        private set

    /**
     * Writes into [directory]: `tables/`, `plots/`, `report.html`. They appear there when all of them are done, and those
     * of an earlier analysis go: until then, and if it ends otherwise, what was there stays as it was.
     *
     * @throws daphnis.core.format.FormatException when a state cannot be read
     */
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(directory: Path, progress: AnalysisProgress = AnalysisProgress { _, _, _ -> }) {
        NewFiles(directory).use { files ->
            write(study(files.place), files.place, progress)
            files.keep()
        }
    }

    private fun write(study: Study, place: Path, progress: AnalysisProgress) {
        val sections = Sections(study)
        val all = sections.states.size + PARTS
        for ((done, k) in sections.states.withIndex()) {
            progress.next(done, all, "state ${done + 1} of ${sections.states.size}, time ${study.time(input.times[k])}")
            sections.add(k)
        }
        val page = ReportPage(input.name)
        sections.write(page) { progress.next(all - 2, all, "tables and plots: $it") }
        missing = study.pictures.missing
        progress.next(all - 1, all, "report")
        WholeFile.write(place.resolve("report.html"), page.html(subtitle(study)))
        progress.next(all, all, "done")
    }

    /**
     * The rows of `tables/numbers.csv` in its order, without writing anything.
     *
     * @throws daphnis.core.format.FormatException when a state cannot be read
     */
    public fun numbers(): List<ReportNumber> {
        val sections = sections(Sections.WITH_NUMBERS)
        return sections.numbers().map {
            val isSteady = it.unknown != Unknown.UNSTEADY && it.unknown != Unknown.ONE_STATE
            val isJudged = !(sections.isUnjudged && it.isAverage)
            // Of one phase it is not the number that others are compared with.
            val value = if (it.unknown == Unknown.FEW_PHASES) Double.NaN else it.value
            ReportNumber(checkNotNull(it.key) { it.name }, it.name, it.unit, value, isSteady, isJudged)
        }
    }

    /** All rows of the page's tables of numbers as it shows them, with their errors. */
    internal fun rows(): List<NumberRow> {
        val light = if (options.occultation.isAsked) listOf<(Study) -> Section>(::OccultationSection) else emptyList()
        return sections(Sections.WITH_OWN_NUMBERS + light + ::BrightnessSection).allNumbers()
    }

    private fun sections(list: List<(Study) -> Section>) = Sections(study(Path.of("")), list).also {
        for (k in it.states) it.add(k)
    }

    private fun study(directory: Path): Study {
        val isGrowing = Growth.isSeen(input)
        val start = if (options.from == null && !isGrowing) SteadyStart.of(input, steady()) else null
        val from = options.from ?: start?.from ?: input.times.last()
        if (input.snapshot(input.size - 1).size == 0) {
            throw InputException(
                input.name,
                null,
                "has no particle left in its last state; there is nothing to measure",
            )
        }
        return Study(input, from, averaged(from), options, directory, start?.isFound == true, isGrowing)
    }

    /** When a run is hoped to be steady. */
    private fun steady(): Double {
        val begin = input.times.first()
        val lastRow = input.transport?.let { it[TransportColumns.TIME].lastOrNull() } ?: Double.NEGATIVE_INFINITY
        val end = maxOf(input.times.last(), lastRow)
        return begin + (end - begin) * UNSTEADY
    }

    private fun subtitle(study: Study): String {
        val description = input.scenario?.description?.takeIf { it.isNotEmpty() && input.directory != null }
        val what = description ?: ReportText.count(study.last.population.size, study.bodies.removeSuffix("s"))
        return "$what. Analysed with daphnis ${Version.text}."
    }

    /** Indices of the states from [from] on, or of the last when there are none; at most as many as asked for. */
    private fun averaged(from: Double): List<Int> {
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
    }
}
