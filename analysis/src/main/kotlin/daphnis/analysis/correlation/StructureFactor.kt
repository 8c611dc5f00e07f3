package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.hypot
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

    /** Mean |k| of the wave vectors that are taken of [state], by bin; the middle of a bin without any. */
    public fun waveNumbers(state: State): DoubleArray {
        val sum = DoubleArray(bins)
        val count = IntArray(bins)
        val waves = waves(state)
        for (row in waves.rows) {
            for ((j, bin) in row.bins.withIndex()) {
                sum[bin] += hypot(row.first + j * waves.step, row.along)
                count[bin]++
            }
        }
        return DoubleArray(bins) { if (count[it] == 0) (it + 0.5) * largest / bins else sum[it] / count[it] }
    }

    override fun of(state: State): DoubleArray {
        val waves = waves(state)
        waves.sum()
        return byBin(waves.rows, (0 until state.population.size).count(state::isParticle))
    }

    private fun waves(state: State): Waves {
        val images = PlaneImages(state.boundary, state.time)
        val lengthAcross = state.boundary.box.length(images.across)
        val unitAcross = 2 * PI / lengthAcross
        val unitAlong = 2 * PI / state.boundary.box.length(images.along)
        // Of more than can be summed in a moment, every k-th is taken.
        val mostAcross = (largest / unitAcross).toInt() + 1
        val mostAlong = (largest / unitAlong).toInt() + 1
        val stride = maxOf(1L, (2L * mostAcross + 1) * (mostAlong + 1) * state.population.size / MOST_WORK)
        val rows = mutableListOf<Row>()
        var number = 0L
        for (m in 0..mostAlong) {
            // exp(i k·r) must be the same at an image: k·(L across, offset along) is a multiple of 2π.
            val lean = m * unitAlong * images.offset / lengthAcross
            val middle = Math.rint(lean / unitAcross).toInt()
            val along = m * unitAlong
            var first = 0.0
            val binsOfRow = mutableListOf<Int>()
            for (l in middle - mostAcross..middle + mostAcross) {
                if (m == 0 && l <= 0) continue
                if (number++ % stride != 0L) continue
                val across = l * unitAcross - lean
                val bin = (sqrt(across * across + along * along) / largest * bins).toInt()
                if (bin >= bins) continue
                if (binsOfRow.isEmpty()) first = across
                binsOfRow += bin
            }
            if (binsOfRow.isNotEmpty()) rows += Row(first, along, binsOfRow.toIntArray())
        }
        return Waves(state, images.across, stride * unitAcross, rows)
    }

    private fun byBin(rows: List<Row>, particles: Int): DoubleArray {
        val sum = DoubleArray(bins)
        val count = IntArray(bins)
        for (row in rows) {
            for ((j, bin) in row.bins.withIndex()) {
                sum[bin] += (row.re[j] * row.re[j] + row.im[j] * row.im[j]) / particles
                count[bin]++
            }
        }
        return DoubleArray(bins) { if (count[it] == 0) Double.NaN else sum[it] / count[it] }
    }

    /**
     * Wave vectors in a row, each one step further across than the one before.
     *
     * @property first component across of the first; all have [along]
     * @property bins of each
     */
    private class Row(val first: Double, val along: Double, val bins: IntArray) {
        /** Σ cos k·r of each wave vector, and in [im] Σ sin k·r. */
        val re = DoubleArray(bins.size)
        val im = DoubleArray(bins.size)
    }

    /**
     * Sums exp(i k·r) of wave vectors in [rows], which are [step] apart. In a row it is exp(i k·r) of the first wave
     * vector times a power of exp(i step x) that is the same in all rows; so cosines and sines are taken once per row
     * and particle. The n-th power, from n products, is wrong by less than n · 3e-16.
     *
     * Particles are taken in blocks whose powers stay in the cache. The sums of a row do not wait for one another.
     *
     * @param axis along which a row goes, 0 or 1
     */
    private class Waves(state: State, axis: Int, val step: Double, val rows: List<Row>) {
        private val onRow = places(state, axis)
        private val beside = places(state, 1 - axis)

        private fun places(state: State, axis: Int): DoubleArray {
            val all = state.population.position(axis)
            return all.indices.filter(state::isParticle).map { all[it] }.toDoubleArray()
        }

        /** Adds all particles to the sums of the rows. */
        fun sum() {
            val width = rows.maxOfOrNull { it.bins.size } ?: return
            val re = Array(BLOCK) { DoubleArray(width) }
            val im = Array(BLOCK) { DoubleArray(width) }
            for (from in onRow.indices step BLOCK) {
                val size = minOf(BLOCK, onRow.size - from)
                for (k in 0 until size) powers(step * onRow[from + k], re[k], im[k])
                for (row in rows) {
                    for (k in 0 until size) {
                        val phase = row.first * onRow[from + k] + row.along * beside[from + k]
                        add(cos(phase), sin(phase), re[k], im[k], row.re, row.im)
                    }
                }
            }
        }

        /** exp(i n [phase]) for n = 0, 1, … */
        private fun powers(phase: Double, re: DoubleArray, im: DoubleArray) {
            val c = cos(phase)
            val s = sin(phase)
            re[0] = 1.0
            im[0] = 0.0
            for (n in 1 until re.size) {
                re[n] = re[n - 1] * c - im[n - 1] * s
                im[n] = re[n - 1] * s + im[n - 1] * c
            }
        }

        /** Adds ([c] + i [s]) (re + i im) to the sums of a row. */
        private fun add(
            c: Double,
            s: Double,
            re: DoubleArray,
            im: DoubleArray,
            sumRe: DoubleArray,
            sumIm: DoubleArray,
        ) {
            for (n in sumRe.indices) sumRe[n] += c * re[n] - s * im[n]
            for (n in sumIm.indices) sumIm[n] += c * im[n] + s * re[n]
        }
    }

    private companion object {
        const val MOST_WORK = 30_000_000L
        private const val BLOCK = 32
    }
}
