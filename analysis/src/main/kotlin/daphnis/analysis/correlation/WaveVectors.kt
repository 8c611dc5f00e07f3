package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.core.boundary.BoundaryConditions
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Wave vectors that fit a box, in shells of |k| from 0 to [largest]: along the axes that have images, and leaning with
 * images that have slid. Of k and −k, which tell the same, one is there. Of a shell that has more than [most], so many
 * are taken, spread over the shell: the same ones for equal boxes. Vectors shorter than [least] are left out.
 */
internal class WaveVectors(
    private val boundary: BoundaryConditions,
    time: Double,
    private val largest: Double,
    private val shells: Int,
    most: Int,
    private val least: Double = 0.0,
) {
    private val shear = boundary.shear?.takeIf { boundary.hasImages(it.normalAxis) && boundary.hasImages(it.slideAxis) }
    private val lean = shear?.let { it.offset(time) / boundary.box.length(it.normalAxis) } ?: 0.0
    private val unit = DoubleArray(AXES) { if (boundary.hasImages(it)) 2 * PI / boundary.box.length(it) else 0.0 }

    /** Waves along each axis, `[axis][vector]`, see [phase]; those along the first are ≥ 0. */
    val orders: Array<IntArray>

    /** Shell of each vector. */
    val shell: IntArray

    /** Number of vectors. */
    val size: Int get() = shell.size

    init {
        val counts = LongArray(shells)
        each(largest, shells) { s, _, _, _ -> counts[s]++ }
        val found = List(AXES + 1) { ArrayList<Int>() }
        val seen = LongArray(shells)
        each(largest, shells) { s, x, y, z ->
            // Number j of c is taken where j·most/c steps up: evenly spread.
            val j = seen[s]++
            val c = counts[s]
            if (c <= most || (j + 1) * most / c > j * most / c) {
                for ((list, value) in found.zip(intArrayOf(x, y, z, s).asList())) list += value
            }
        }
        orders = Array(AXES) { found[it].toIntArray() }
        shell = found[AXES].toIntArray()
    }

    private inline fun each(largest: Double, shells: Int, action: (shell: Int, x: Int, y: Int, z: Int) -> Unit) {
        val reach = IntArray(AXES) { if (unit[it] > 0) (largest / unit[it]).toInt() + 1 else 0 }
        // The lean of up to a half of a box adds up to half as many waves across.
        shear?.let { reach[it.normalAxis] += (abs(lean) * largest / unit[it.normalAxis]).toInt() + 1 }
        for (x in 0..reach[0]) {
            for (y in (if (x == 0) 0 else -reach[1])..reach[1]) {
                for (z in (if (x == 0 && y == 0) 1 else -reach[2])..reach[2]) {
                    val length = length(x, y, z)
                    val s = (length / largest * shells).toInt()
                    if (s < shells && length >= least) action(s, x, y, z)
                }
            }
        }
    }

    private fun length(x: Int, y: Int, z: Int): Double {
        val k = DoubleArray(AXES) { component(it, x, y, z) }
        return sqrt(k[0] * k[0] + k[1] * k[1] + k[2] * k[2])
    }

    /** exp(i k·r) must be the same at an image: k·(L across, offset along) is a multiple of 2π. */
    private fun component(axis: Int, x: Int, y: Int, z: Int): Double {
        fun straight(a: Int) = unit[a] * (
            if (a == 0) {
                x
            } else if (a == 1) {
                y
            } else {
                z
            }
            )
        val own = straight(axis)
        return if (axis == shear?.normalAxis) own - lean * straight(shear.slideAxis) else own
    }

    /** Mean |k| of the vectors of each shell; its middle for one without any. */
    fun meanLengths(): DoubleArray {
        val sum = DoubleArray(shells)
        val count = IntArray(shells)
        for (j in 0 until size) {
            sum[shell[j]] += length(j)
            count[shell[j]]++
        }
        return DoubleArray(shells) { if (count[it] == 0) (it + 0.5) * largest / shells else sum[it] / count[it] }
    }

    /** Component along [axis] of vector [j]. */
    fun component(axis: Int, j: Int): Double = component(axis, orders[0][j], orders[1][j], orders[2][j])

    /** |k| of vector [j]. */
    fun length(j: Int): Double = length(orders[0][j], orders[1][j], orders[2][j])

    /**
     * Phase of one wave along [axis] at the sphere at [index] of [state]: k·r is the sum over axes of their orders
     * times these.
     */
    fun phase(state: State, axis: Int, index: Int): Double {
        val p = state.population
        val at = p.position(axis)[index]
        if (axis != shear?.slideAxis) return unit[axis] * at
        return unit[axis] * (at - lean * p.position(shear.normalAxis)[index])
    }

    internal companion object {
        /** As many vectors of a shell are taken in any case, as long as this is less than [MOST_AT_LEAST]. */
        private const val LEAST = 30L

        /** Products of particles and vectors, a second's work. */
        private const val MOST_AT_LEAST = 200_000_000L

        /** Vectors of each of [shells] for about [work] products with [particles]. */
        fun most(work: Long, particles: Int, shells: Int): Int {
            val cost = maxOf(1, particles).toLong() * shells
            return maxOf(
                work / cost,
                minOf(LEAST, MOST_AT_LEAST / cost),
                1L,
            ).coerceAtMost(Int.MAX_VALUE.toLong()).toInt()
        }

        const val AXES = 3
    }
}
