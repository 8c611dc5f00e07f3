package daphnis.analysis.correlation

import daphnis.analysis.insitu.PooledMeasure
import daphnis.analysis.insitu.State
import daphnis.core.initial.SeededRandom
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * The excess chemical potential of hard spheres by insertion: μ_ex/kT = −ln p, with p the probability that a sphere put
 * at a random place overlaps no other (Widom 1963, J. Chem. Phys. 39, 2808). As a [PooledMeasure] it gives −ln p for
 * [bins] + 1 diameters of the sphere that is inserted, from 0 to [largest] evenly. The same places serve all: each is
 * good for spheres up to its distance from the nearest surface.
 *
 * A point fits into all that spheres leave free, so p is 1 − φ at the diameter 0; with this known, only the part of the
 * free places that are good for more is measured. NaN where no place is good. Of N spheres p is that of an N + 1st.
 *
 * In a box at rest that repeats along all axes, of spheres that do not overlap; discs are inserted in their plane. Time
 * goes with [points]; they are drawn anew in each state, from its time, so that equal states have equal numbers.
 *
 * @param largest in length
 * @param points places that are tried in each state
 */
public class Insertion @JvmOverloads constructor(
    public val largest: Double,
    public val bins: Int = 20,
    private val points: Int = 10_000,
) : PooledMeasure {
    init {
        require(largest > 0 && largest.isFinite() && bins >= 1) { "$bins bins up to $largest; both must be positive" }
        require(points >= 1) { "$points places; there must be 1 at least" }
    }

    /** Diameter number [k] that is inserted, from 0 to [bins]. */
    public fun diameter(k: Int): Double = largest * k / bins

    /**
     * Good places by diameter, times the free part of the volume; that part is the last.
     *
     * @throws IllegalArgumentException where the box has faces or images that slide
     */
    override fun sums(state: State): DoubleArray {
        val cells = FreeRoom(state, largest / 2)
        val random = SeededRandom(state.time.toRawBits() xor state.population.size.toLong())
        val good = DoubleArray(bins + 2)
        repeat(points) {
            val room = cells.around(random)
            // Up to its last digits as large as that of the sphere.
            if (room >= 0) good[minOf((room * 2 / largest * bins * (1 + ROUNDING)).toInt(), bins)]++
        }
        for (k in bins - 1 downTo 0) good[k] += good[k + 1]
        good[bins + 1] = cells.free
        return good
    }

    override fun finish(sums: DoubleArray, states: Int): DoubleArray {
        val free = sums[bins + 1] / states
        return DoubleArray(bins + 1) { if (sums[it] > 0) -ln(free * sums[it] / sums[0]) else Double.NaN }
    }

    private companion object {
        const val ROUNDING = 1e-12
    }
}

/** Distances from points to the nearest surface, up to [reach] beyond it, by cells. */
private class FreeRoom(state: State, private val reach: Double) {
    private val p = state.population
    private val dimensions = state.dimensions
    private val box = state.boundary.box
    private val edge = DoubleArray(dimensions) { box.length(it) }
    private val low = DoubleArray(dimensions) { box.lower(it) }
    private val members = (0 until p.size).filter { state.isParticle(it) }.toIntArray()
    private val count: IntArray
    private val first: IntArray
    private val sorted: IntArray
    private val at = DoubleArray(dimensions)

    /** Part of the volume that spheres leave free. */
    val free: Double

    init {
        require((0 until dimensions).all { state.boundary.hasImages(it) } && state.boundary.shear == null) {
            "insertions are into a box at rest that repeats along all axes"
        }
        val far = (members.maxOfOrNull { p.radius[it] } ?: 0.0) + reach
        // No more cells than a few for each sphere.
        val most = Math.pow(CELLS_PER_SPHERE * members.size, 1.0 / dimensions).toInt() + 1
        count = IntArray(dimensions) { (edge[it] / far).toInt().coerceIn(1, most) }
        free = 1 - members.sumOf { state.boundary.space.volume(p.radius[it]) } / state.boundary.volume
        first = IntArray(count.fold(1) { n, c -> n * c } + 1)
        val cell = IntArray(members.size) { m -> cell { axis -> place(axis, p.position(axis)[members[m]]) } }
        for (c in cell) first[c + 1]++
        for (c in 1 until first.size) first[c] += first[c - 1]
        val next = first.copyOf()
        sorted = IntArray(members.size)
        for (m in members.indices) sorted[next[cell[m]]++] = members[m]
    }

    private fun place(axis: Int, x: Double) = floor((x - low[axis]) / edge[axis] * count[axis]).toInt().mod(count[axis])

    private inline fun cell(at: (Int) -> Int): Int {
        var c = 0
        for (axis in 0 until dimensions) c = c * count[axis] + at(axis)
        return c
    }

    /** Distance from a place that is drawn to the nearest surface; [reach] if that is farther, negative within one. */
    fun around(random: SeededRandom): Double {
        for (axis in 0 until dimensions) at[axis] = low[axis] + edge[axis] * random.nextDouble()
        var nearest = reach
        val deep = if (dimensions == 3) 1 else 0
        for (dx in -1..1) {
            for (dy in -1..1) {
                for (dz in -deep..deep) {
                    val c = cell { axis ->
                        (
                            place(axis, at[axis]) + (
                                if (axis == 0) {
                                    dx
                                } else if (axis == 1) {
                                    dy
                                } else {
                                    dz
                                }
                                )
                            ).mod(count[axis])
                    }
                    for (k in first[c] until first[c + 1]) {
                        nearest = minOf(nearest, distance(sorted[k]) - p.radius[sorted[k]])
                        if (nearest < 0) return nearest
                    }
                }
            }
        }
        return nearest
    }

    private fun distance(i: Int): Double {
        var square = 0.0
        for (axis in 0 until dimensions) {
            val d = p.position(axis)[i] - at[axis]
            val near = d - edge[axis] * Math.rint(d / edge[axis])
            square += near * near
        }
        return sqrt(square)
    }

    private companion object {
        const val CELLS_PER_SPHERE = 4.0
    }
}
