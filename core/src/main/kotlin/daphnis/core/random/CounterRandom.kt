package daphnis.core.random

import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Random numbers without a state: each is a function of a seed and of what it is for, so threads, machines, a resume
 * and the order of spheres cannot matter. Philox 4x32-10 (Salmon, Moraes, Dror & Shaw 2011, Proc. SC '11, 16), whose
 * key is [seed] and whose counter is a sphere, a time and a stream. One [draw] gives four words of 32 bits each. Made
 * once by each worker; allocates nothing. Not thread-safe; not for cryptography.
 */
internal class CounterRandom(seed: Long) {
    private val keyLow = seed.toInt()
    private val keyHigh = (seed ushr 32).toInt()
    private val words = IntArray(4)

    /** Word [k], in 0..3, of the last draw. */
    fun word(k: Int): Int = words[k]

    /** Draws the words of sphere [id] at [time] in [stream]. */
    fun draw(id: Int, time: Double, stream: Int) {
        val bits = time.toRawBits()
        draw(id, bits.toInt(), (bits ushr 32).toInt(), stream)
    }

    /** Draws the words of a counter of four words. */
    fun draw(a: Int, b: Int, c: Int, d: Int) {
        var c0 = a
        var c1 = b
        var c2 = c
        var c3 = d
        var k0 = keyLow
        var k1 = keyHigh
        repeat(ROUNDS) {
            val p0 = (c0.toLong() and WORD) * FIRST
            val p1 = (c2.toLong() and WORD) * SECOND
            c0 = (p1 ushr 32).toInt() xor c1 xor k0
            c1 = p1.toInt()
            c2 = (p0 ushr 32).toInt() xor c3 xor k1
            c3 = p0.toInt()
            k0 += FIRST_STEP
            k1 += SECOND_STEP
        }
        words[0] = c0
        words[1] = c1
        words[2] = c2
        words[3] = c3
    }

    /** Uniform in (0, 1), from word [k]: an odd multiple of 2⁻³³. */
    fun uniform(k: Int): Double = ((words[k].toLong() and WORD) + 0.5) * UNIT

    /** Standard normal, from word [k]; at most 6.3 in size. */
    fun gaussian(k: Int): Double = quantile(uniform(k))

    internal companion object {
        private const val ROUNDS = 10
        private const val WORD = 0xffffffffL
        private const val FIRST = 0xD2511F53L
        private const val SECOND = 0xCD9E8D57L
        private const val FIRST_STEP = -0x61c88647
        private const val SECOND_STEP = -0x4498517b
        private const val UNIT = 1.0 / (1L shl 32)

        /**
         * The standard normal quantile of [p], which is between 2e-11 and 1 − 2e-11, to 16 digits (algorithm AS 241,
         * Wichura 1988, Appl. Stat. 37, 477, without the branch for the farthest tails).
         */
        fun quantile(p: Double): Double {
            val q = p - 0.5
            if (abs(q) <= CENTRAL) {
                val r = CENTRAL * CENTRAL - q * q
                return q * polynomial(A, r) / polynomial(B, r)
            }
            val r = sqrt(-StrictMath.log(if (q < 0) p else 1 - p)) - NEAR
            val x = polynomial(C, r) / polynomial(D, r)
            return if (q < 0) -x else x
        }

        private fun polynomial(c: DoubleArray, r: Double): Double =
            ((((((c[7] * r + c[6]) * r + c[5]) * r + c[4]) * r + c[3]) * r + c[2]) * r + c[1]) * r + c[0]

        private const val CENTRAL = 0.425
        private const val NEAR = 1.6
        private val A = doubleArrayOf(
            3.3871328727963666080e0,
            1.3314166789178437745e2,
            1.9715909503065514427e3,
            1.3731693765509461125e4,
            4.5921953931549871457e4,
            6.7265770927008700853e4,
            3.3430575583588128105e4,
            2.5090809287301226727e3,
        )
        private val B = doubleArrayOf(
            1.0,
            4.2313330701600911252e1,
            6.8718700749205790830e2,
            5.3941960214247511077e3,
            2.1213794301586595867e4,
            3.9307895800092710610e4,
            2.8729085735721942674e4,
            5.2264952788528545610e3,
        )
        private val C = doubleArrayOf(
            1.42343711074968357734e0,
            4.63033784615654529590e0,
            5.76949722146069140550e0,
            3.64784832476320460504e0,
            1.27045825245236838258e0,
            2.41780725177450611770e-1,
            2.27238449892691845833e-2,
            7.74545014278341407640e-4,
        )
        private val D = doubleArrayOf(
            1.0,
            2.05319162663775882187e0,
            1.67638483018380384940e0,
            6.89767334985100004550e-1,
            1.48103976427480074590e-1,
            1.51986665636164571966e-2,
            5.47593808499534494600e-4,
            1.05075007164441684324e-9,
        )
    }
}
