package daphnis.analysis.occultation

import daphnis.core.initial.SeededRandom
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * The noise of a photometer that counts photons: Poisson numbers, the same for the same [seed]. Not thread-safe.
 *
 * @property unocculted mean number of photons per footprint where nothing is in the way, > 0
 */
public class PhotonCounts @JvmOverloads constructor(public val unocculted: Double, seed: Long = 1) {
    private val random = SeededRandom(seed)

    init {
        require(unocculted > 0 && unocculted <= MOST) {
            "$unocculted photons per footprint; it must be in (0, $MOST]"
        }
    }

    /** Numbers of photons over [unocculted], for footprints with this [transmission]. */
    internal fun of(transmission: DoubleArray): DoubleArray =
        DoubleArray(transmission.size) { draw(unocculted * transmission[it]) / unocculted }

    /** A Poisson number of this [mean]; a whole number. */
    internal fun draw(mean: Double): Double = when {
        mean <= 0 -> 0.0
        mean < FEW -> ofFew(mean)
        else -> ofMany(mean)
    }

    /** Events before the product of uniform numbers falls below exp(−mean). */
    private fun ofFew(mean: Double): Double {
        val end = StrictMath.exp(-mean)
        var product = random.nextDouble()
        var count = 0
        while (product > end) {
            product *= random.nextDouble()
            count++
        }
        return count.toDouble()
    }

    /** Transformed rejection, PTRS of Hörmann 1993, Insurance: Mathematics and Economics 12, 39. */
    private fun ofMany(mean: Double): Double {
        val b = 0.931 + 2.53 * sqrt(mean)
        val a = -0.059 + 0.02483 * b
        val inverse = 1.1239 + 1.1328 / (b - 3.4)
        val inner = 0.9277 - 3.6224 / (b - 2)
        while (true) {
            val u = random.nextDouble() - 0.5
            val v = random.nextDouble()
            val s = 0.5 - abs(u)
            val k = floor((2 * a / s + b) * u + mean + 0.43)
            if (s >= 0.07 && v <= inner) return k
            if (k < 0 || s < 0.013 && v > s) continue
            val left = StrictMath.log(v * inverse / (a / (s * s) + b))
            if (left <= k * StrictMath.log(mean) - mean - logFactorial(k)) return k
        }
    }

    private companion object {
        const val FEW = 10.0
        const val MOST = 1e12

        /** ln k!, by Stirling's series from 10 on. */
        fun logFactorial(k: Double): Double {
            if (k < 10) {
                var product = 1.0
                for (i in 2..k.toInt()) product *= i
                return StrictMath.log(product)
            }
            val inverse = 1 / (k * k)
            val series = (1.0 / 12 - inverse * (1.0 / 360 - inverse * (1.0 / 1260 - inverse / 1680))) / k
            return (k + 0.5) * StrictMath.log(k) - k + 0.5 * StrictMath.log(2 * PI) + series
        }
    }
}
