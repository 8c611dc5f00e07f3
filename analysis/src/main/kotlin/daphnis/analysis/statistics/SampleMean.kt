package daphnis.analysis.statistics

import kotlin.math.atan
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * The mean of independent numbers, such as those of runs that differ in their seed, with its standard error: the
 * standard deviation of the numbers (over [count] − 1) divided by √[count].
 *
 * @property mean NaN of no numbers
 * @property error one standard error; NaN of fewer than two numbers, 0 of numbers that are all the same
 * @property count the numbers that were finite; the others are left out
 */
public class SampleMean private constructor(public val mean: Double, public val error: Double, public val count: Int) {
    override fun toString(): String = if (error.isNaN()) "$mean" else "$mean ± $error ($count)"

    public companion object {
        /** Of [numbers], in any order. */
        @JvmStatic
        public fun of(numbers: DoubleArray): SampleMean {
            val finite = numbers.filter { it.isFinite() }
            val n = finite.size
            if (n == 0) return SampleMean(Double.NaN, Double.NaN, 0)
            val first = finite[0]
            if (finite.all { it == first }) return SampleMean(first, if (n == 1) Double.NaN else 0.0, n)
            // Around the first, so that numbers which differ little lose no digits.
            val mean = first + finite.sumOf { it - first } / n
            val square = finite.sumOf { (it - mean) * (it - mean) }
            return SampleMean(mean, sqrt(square / (n - 1) / n), n)
        }

        /**
         * How often [error] covers the truth, if the numbers are Gaussian: the probability that Student's t of
         * [count] − 1 degrees of freedom lies within ±1 (Abramowitz & Stegun 1964, 26.7.3 and 26.7.4). 0.50 of two
         * numbers, 0.65 of eight, 0.683 of very many.
         *
         * @throws IllegalArgumentException for fewer than two numbers, which have no error
         */
        @JvmStatic
        public fun coverage(count: Int): Double {
            require(count >= 2) { "$count numbers have no error; two are needed" }
            val freedom = count - 1
            val angle = atan(1 / sqrt(freedom.toDouble()))
            val isOdd = freedom % 2 == 1
            var term = if (isOdd) cos(angle) else 1.0
            var sum = 0.0
            for (k in (if (isOdd) 3 else 2)..freedom step 2) {
                sum += term
                term *= cos(angle) * cos(angle) * (k - 1) / k
            }
            return if (isOdd) 2 / Math.PI * (angle + sin(angle) * sum) else sin(angle) * sum
        }
    }
}
