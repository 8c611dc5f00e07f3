package daphnis.analysis.profile

import daphnis.analysis.insitu.PooledMeasure
import daphnis.analysis.insitu.State
import daphnis.analysis.neighbour.NeighbourLists
import daphnis.analysis.neighbour.Neighbours
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * The thermal part of the velocity dispersion: what is left of each particle's velocity without the motion that its near
 * neighbours share, such as that of a wave or of a forced epicycle. As a [PooledMeasure] it gives [COLUMNS].
 *
 * The mean flow at a particle is what its neighbours tell, with the imposed flow taken out: a polynomial of second
 * degree that fits their velocities best ([LocalFlow]). Of what is left of the particle what the random motion of the
 * neighbours adds to that flow is taken away. So each particle counts by its mass, whatever its neighbours are: in flat
 * layers the large ones have none over or under them, and pairs at a small distance in the plane are hot. A smooth flow
 * leaves nothing as long as [reach] is shorter than about a third of the wavelength. It depends neither on a choice of
 * slabs nor, but for its error, on the number of particles.
 *
 * | column | what |
 * |---|---|
 * | pairs | pairs in one state |
 * | c_xx, c_yy, c_zz | ⟨c_a²⟩ by mass, c around the mean flow of the near neighbours |
 * | c2 | the sum of the three |
 *
 * Neighbours are those up to [reach] in the x-y plane, whatever their height, unless z is periodic. Particles with fewer than two are left
 * out. NaN for fewer than [FEWEST_PAIRS] pairs in all states together.
 *
 * @param reach largest distance of a neighbour, a length
 * @property isAlongX whether distances are those along x alone, for patches so thin along y that flows vary along x only
 */
public class LocalDispersion @JvmOverloads constructor(public val reach: Double, public val isAlongX: Boolean = false) :
    PooledMeasure {
    init {
        require(reach > 0 && reach.isFinite()) { "pairs up to $reach; it must be > 0" }
    }

    /** Pairs, Σ m of the particles that tell, and for each axis Σ m c². */
    override fun sums(state: State): DoubleArray {
        val p = state.population
        val sums = DoubleArray(WIDTH)
        if (p.size == 0) return sums
        val lists = NeighbourLists.of(flat(state), Neighbours.Within(reach))
        val w = Array(3) { axis -> DoubleArray(p.size) { state.againstFlow(it, axis) } }
        val flow = LocalFlow(lists, w, reach, if (isAlongX) 1 else 2)
        for (i in 0 until p.size) {
            sums[0] += lists.count(i) / 2.0
            if (!flow.measure(i)) continue
            sums[MASS] += p.mass[i]
            for (axis in 0..2) sums[SQUARE + axis] += p.mass[i] * flow.squares[axis]
        }
        return sums
    }

    /** The same spheres as if all lay at one height, unless space goes on there; along x as if all lay on one line. */
    private fun flat(state: State): State {
        if (!isAlongX && state.boundary.hasImages(2)) return state
        val p = state.population
        fun middle(of: DoubleArray) = DoubleArray(p.size) { of[0] }
        val y = if (isAlongX) middle(p.y) else p.y
        val flat = Population(p.x, y, middle(p.z), p.vx, p.vy, p.vz, p.radius, p.mass, p.id)
        val boundary = state.boundary
        val line = if (isAlongX) Periodic(boundary.box, boundary.hasImages(0), false, false) else boundary
        return State(flat, line, state.time, state.frequencies, state.firstBody)
    }

    override fun finish(sums: DoubleArray, states: Int): DoubleArray {
        val result = DoubleArray(COLUMNS.size) { Double.NaN }
        result[0] = sums[0] / states
        if (sums[0] < FEWEST_PAIRS || sums[MASS] == 0.0) return result
        for (axis in 0..2) result[1 + axis] = maxOf(0.0, sums[SQUARE + axis] / sums[MASS])
        result[C2] = result[1] + result[2] + result[3]
        return result
    }

    public companion object {
        /**
         * One with the [reach] of [state]; where the patch has no room for it along y, as thin ones of waves, along x
         * alone. Null for fewer than two particles.
         */
        @JvmStatic
        public fun fitting(state: State): LocalDispersion? {
            val wanted = wanted(state)
            val box = state.boundary.box
            val isAlongX = box.length(0) >= THIN * box.length(1) &&
                (state.boundary.meanFlow?.normalAxis ?: 0) == 0 &&
                MOST_OF_EDGE * box.length(1) < minOf(wanted, MOST_OF_EDGE * box.length(0))
            val found = if (isAlongX) minOf(wanted, MOST_OF_EDGE * box.length(0)) else reach(state)
            return if (found > 0) LocalDispersion(found, isAlongX) else null
        }

        @JvmField
        public val COLUMNS: List<String> = listOf("pairs", "c_xx", "c_yy", "c_zz", "c2")

        /** See [LocalDispersion]. */
        public const val FEWEST_PAIRS: Int = 100
        private const val WIDTH = 5
        private const val MASS = 1
        private const val SQUARE = 2
        private const val C2 = 4

        private const val DIAMETERS_BY_MASS = 2
        private const val NEIGHBOURS = 24.0
        private const val MOST_OF_EDGE = 0.25

        /** Edge along x over that along y from which a patch may be too thin for pairs in the plane. */
        private const val THIN = 4

        /**
         * A distance for [state]: as far as a particle has 24 neighbours, or two mean diameters by mass, but not above a
         * quarter of the shorter edge of the patch. NaN for fewer than two particles.
         */
        @JvmStatic
        public fun reach(state: State): Double {
            val edges = (0..2).filter { it < 2 || state.boundary.hasImages(it) }
            return minOf(wanted(state), MOST_OF_EDGE * edges.minOf { state.boundary.box.length(it) })
        }

        private fun wanted(state: State): Double {
            val p = state.population
            val particles = (0 until p.size).filter { state.isParticle(it) }
            if (particles.size < 2) return Double.NaN
            val byMass = particles.sumOf { p.mass[it] * p.radius[it] } / particles.sumOf { p.mass[it] }
            val far = sqrt(NEIGHBOURS * state.area / (PI * particles.size))
            return maxOf(DIAMETERS_BY_MASS * 2 * byMass, far)
        }
    }
}
