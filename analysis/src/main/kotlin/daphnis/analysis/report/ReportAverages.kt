package daphnis.analysis.report

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.correlation.StructureFactor
import daphnis.analysis.correlation.SurfaceMap
import daphnis.analysis.flow.FlowField
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.RayCasting
import daphnis.analysis.profile.DispersionBySize
import daphnis.analysis.profile.Profile

/** Everything that is averaged over states, with bins chosen from one of them. */
internal class ReportAverages(sample: State, private val input: AnalysisInput, val options: AnalysisOptions) {
    private val box = sample.boundary.box
    private val radius = sample.population.radius
    val largest: Double =
        (0 until sample.population.size).filter { sample.isParticle(it) }.maxOfOrNull { radius[it] } ?: 1.0
    private val height: Double = (0 until sample.population.size).maxOf { Math.abs(sample.population.z[it]) } + largest

    val radial = Profile(0, box.lowerX, box.upperX, bins(box.length(0)))
    val azimuthal = Profile(1, box.lowerY, box.upperY, bins(box.length(1)))
    val vertical = if (input.omega != null) {
        Profile(2, -height, height, bins(4 * 2 * height))
    } else {
        Profile(2, box.lowerZ, box.upperZ, bins(box.length(2)))
    }
    private val shortest = minOf(box.length(0), box.length(1))
    val pairs = pairCorrelation(sample)
    val structure =
        StructureFactor(minOf(2 * Math.PI / (2 * meanRadius(sample)) * 2, 2 * Math.PI / shortest * 60), STRUCTURE_BINS)
    val rays = RayCasting(Math.toRadians(options.elevation), Math.toRadians(options.azimuth))

    /** Whether light through the patch means something: not through a box that is one of many all around. */
    val isSlab: Boolean = !sample.boundary.repeats(2)
    val cell: Double = maxOf(2 * meanRadius(sample), maxOf(box.length(0), box.length(1)) / MAP_CELLS)

    val ofState = Averages(Numbers.OF_STATE)
    val ofRadial = Averages(radial)
    val ofAzimuthal = Averages(azimuthal)
    val ofVertical = Averages(vertical)
    val ofPairs = Averages(pairs)
    val ofStructure = Averages(structure)
    val sizes = DispersionBySize.of(sample)
    val ofSizes = sizes?.let { Averages(it) }

    /** Share of the rays that come through, then by place along x. */
    val ofLight = Averages({ state -> rays.cast(state).let { doubleArrayOf(it.transmission) + it.scan() } })
    val flow = FlowField(FLOW_CELLS, FLOW_CELLS)
    var flowSums = DoubleArray(0)
        private set

    /** Autocorrelations of the surface density by state, of lags up to half the patch. */
    val autocorrelations = ArrayList<DoubleArray>()
    var lagX = 0
        private set
    var lagY = 0
        private set
    var dx = 0.0
        private set
    var dy = 0.0
        private set

    /** Whether pairs and maps are worth looking at: not for patches a thousand times as long as wide. */
    val isCompact: Boolean = maxOf(box.length(0), box.length(1)) <= 20 * shortest

    fun add(state: State) {
        ofState.add(state)
        ofRadial.add(state)
        ofAzimuthal.add(state)
        ofVertical.add(state)
        ofSizes?.add(state)
        if (isSlab) ofLight.add(state)
        if (!isCompact) return
        ofPairs.add(state)
        ofStructure.add(state)
        val map = SurfaceMap.of(state, cell)
        lagX = map.nx / 2
        lagY = map.ny / 2
        dx = map.dx
        dy = map.dy
        autocorrelations += map.autocorrelation(lagX, lagY)
        val sums = flow.of(state)
        if (flowSums.isEmpty()) flowSums = sums else for (k in sums.indices) flowSums[k] += sums[k]
    }

    /** The mean of [autocorrelations]; empty when there are none. */
    fun meanAutocorrelation(): DoubleArray = if (autocorrelations.isEmpty()) {
        DoubleArray(0)
    } else {
        DoubleArray(autocorrelations[0].size) { k ->
            autocorrelations.sumOf { it[k] } /
                autocorrelations.size
        }
    }

    private fun pairCorrelation(sample: State): PairCorrelation {
        val contact =
            (0 until sample.population.size).filter { sample.isParticle(it) }.minOfOrNull { 2 * radius[it] } ?: 0.0
        val farthest = minOf(PairCorrelation.farthest(sample.boundary), PAIR_RADII * 2 * meanRadius(sample))
        val fromContact = !PairCorrelation.isInPlane(sample.boundary) && contact < farthest
        return PairCorrelation(farthest, PAIR_BINS, if (fromContact) contact else 0.0)
    }

    private fun meanRadius(sample: State) = (0 until sample.population.size).filter {
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
