package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.PatchState
import java.nio.file.Files
import java.nio.file.Path

/**
 * What an analysis is asked for.
 *
 * @property from averages begin at this time; null for three eighths of the run, when it is hoped to be steady
 * @property slabs of azimuth for streamlines; [groups] in each; 0 to choose by the number of particles
 * @property elevation of the rays in degrees
 * @property frames states that are averaged at most, evenly spread
 */
public class AnalysisOptions(
    public val from: Double? = null,
    public val slabs: Int = 0,
    public val groups: Int = 0,
    public val elevation: Double = 28.0,
    public val frames: Int = 40,
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
        val measures = Measures(last, input, options.elevation)
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

/** Everything that is averaged over states, with bins chosen from one of them. */
internal class Measures(sample: PatchState, private val input: AnalysisInput, elevation: Double) {
    private val box = sample.boundary.box
    private val radius = sample.population.radius
    val largest: Double = (0 until sample.population.size).filter { sample.isParticle(it) }.maxOfOrNull { radius[it] } ?: 1.0
    private val height: Double = (0 until sample.population.size).maxOf { Math.abs(sample.population.z[it]) } + largest

    val radial = daphnis.analysis.profile.Profile(0, box.lowerX, box.upperX, bins(box.length(0)))
    val azimuthal = daphnis.analysis.profile.Profile(1, box.lowerY, box.upperY, bins(box.length(1)))
    val vertical = if (input.omega != null) {
        daphnis.analysis.profile.Profile(2, -height, height, bins(4 * 2 * height))
    } else {
        daphnis.analysis.profile.Profile(2, box.lowerZ, box.upperZ, bins(box.length(2)))
    }
    private val shortest = minOf(box.length(0), box.length(1))
    val pairs = daphnis.analysis.correlation.PairCorrelation(minOf(shortest / 2, PAIR_RADII * 2 * meanRadius(sample)), PAIR_BINS)
    val structure = daphnis.analysis.correlation.StructureFactor(minOf(2 * Math.PI / (2 * meanRadius(sample)) * 2, 2 * Math.PI / shortest * 60), STRUCTURE_BINS)
    val rays = daphnis.analysis.occultation.RayCasting(Math.toRadians(elevation))
    val elevation: Double = elevation
    val cell: Double = maxOf(2 * meanRadius(sample), maxOf(box.length(0), box.length(1)) / MAP_CELLS)

    val ofState = Averages(Numbers.OF_STATE)
    val ofRadial = Averages(radial)
    val ofAzimuthal = Averages(azimuthal)
    val ofVertical = Averages(vertical)
    val ofPairs = Averages(pairs)
    val ofStructure = Averages(structure)
    val ofDepth = Averages(rays.depth())
    val ofScan = Averages({ rays.cast(it).scan() })
    val flow = daphnis.analysis.flow.FlowField(FLOW_CELLS, FLOW_CELLS)
    var flowSums = DoubleArray(0)
        private set
    var autocorrelation = DoubleArray(0)
        private set
    var lagX = 0
        private set
    var lagY = 0
        private set
    var dx = 0.0
        private set
    var dy = 0.0
        private set
    private var maps = 0

    /** Whether pairs and maps are worth looking at: not for patches a thousand times as long as wide. */
    val isCompact: Boolean = maxOf(box.length(0), box.length(1)) <= 20 * shortest

    fun add(state: PatchState) {
        ofState.add(state)
        ofRadial.add(state)
        ofAzimuthal.add(state)
        ofVertical.add(state)
        ofDepth.add(state)
        ofScan.add(state)
        if (!isCompact) return
        ofPairs.add(state)
        ofStructure.add(state)
        val map = daphnis.analysis.correlation.SurfaceMap.of(state, cell)
        lagX = map.nx / 2
        lagY = map.ny / 2
        dx = map.dx
        dy = map.dy
        val a = map.autocorrelation(lagX, lagY)
        if (autocorrelation.size != a.size) autocorrelation = DoubleArray(a.size)
        for (k in a.indices) autocorrelation[k] = (autocorrelation[k] * maps + a[k]) / (maps + 1)
        maps++
        val sums = flow.of(state)
        if (flowSums.isEmpty()) flowSums = sums else for (k in sums.indices) flowSums[k] += sums[k]
    }

    private fun meanRadius(sample: PatchState) = (0 until sample.population.size).filter {
        sample.isParticle(it)
    }.map { radius[it] }.average().let { if (it.isNaN()) 1.0 else it }

    /** Bins of a few radii, not too many. */
    private fun bins(length: Double): Int = (length / (2 * largest)).toInt().coerceIn(1, MOST_BINS)

    private companion object {
        const val MOST_BINS = 60
        const val PAIR_RADII = 8.0
        const val PAIR_BINS = 80
        const val STRUCTURE_BINS = 60
        const val MAP_CELLS = 64
        const val FLOW_CELLS = 24
    }
}
