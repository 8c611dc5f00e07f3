package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import daphnis.analysis.insitu.forEachPair
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * Contact values g_ab(σ_ab) of hard spheres by pairs of [groups], a ≤ b: pairs whose surfaces are up to [reach] of
 * their distance of contact apart are counted in ten bins of that share, over those that particles without correlation
 * would have, and a parabola through these is taken at contact. Where radii differ within a group, it is a mean over
 * its pairs, each at its own contact. As a [Measure] it gives [numbers] values, at [at] (a, b). NaN where there are no
 * such pairs.
 *
 * In a box with images along all axes, of discs along x and y: others need a correction for the room at faces.
 *
 * With the default reach, 60 runs of 256 equal spheres at a filling factor of 0.3 gave 2.493 ± 0.005 for 2.4925 (Kolafa,
 * Labík & Malijevský 2004, of so few), and one of 500 at 0.45 and 0.49 what Carnahan & Starling have, within its errors of 1 % (docs/reference/validation.md, Structure).
 *
 * @param reach share of the distance of contact, at most 1
 */
public class ContactValues @JvmOverloads constructor(
    private val groups: SphereGroups = SphereGroups.ALL,
    public val reach: Double = 0.1,
) : Measure {
    init {
        require(reach > 0 && reach <= 1) { "surfaces up to $reach contact distances apart; it must be in (0, 1]" }
    }

    /** Pairs of groups. */
    public val numbers: Int get() = groups.count * (groups.count + 1) / 2

    /** Place of the groups [a] and [b]; both orders are one. */
    public fun at(a: Int, b: Int): Int {
        val low = minOf(a, b)
        require(low >= 0 && maxOf(a, b) < groups.count) { "groups $a and $b; there are ${groups.count}, from 0 on" }
        return low * (2 * groups.count - low - 1) / 2 + maxOf(a, b)
    }

    /** @throws IllegalArgumentException where the box has faces, or is too small for the largest spheres */
    override fun of(state: State): DoubleArray {
        val d = state.dimensions
        val box = state.boundary.box
        require((0 until d).all { state.boundary.hasImages(it) }) { "contact values are of boxes without faces" }
        val radius = state.population.radius
        val group = IntArray(state.population.size) { if (state.isParticle(it)) groups.of(state, it) else -1 }
        val largest = group.indices.maxOfOrNull { if (group[it] < 0) 0.0 else radius[it] } ?: 0.0
        val far = 2 * largest * (1 + reach)
        // Of its own images none may be that near: all images of others count.
        require(far <= (0 until d).minOf { box.length(it) }) { "pairs up to $far; the box has no room for them" }
        val counts = Array(numbers) { DoubleArray(BINS) }
        forEachPair(state, far, d == 2) { i, j, square ->
            val contact = radius[i] + radius[j]
            if (group[i] >= 0 && group[j] >= 0 && square < contact * contact * (1 + reach) * (1 + reach)) {
                val share = (sqrt(square) / contact - 1) / reach
                // A pair that touches may seem to overlap by its last digits.
                if (share < 1 && share * reach > -ROUNDING) {
                    counts[at(group[i], group[j])][(maxOf(0.0, share) * BINS).toInt()]++
                }
            }
        }
        val result = DoubleArray(numbers)
        for (a in 0 until groups.count) {
            for (b in a until groups.count) result[at(a, b)] = value(counts[at(a, b)], expected(state, group, a, b), d)
        }
        return result
    }

    /** Σ σ_ij^d over the pairs of two groups, over the volume: what comes to be expected in a shell of ratios. */
    private fun expected(state: State, group: IntArray, a: Int, b: Int): Double {
        val radius = state.population.radius
        val d = state.dimensions
        fun moments(g: Int) = DoubleArray(d + 1) { m ->
            group.indices.sumOf { if (group[it] == g) Math.pow(radius[it], m.toDouble()) else 0.0 }
        }
        val first = moments(a)
        val second = moments(b)
        var sum = (0..d).sumOf { BINOMIAL[d - 2][it] * first[it] * second[d - it] }
        if (a == b) {
            // Not with itself, and each pair once.
            sum = (sum - Math.pow(2.0, d.toDouble()) * first[d]) / 2
        }
        return sum / state.boundary.box.let { if (d == 2) it.length(0) * it.length(1) else it.volume }
    }

    private fun value(counts: DoubleArray, expected: Double, dimensions: Int): Double {
        if (!(expected > 0)) return Double.NaN
        var sum = 0.0
        for (bin in 0 until BINS) {
            val low = 1 + reach * bin / BINS
            val high = 1 + reach * (bin + 1) / BINS
            val shell = if (dimensions == 2) PI * (high * high - low * low) else BALL * (high.cube() - low.cube())
            sum += WEIGHTS[bin] * counts[bin] / (expected * shell)
        }
        return sum
    }

    private fun Double.cube() = this * this * this

    private companion object {
        const val BINS = 10
        const val ROUNDING = 1e-5
        const val BALL = 4 * PI / 3
        val BINOMIAL = arrayOf(doubleArrayOf(1.0, 2.0, 1.0), doubleArrayOf(1.0, 3.0, 3.0, 1.0))

        /** Weights of values in the middles of bins that make the value at 0 of the parabola of least squares. */
        val WEIGHTS = DoubleArray(BINS).also { w ->
            // Σ w x^n = 0^n for n = 0, 1, 2 with w a parabola itself: by Legendre's polynomials of a discrete variable.
            val middle = (BINS - 1) / 2.0
            val second = (BINS * BINS - 1) / 12.0
            val p1 = DoubleArray(BINS) { it - middle }
            val p2 = DoubleArray(BINS) { p1[it] * p1[it] - second }
            val zero = -0.5 - middle
            val (n1, n2) = p1.sumOf { it * it } to p2.sumOf { it * it }
            for (k in 0 until BINS) w[k] = 1.0 / BINS + p1[k] * zero / n1 + p2[k] * (zero * zero - second) / n2
        }
    }
}
