package daphnis.analysis.brightness

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * The brightness of a patch beside what was [observed], line by line.
 *
 * @property seen averages of I/F over the states, along the lines of [observed]
 */
public class BrightnessComparison(public val observed: ObservedBrightness, public val seen: List<BlockAverage>) {
    init {
        require(seen.size == observed.lines.size) { "${seen.size} averages, ${observed.lines.size} lines" }
    }

    /** Observed I/F less that of the patch. */
    public val residuals: DoubleArray = DoubleArray(seen.size) { observed.values[it] - seen[it].mean }

    /**
     * Joint standard error of a residual: both errors where that of the patch is known, else that of the observation.
     */
    public val errors: DoubleArray = DoubleArray(seen.size) { k ->
        if (seen[k].isLevelled) hypot(observed.errors[k], seen[k].error) else observed.errors[k]
    }

    /**
     * Σ (residual/error)²: the number of lines n with a scatter of (2n)^½, where the patch is what was observed and the
     * errors of the lines are independent. Lines through the same states are not quite.
     */
    public val chiSquare: Double get() = chiSquare(1.0)

    /**
     * The factor by which the patch comes nearest to what was observed, by least squares of the residuals over their
     * [errors]; that of the albedo where light is scattered once. NaN where no light comes from the patch.
     */
    public val factor: Double = sum { observed.values[it] * seen[it].mean } / sum { seen[it].mean * seen[it].mean }

    /** Standard error of [factor], for independent errors. */
    public val factorError: Double = 1 / sqrt(sum { seen[it].mean * seen[it].mean })

    /** [chiSquare] of the patch brighter by [factor], which takes one from what is expected of it. */
    public val chiSquareOfFactor: Double get() = chiSquare(factor)

    private fun chiSquare(times: Double) = sum { k -> (observed.values[k] - times * seen[k].mean).let { it * it } }

    /** Σ [of] over the squares of the errors. */
    private inline fun sum(of: (Int) -> Double): Double = errors.indices.sumOf { of(it) / (errors[it] * errors[it]) }
}
