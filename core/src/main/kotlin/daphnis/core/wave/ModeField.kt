package daphnis.core.wave

import kotlin.math.sqrt

/**
 * A field u(x) = a₀ + Σ (a_m cos k_m x + b_m sin k_m x), m up to [modes], that fits numbers of spheres best by least
 * squares weighted by mass. The normal equations are of sums over the spheres alone, those of twice as many harmonics
 * of the masses among them; they are solved by Cholesky's decomposition.
 */
internal class ModeField(private val modes: Int) {
    private val unknowns = 2 * modes + 1
    private val factor = Array(unknowns) { DoubleArray(unknowns) }

    /** a₀, then all a_m, then all b_m, of [COMPONENTS] fields. */
    val coefficients: Array<DoubleArray> = Array(COMPONENTS) { DoubleArray(unknowns) }

    /** Coefficient a_m of [component]; a₀ for [m] = 0. */
    fun cosine(component: Int, m: Int): Double = coefficients[component][m]

    /** Coefficient b_m of [component]; 0 for [m] = 0. */
    fun sine(component: Int, m: Int): Double = if (m == 0) 0.0 else coefficients[component][modes + m]

    /**
     * Fits both components.
     *
     * @param masses of twice as many harmonics as there are modes
     * @param momenta by component
     * @return whether the spheres tell them; if not, the coefficients mean nothing
     */
    fun fit(masses: HarmonicSums, momenta: Array<HarmonicSums>): Boolean {
        if (!decompose(masses)) return false
        for (component in 0 until COMPONENTS) solve(momenta[component], coefficients[component])
        return true
    }

    /** The integral of two of the functions over the masses, by products of cosines and sines. */
    private fun product(masses: HarmonicSums, row: Int, column: Int): Double {
        val isSine = row > modes
        val isOtherSine = column > modes
        val m = if (isSine) row - modes else row
        val n = if (isOtherSine) column - modes else column
        return when {
            !isSine && !isOtherSine -> (masses.cosine(Math.abs(m - n)) + masses.cosine(m + n)) / 2
            isSine && isOtherSine -> (masses.cosine(Math.abs(m - n)) - masses.cosine(m + n)) / 2
            isSine -> (masses.sine(m + n) + signed(masses, m - n)) / 2
            else -> (masses.sine(m + n) + signed(masses, n - m)) / 2
        }
    }

    private fun signed(masses: HarmonicSums, m: Int) = if (m < 0) -masses.sine(-m) else masses.sine(m)

    private fun decompose(masses: HarmonicSums): Boolean {
        val least = masses.cosine(0) * SINGULAR
        for (row in 0 until unknowns) {
            val f = factor[row]
            for (column in 0..row) {
                val g = factor[column]
                var rest = product(masses, row, column)
                for (k in 0 until column) rest -= f[k] * g[k]
                if (column < row) {
                    f[column] = rest / g[column]
                } else {
                    if (!(rest > least)) return false
                    f[row] = sqrt(rest)
                }
            }
        }
        return true
    }

    private fun solve(momenta: HarmonicSums, into: DoubleArray) {
        for (row in 0 until unknowns) {
            var rest = if (row > modes) momenta.sine(row - modes) else momenta.cosine(row)
            for (k in 0 until row) rest -= factor[row][k] * into[k]
            into[row] = rest / factor[row][row]
        }
        for (row in unknowns - 1 downTo 0) {
            var rest = into[row]
            for (k in row + 1 until unknowns) rest -= factor[k][row] * into[k]
            into[row] = rest / factor[row][row]
        }
    }

    companion object {
        const val COMPONENTS = 2

        /** What is left of a function without those before it, over the mass, below which the spheres tell nothing. */
        private const val SINGULAR = 1e-9
    }
}
