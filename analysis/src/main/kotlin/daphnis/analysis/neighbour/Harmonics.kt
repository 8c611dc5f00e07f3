package daphnis.analysis.neighbour

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt

/** Spherical harmonics Y_lm of one degree [l] ≥ 1 for m = 0 … l: those of −m are (−1)^m times the conjugate. */
internal class Harmonics(private val l: Int) {
    private val norm = DoubleArray(l + 1) { m -> sqrt((2 * l + 1) / (4 * PI) * factorial(l - m) / factorial(l + m)) }

    /** Adds Y_lm of the direction (x, y, z), of length [r], to [sum], (Re, Im) by m. */
    fun add(x: Double, y: Double, z: Double, r: Double, sum: DoubleArray, at: Int) {
        val cosine = z / r
        val across = sqrt(x * x + y * y)
        // exp(iφ); of the pole any does, since P_lm is 0 there for m > 0.
        val c = if (across > 0) x / across else 1.0
        val s = if (across > 0) y / across else 0.0
        val sine = across / r
        var diagonal = 1.0
        var re = 1.0
        var im = 0.0
        for (m in 0..l) {
            val value = norm[m] * legendre(m, cosine, diagonal)
            sum[at + 2 * m] += value * re
            sum[at + 2 * m + 1] += value * im
            diagonal *= -(2 * m + 1) * sine
            val next = re * c - im * s
            im = re * s + im * c
            re = next
        }
    }

    /** P_lm from [diagonal] = P_mm, by the recurrence in l. */
    private fun legendre(m: Int, x: Double, diagonal: Double): Double {
        if (m == l) return diagonal
        var below = diagonal
        var value = x * (2 * m + 1) * diagonal
        for (n in m + 2..l) {
            val next = ((2 * n - 1) * x * value - (n + m - 1) * below) / (n - m)
            below = value
            value = next
        }
        return value
    }

    /**
     * Σ over m₁ + m₂ + m₃ = 0 of Wigner's 3j symbol times q_m₁ q_m₂ q_m₃, which is real.
     *
     * @param q (Re, Im) by m ≥ 0, from [at] on
     */
    fun third(q: DoubleArray, at: Int): Double {
        fun re(m: Int) = q[at + 2 * abs(m)] * sign(m)
        fun im(m: Int) = if (m < 0) -q[at - 2 * m + 1] * sign(m) else q[at + 2 * m + 1]
        var sum = 0.0
        for (a in -l..l) {
            for (b in maxOf(-l, -l - a)..minOf(l, l - a)) {
                val c = -a - b
                val r = re(a) * re(b) - im(a) * im(b)
                val i = re(a) * im(b) + im(a) * re(b)
                sum += symbols[(a + l) * (2 * l + 1) + b + l] * (r * re(c) - i * im(c))
            }
        }
        return sum
    }

    private fun sign(m: Int) = if (m < 0 && m % 2 != 0) -1.0 else 1.0

    /** 3j symbols (l l l; a b −a−b) by Racah's formula. */
    private val symbols = DoubleArray((2 * l + 1) * (2 * l + 1)).also { all ->
        val triangle = sqrt(factorial(l).pow(3) / factorial(3 * l + 1))
        for (a in -l..l) {
            for (b in maxOf(-l, -l - a)..minOf(l, l - a)) {
                val c = -a - b
                var sum = 0.0
                for (t in maxOf(0, -a, b)..minOf(l, l - a, l + b)) {
                    val part = factorial(t) * factorial(l - t) * factorial(l - a - t) * factorial(l + b - t) *
                        factorial(a + t) * factorial(t - b)
                    sum += (if (t % 2 == 0) 1 else -1) / part
                }
                val roots = listOf(a, b, c).fold(1.0) { p, m -> p * factorial(l + m) * factorial(l - m) }
                all[(a + l) * (2 * l + 1) + b + l] = (if (c % 2 == 0) 1 else -1) * triangle * sqrt(roots) * sum
            }
        }
    }

    private companion object {
        fun factorial(n: Int): Double = (2..n).fold(1.0) { p, k -> p * k }
    }
}
