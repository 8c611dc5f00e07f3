package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * Static structure factor S(k) = |Σ exp(i k·r)|² / N for the wave vectors in the x-y plane that fit the periodic patch,
 * averaged over directions in bins of |k|, by bin from 0 to [largest]. Where images slide, wave vectors lean with them.
 * NaN in a bin without a wave vector.
 *
 * @param largest largest |k|, in 1/length
 */
public class StructureFactor(public val largest: Double, public val bins: Int) : Measure {
    init {
        require(largest > 0 && bins >= 1) { "$bins bins up to $largest; both must be positive" }
    }

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = (bin + 0.5) * largest / bins

    override fun of(state: State): DoubleArray {
        val images = PlaneImages(state.boundary, state.time)
        val lengthAcross = state.boundary.box.length(images.across)
        val unitAcross = 2 * PI / lengthAcross
        val unitAlong = 2 * PI / state.boundary.box.length(images.along)
        val sum = DoubleArray(bins)
        val count = IntArray(bins)
        val mostAcross = (largest / unitAcross).toInt() + 1
        val mostAlong = (largest / unitAlong).toInt() + 1
        // As many as take about a second per frame; of more, every k-th is taken.
        val stride = maxOf(1L, (2L * mostAcross + 1) * (mostAlong + 1) * state.population.size / MOST_WORK)
        var number = 0L
        for (m in 0..mostAlong) {
            // exp(i k·r) must be the same at an image: k·(L across, offset along) is a multiple of 2π.
            val lean = m * unitAlong * images.offset / lengthAcross
            val middle = Math.rint(lean / unitAcross).toInt()
            for (l in middle - mostAcross..middle + mostAcross) {
                if (m == 0 && l <= 0) continue
                if (number++ % stride != 0L) continue
                val across = l * unitAcross - lean
                val along = m * unitAlong
                val bin = (sqrt(across * across + along * along) / largest * bins).toInt()
                if (bin >= bins) continue
                sum[bin] += if (images.across == 0) power(state, across, along) else power(state, along, across)
                count[bin]++
            }
        }
        return DoubleArray(bins) { if (count[it] == 0) Double.NaN else sum[it] / count[it] }
    }

    private fun power(state: State, kx: Double, ky: Double): Double {
        val p = state.population
        var c = 0.0
        var s = 0.0
        var n = 0
        for (k in 0 until p.size) {
            if (!state.isParticle(k)) continue
            val phase = kx * p.x[k] + ky * p.y[k]
            c += cos(phase)
            s += sin(phase)
            n++
        }
        return if (n == 0) Double.NaN else (c * c + s * s) / n
    }

    private companion object {
        const val MOST_WORK = 30_000_000L
    }
}
