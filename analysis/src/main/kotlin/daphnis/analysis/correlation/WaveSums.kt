package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * Sums Σ q exp(i k·r) over spheres of [state] for all [vectors]. exp(i k·r) is a product of powers of three phases,
 * which are taken once per sphere; so cosines and sines do not cost for each vector. The n-th power, from n products,
 * is wrong by less than n · 3e-16. Spheres are taken in blocks whose powers stay in the cache.
 */
internal class WaveSums(private val state: State, private val vectors: WaveVectors) {
    private val most = IntArray(AXES) { axis -> vectors.orders[axis].maxOfOrNull { abs(it) } ?: 0 }

    /** `[axis][power][sphere of the block]`. */
    private val re = Array(AXES) { axis -> Array(most[axis] + 1) { DoubleArray(BLOCK) } }
    private val im = Array(AXES) { axis -> Array(most[axis] + 1) { DoubleArray(BLOCK) } }
    private val planeRe = DoubleArray(BLOCK)
    private val planeIm = DoubleArray(BLOCK)
    private val cosines = DoubleArray(BLOCK)
    private val sines = DoubleArray(BLOCK)

    /**
     * Sums over the spheres at [indices] of each of the [quantities], by index in the population; null for 1. Gives
     * Σ q cos k·r and Σ q sin k·r, `[quantity][0 or 1][vector]`.
     */
    fun over(indices: IntArray, quantities: List<DoubleArray?>): List<Array<DoubleArray>> {
        val sums = quantities.map { Array(2) { DoubleArray(vectors.size) } }
        val weights = DoubleArray(BLOCK)
        for (from in indices.indices step BLOCK) {
            val size = minOf(BLOCK, indices.size - from)
            for (k in 0 until size) powers(indices[from + k], k)
            for (j in 0 until vectors.size) {
                multiply(j, size)
                for (q in quantities.indices) {
                    val quantity = quantities[q]
                    val (c, s) = sums[q]
                    if (quantity == null) {
                        c[j] += sum(cosines, size)
                        s[j] += sum(sines, size)
                    } else {
                        for (k in 0 until size) weights[k] = quantity[indices[from + k]]
                        c[j] += product(weights, cosines, size)
                        s[j] += product(weights, sines, size)
                    }
                }
            }
        }
        return sums
    }

    private fun powers(index: Int, at: Int) {
        for (axis in 0 until AXES) {
            val r = re[axis]
            val i = im[axis]
            val phase = vectors.phase(state, axis, index)
            val c = cos(phase)
            val s = sin(phase)
            r[0][at] = 1.0
            i[0][at] = 0.0
            for (n in 1..most[axis]) {
                r[n][at] = r[n - 1][at] * c - i[n - 1][at] * s
                i[n][at] = r[n - 1][at] * s + i[n - 1][at] * c
            }
        }
    }

    /** exp(i k·r) of vector [j] at the spheres of the block. */
    private fun multiply(j: Int, size: Int) {
        val (x, y, z) = vectors.orders
        if (j == 0 || x[j] != x[j - 1] || y[j] != y[j - 1]) multiply(x[j], y[j], size)
        val zr = re[2][abs(z[j])]
        val zi = im[2][abs(z[j])]
        val sign = if (z[j] < 0) -1.0 else 1.0
        for (k in 0 until size) {
            cosines[k] = planeRe[k] * zr[k] - planeIm[k] * zi[k] * sign
            sines[k] = planeRe[k] * zi[k] * sign + planeIm[k] * zr[k]
        }
    }

    /** Of the part of k·r in the plane: vectors that share it follow one another. */
    private fun multiply(x: Int, y: Int, size: Int) {
        val xr = re[0][x]
        val xi = im[0][x]
        val yr = re[1][abs(y)]
        val yi = im[1][abs(y)]
        val sign = if (y < 0) -1.0 else 1.0
        for (k in 0 until size) {
            planeRe[k] = xr[k] * yr[k] - xi[k] * yi[k] * sign
            planeIm[k] = xr[k] * yi[k] * sign + xi[k] * yr[k]
        }
    }

    /** In four sums, which do not wait for one another. */
    private fun sum(a: DoubleArray, size: Int): Double {
        var s = 0.0
        var t = 0.0
        var u = 0.0
        var v = 0.0
        var k = 0
        while (k + 3 < size) {
            s += a[k]
            t += a[k + 1]
            u += a[k + 2]
            v += a[k + 3]
            k += 4
        }
        while (k < size) s += a[k++]
        return s + t + (u + v)
    }

    private fun product(w: DoubleArray, a: DoubleArray, size: Int): Double {
        var sum = 0.0
        for (k in 0 until size) sum += w[k] * a[k]
        return sum
    }

    private companion object {
        const val AXES = 3
        const val BLOCK = 32
    }
}
