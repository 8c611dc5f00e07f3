package daphnis.core.initial

import kotlin.math.sqrt

/**
 * xoshiro256++ 1.0 (Blackman & Vigna 2021, ACM Trans. Math. Softw. 47, 36; public domain), its state filled by
 * SplitMix64. Our own, so that a seed means the same numbers in every version of Kotlin and Java. Not thread-safe; not
 * for cryptography.
 */
public class SeededRandom(seed: Long) {
    private var s0: Long
    private var s1: Long
    private var s2: Long
    private var s3: Long
    private var spare = Double.NaN

    init {
        var z = seed
        fun next(): Long {
            z += -0x61c8864680b583ebL
            var r = z
            r = (r xor (r ushr 30)) * -0x40a7b892e31b1a47L
            r = (r xor (r ushr 27)) * -0x6b2fb644ecceee15L
            return r xor (r ushr 31)
        }
        s0 = next()
        s1 = next()
        s2 = next()
        s3 = next()
    }

    /** 64 random bits. */
    public fun nextLong(): Long {
        val result = (s0 + s3).rotateLeft(23) + s0
        val t = s1 shl 17
        s2 = s2 xor s0
        s3 = s3 xor s1
        s1 = s1 xor s2
        s0 = s0 xor s3
        s2 = s2 xor t
        s3 = s3.rotateLeft(45)
        return result
    }

    /** Uniform in [0, 1), a multiple of 2⁻⁵³. */
    public fun nextDouble(): Double = (nextLong() ushr 11) * (1.0 / (1L shl 53))

    /** Uniform in [[lower], [upper]). */
    public fun nextDouble(lower: Double, upper: Double): Double = lower + (upper - lower) * nextDouble()

    /** Uniform in 0 until [bound], by multiplication (bias below 2⁻³² for an Int bound). */
    public fun nextInt(bound: Int): Int {
        require(bound > 0) { "bound is $bound; it must be > 0" }
        return Math.multiplyHigh(nextLong() ushr 1, bound.toLong() shl 1).toInt()
    }

    /** Standard normal, by Marsaglia's polar method. */
    public fun nextGaussian(): Double {
        if (!spare.isNaN()) return spare.also { spare = Double.NaN }
        while (true) {
            val u = nextDouble(-1.0, 1.0)
            val v = nextDouble(-1.0, 1.0)
            val s = u * u + v * v
            if (s >= 1.0 || s == 0.0) continue
            val f = sqrt(-2.0 * StrictMath.log(s) / s)
            spare = v * f
            return u * f
        }
    }
}
