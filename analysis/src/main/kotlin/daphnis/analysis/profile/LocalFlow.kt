package daphnis.analysis.profile

import daphnis.analysis.neighbour.NeighbourLists
import daphnis.analysis.wave.LeastSquares

/**
 * The mean flow at each particle, as its neighbours tell it: of each component of the velocities [w] the polynomial of
 * second degree in the distance along the first [axes] axes that fits the neighbours best. Of fewer than ten neighbours
 * it is of first degree, of fewer than seven (along one axis: eight, six) their mean.
 *
 * @param reach of the neighbours in [lists]
 */
internal class LocalFlow(
    private val lists: NeighbourLists,
    private val w: Array<DoubleArray>,
    private val reach: Double,
    private val axes: Int,
) {
    private val degrees = (2 downTo 0).map { degree -> (1..axes).fold(1) { terms, k -> terms * (degree + k) / k } }
    private var basis = DoubleArray(0)

    /** Of the last particle: estimates of c² along each axis, without bias but of either sign. */
    val squares: DoubleArray = DoubleArray(w.size)

    /** Sets [squares] of particle [i]; false where it has fewer than two neighbours. */
    fun measure(i: Int): Boolean {
        val n = lists.count(i)
        if (n < 2) return false
        return degrees.any { terms -> (terms == 1 || n >= terms + SPARE) && fits(i, n, terms) }
    }

    /**
     * c² is the square of what is left of [i], less what the random motion of the neighbours adds to the flow: Σ q_j²
     * ⟨c_j²⟩, where q_j is the weight of neighbour j and ⟨c_j²⟩ what is left of it over its share 1 − h_j (MacKinnon &
     * White 1985, J. Econometrics 29, 305).
     */
    private fun fits(i: Int, n: Int, terms: Int): Boolean {
        fill(i, n, terms)
        val inverse = LeastSquares.inverse(
            Array(terms) { a -> DoubleArray(terms) { b -> (0 until n).sumOf { at(it, a, terms) * at(it, b, terms) } } },
        )?.first ?: return false
        if (!(inverse[0][0] <= MOST_NOISE)) return false
        val noise = DoubleArray(n)
        for (j in 0 until n) {
            var weight = 0.0
            var share = 1.0
            for (a in 0 until terms) {
                var product = 0.0
                for (b in 0 until terms) product += inverse[a][b] * at(j, b, terms)
                if (a == 0) weight = product
                share -= product * at(j, a, terms)
            }
            if (share < LEAST_SHARE) return false
            noise[j] = weight * weight / share
        }
        for (axis in w.indices) squares[axis] = square(i, w[axis], terms, inverse, noise)
        return true
    }

    private fun square(i: Int, v: DoubleArray, terms: Int, inverse: Array<DoubleArray>, noise: DoubleArray): Double {
        // Against that of i, so that a fast one loses no digits.
        val sums = DoubleArray(terms)
        for (j in noise.indices) {
            val e = v[lists.neighbour(i, j)] - v[i]
            for (a in 0 until terms) sums[a] += at(j, a, terms) * e
        }
        val flow = DoubleArray(terms) { a -> (0 until terms).sumOf { inverse[a][it] * sums[it] } }
        var square = flow[0] * flow[0]
        for (j in noise.indices) {
            var rest = v[lists.neighbour(i, j)] - v[i]
            for (a in 0 until terms) rest -= flow[a] * at(j, a, terms)
            square -= noise[j] * rest * rest
        }
        return square
    }

    private fun at(j: Int, term: Int, terms: Int) = basis[j * terms + term]

    /** 1, x, x², and in the plane 1, x, y, x², xy, y²: of each neighbour, in units of the reach. */
    private fun fill(i: Int, n: Int, terms: Int) {
        if (basis.size < n * terms) basis = DoubleArray(2 * n * terms)
        var k = 0
        for (j in 0 until n) {
            val x = lists.component(i, j, 0) / reach
            val y = if (axes == 1) 0.0 else lists.component(i, j, 1) / reach
            basis[k++] = 1.0
            if (terms > 1) basis[k++] = x
            if (terms > 1 && axes > 1) basis[k++] = y
            if (terms <= axes + 1) continue
            basis[k++] = x * x
            if (axes > 1) basis[k++] = x * y
            if (axes > 1) basis[k++] = y * y
        }
    }

    private companion object {
        /** Neighbours that there must be beyond the terms of a polynomial. */
        const val SPARE = 4

        /** Noise of the flow at a particle over that of a neighbour, squared, beyond which a lower degree is taken. */
        const val MOST_NOISE = 1.0

        /** Least 1 − h of a neighbour: the fit follows one that has less. */
        const val LEAST_SHARE = 0.02
    }
}
