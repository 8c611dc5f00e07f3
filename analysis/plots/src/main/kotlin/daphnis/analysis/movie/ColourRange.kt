package daphnis.analysis.movie

import kotlin.math.ln

/** The numbers that the colours of a movie stand for: [low] to [high], by logarithm if these are far apart. */
internal class ColourRange(val low: Double, val high: Double, private val mayBeLogarithmic: Boolean = false) {
    val isLogarithmic: Boolean = mayBeLogarithmic && low > 0 && high / low >= FAR_APART

    /** 0 at [low], 1 at [high], beyond these outside; in the middle when the two are one. */
    fun place(value: Double): Double = when {
        !(low < high) -> 0.5
        isLogarithmic -> if (value > 0) ln(value / low) / ln(high / low) else 0.0
        else -> (value - low) / (high - low)
    }

    fun union(other: ColourRange) = ColourRange(minOf(low, other.low), maxOf(high, other.high), mayBeLogarithmic)

    private companion object {
        const val FAR_APART = 10.0
    }
}
