package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State

/**
 * The structure factor at wave number 0, S(0⁺), which is n kT times the isothermal compressibility of a fluid in
 * equilibrium. As a [Measure] it gives this one number: the value at 0 of the parabola in k² that fits |Σ exp(i
 * k·r)|²/N best, over the wave vectors that fit the box with |k| up to [reach]; of many, 400 of the longest waves. A
 * number of one state is linear in these squares, so its mean over states has no bias but that of the parabola. With k
 * σ up to 2.5, 60 runs of 256 hard spheres at a filling factor of 0.3 gave 0.0981 ± 0.0009 for 0.0976, and one of 500
 * at 0.45 and 0.49 what Carnahan & Starling have, within its errors of 10 % (docs/reference/validation.md, Structure). NaN for
 * fewer than 20 vectors.
 *
 * @param reach largest |k|, in 1/length
 */
public class LongWaveLimit(public val reach: Double) : Measure {
    init {
        require(reach > 0 && reach.isFinite()) { "wave numbers up to $reach; it must be positive" }
    }

    override fun of(state: State): DoubleArray {
        val particles = (0 until state.population.size).filter { state.isParticle(it) }.toIntArray()
        if (particles.isEmpty()) return doubleArrayOf(Double.NaN)
        // The ball of so many vectors, by their density in space.
        val dimensions = (0..2).filter { state.boundary.hasImages(it) }
        val cell = dimensions.fold(1.0) { v, axis -> v * 2 * Math.PI / state.boundary.box.length(axis) }
        val ball = 2 * MOST * cell / BALL[dimensions.size]
        val largest = minOf(reach, Math.pow(ball, 1.0 / dimensions.size.coerceAtLeast(1)))
        val vectors = WaveVectors(state.boundary, state.time, largest, 1, Int.MAX_VALUE)
        if (vectors.size < FEWEST) return doubleArrayOf(Double.NaN)
        val (c, s) = WaveSums(state, vectors).over(particles, listOf(null))[0]
        val x = DoubleArray(vectors.size) { vectors.length(it).let { k -> k * k / (largest * largest) } }
        return doubleArrayOf(atZero(x) { (c[it] * c[it] + s[it] * s[it]) / particles.size })
    }

    /** At x = 0, of the parabola that fits [y] over [x] by least squares. */
    private inline fun atZero(x: DoubleArray, y: (Int) -> Double): Double {
        val m = DoubleArray(5)
        val v = DoubleArray(3)
        for (j in x.indices) {
            var power = 1.0
            for (n in 0 until 5) {
                m[n] += power
                if (n < 3) v[n] += power * y(j)
                power *= x[j]
            }
        }
        // Cramer's rule.
        val one = m[2] * m[4] - m[3] * m[3]
        val two = m[1] * m[4] - m[2] * m[3]
        val three = m[1] * m[3] - m[2] * m[2]
        return (v[0] * one - v[1] * two + v[2] * three) / (m[0] * one - m[1] * two + m[2] * three)
    }

    private companion object {
        const val MOST = 400
        const val FEWEST = 20

        /** Volume of a ball of radius 1, by dimensions. */
        val BALL = doubleArrayOf(1.0, 2.0, Math.PI, 4 * Math.PI / 3)
    }
}
