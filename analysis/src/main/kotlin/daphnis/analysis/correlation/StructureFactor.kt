package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PatchState
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * Static structure factor S(k) = |Σ exp(i k·r)|² / N for the wave vectors in the x-y plane that fit the periodic patch, averaged over directions in bins of |k|, by bin
 * from 0 to [largest]. Where images slide, wave vectors lean with them. NaN in a bin without a wave vector.
 *
 * @param largest largest |k|, in 1/length
 */
public class StructureFactor(public val largest: Double, public val bins: Int) : Measure {
    init {
        require(largest > 0 && bins >= 1) { "$bins bins up to $largest; both must be positive" }
    }

    /** Middle of [bin]. */
    public fun centre(bin: Int): Double = (bin + 0.5) * largest / bins

    override fun of(state: PatchState): DoubleArray {
        val p = state.population
        val box = state.boundary.box
        val shear = state.boundary.shear
        val unitX = 2 * PI / box.length(0)
        val unitY = 2 * PI / box.length(1)
        val offset = shear?.offset(state.time) ?: 0.0
        val sum = DoubleArray(bins)
        val count = IntArray(bins)
        val mostX = (largest / unitX).toInt() + 1
        val mostY = (largest / unitY).toInt() + 1
        // So many that a frame takes a second or so; beyond, every so many-th.
        val stride = maxOf(1L, (2L * mostX + 1) * (mostY + 1) * p.size / MOST_WORK)
        var number = 0L
        for (m in 0..mostY) {
            for (l in -mostX..mostX) {
                if (m == 0 && l <= 0) continue
                if (number++ % stride != 0L) continue
                var kx = l * unitX
                var ky = m * unitY
                // exp(i k·r) must be the same at an image: k·(L along the normal axis, offset along the slide) is a multiple of 2π.
                if (shear != null && shear.normalAxis == 0) kx -= ky * offset / box.length(0)
                if (shear != null && shear.normalAxis == 1) ky -= kx * offset / box.length(1)
                val k = sqrt(kx * kx + ky * ky)
                val bin = (k / largest * bins).toInt()
                if (bin >= bins || k == 0.0) continue
                sum[bin] += power(state, kx, ky)
                count[bin]++
            }
        }
        return DoubleArray(bins) { if (count[it] == 0) Double.NaN else sum[it] / count[it] }
    }

    private fun power(state: PatchState, kx: Double, ky: Double): Double {
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
