package daphnis.analysis.profile

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * Velocity dispersion and height of particles by size. As a [Measure] it gives [COLUMNS] for each class of radii, entry
 * `class · COLUMNS.size + column`.
 *
 * | column | what |
 * |---|---|
 * | count | particles in the class |
 * | mean_radius | their mean radius |
 * | c_xx, c_yy, c_zz | ⟨c_a²⟩ by number, c around the mean flow and the centre of mass of all particles |
 * | c2 | ⟨c²⟩, the sum of the three |
 * | h2 | ⟨(z − z₀)²⟩, z₀ the centre of mass of all |
 *
 * A sphere with a share μ of all mass moves the centre of mass along, which reduces the plain mean square by about 2μ.
 * This is corrected, for spheres with independent velocities as well as for those that share one temperature. Means of
 * an empty class are NaN. All means are NaN if a class has spheres with half of all mass each.
 *
 * @param edges lower edges of the classes and the upper edge of the last, ascending; the last class includes its upper
 *   edge
 */
public class DispersionBySize(private val edges: DoubleArray) : Measure {
    /** Number of classes. */
    public val classes: Int = edges.size - 1

    init {
        require(classes >= 1 && (0 until classes).all { edges[it] < edges[it + 1] }) {
            "edges are ${edges.asList()}; they must ascend"
        }
    }

    override fun of(state: State): DoubleArray {
        val p = state.population
        val all = (0 until p.size).filter { state.isParticle(it) }.toIntArray()
        val share = all.sumOf { p.mass[it] }.let { mass -> DoubleArray(p.size) { p.mass[it] / mass } }
        val result = DoubleArray(classes * WIDTH)
        for (k in all) {
            val at = classOf(p.radius[k]) * WIDTH
            if (at < 0) continue
            result[at]++
            result[at + 1] += p.radius[k]
        }
        for (c in 0 until classes) result[c * WIDTH + 1] /= result[c * WIDTH]
        for (axis in 0..2) put(result, 2 + axis, meanSquares(p.radius, share, all) { state.againstFlow(it, axis) })
        for (c in 0 until classes) result[c * WIDTH + C2] = (2..4).sumOf { result[c * WIDTH + it] }
        put(result, H2, meanSquares(p.radius, share, all) { p.z[it] })
        return result
    }

    private fun put(result: DoubleArray, column: Int, values: DoubleArray) {
        for (c in 0 until classes) result[c * WIDTH + column] = values[c]
    }

    /**
     * With V = Σ μ_k v_k and S the sum of (v_k − V)² of a class of n, ⟨S⟩ = σ² Σ (1 − 2μ_k) + n W, W = Σ_all μ_k² σ_k²
     * being ⟨V²⟩: solved for the σ² of all classes at once.
     */
    private inline fun meanSquares(
        radius: DoubleArray,
        share: DoubleArray,
        all: IntArray,
        value: (Int) -> Double,
    ): DoubleArray {
        var centre = 0.0
        for (k in all) centre += share[k] * value(k)
        val count = DoubleArray(classes)
        val square = DoubleArray(classes)
        val free = DoubleArray(classes)
        val pull = DoubleArray(classes)
        for (k in all) {
            val c = classOf(radius[k])
            if (c < 0) continue
            val d = value(k) - centre
            count[c]++
            square[c] += d * d
            free[c] += 1 - 2 * share[k]
            pull[c] += share[k] * share[k]
        }
        val filled = (0 until classes).filter { count[it] > 0 }
        if (filled.any { free[it] <= 0 }) return DoubleArray(classes) { Double.NaN }
        val ofCentre =
            filled.sumOf { pull[it] * square[it] / free[it] } / (1 + filled.sumOf { pull[it] * count[it] / free[it] })
        return DoubleArray(classes) {
            if (count[it] == 0.0) {
                Double.NaN
            } else {
                maxOf(0.0, (square[it] - count[it] * ofCentre) / free[it])
            }
        }
    }

    private fun classOf(radius: Double): Int {
        if (radius < edges[0] || radius > edges[classes]) return -1
        var c = 0
        while (c < classes - 1 && radius >= edges[c + 1]) c++
        return c
    }

    public companion object {
        @JvmField
        public val COLUMNS: List<String> = listOf("count", "mean_radius", "c_xx", "c_yy", "c_zz", "c2", "h2")
        private val WIDTH = COLUMNS.size
        private const val C2 = 5
        private const val H2 = 6
        private const val SAME = 1e-9

        /**
         * Classes for the particles of [sample]: one for each radius when there are at most [most], else [most] of
         * equal width in ln r. Null for one size.
         */
        @JvmStatic
        @JvmOverloads
        public fun of(sample: State, most: Int = 8): DispersionBySize? {
            val p = sample.population
            val radii = (0 until p.size).filter { sample.isParticle(it) }.map { p.radius[it] }.sorted()
            val distinct = ArrayList<Double>()
            for (r in radii) if (distinct.isEmpty() || abs(r / distinct.last() - 1) > SAME) distinct += r
            if (distinct.size < 2) return null
            val ratio = radii.last() / radii.first()
            val edges = if (distinct.size <= most) {
                DoubleArray(distinct.size + 1) {
                    sqrt(distinct[maxOf(0, it - 1)] * distinct[minOf(it, distinct.size - 1)])
                }
            } else {
                DoubleArray(most + 1) {
                    if (it == most) {
                        radii.last()
                    } else {
                        radii.first() * ratio.pow(it / most.toDouble())
                    }
                }
            }
            return DispersionBySize(edges)
        }
    }
}
