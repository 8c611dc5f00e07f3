package daphnis.analysis.occultation

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.hypot

/**
 * The light through a patch beside what was [observed], line by line.
 *
 * @param transmissions averages over the states along the lines of [observed]
 */
public class DepthComparison(public val observed: ObservedDepths, transmissions: List<BlockAverage>) {
    init {
        require(transmissions.size == observed.lines.size) {
            "${transmissions.size} averages, ${observed.lines.size} lines"
        }
    }

    /** Depths or transmissions of the patch, whichever was observed. */
    public val seen: List<BlockAverage> = transmissions.mapIndexed { k, average ->
        val line = observed.lines[k]
        if (observed.areDepths) RayCasting(line.elevation, line.azimuth).depth(average) else average
    }

    /** Observed value less that of the patch; NaN where nothing comes through the patch and depths were observed. */
    public val residuals: DoubleArray = DoubleArray(seen.size) { k ->
        (observed.values[k] - seen[k].mean).let { if (it.isFinite()) it else Double.NaN }
    }

    /**
     * Joint standard error of a residual: both errors where that of the patch is known, else that of the observation.
     */
    public val errors: DoubleArray = DoubleArray(seen.size) { k ->
        val own = seen[k].error
        if (own.isFinite()) hypot(observed.errors[k], own) else observed.errors[k]
    }

    /** Residuals that are numbers. */
    public val count: Int get() = residuals.count { !it.isNaN() }

    /**
     * Σ (residual/error)² over the [count] of them: [count] with a scatter of (2 [count])^½, where the patch
     * is what was observed and the errors of the lines are independent. Lines through the same states are not quite.
     */
    public val chiSquare: Double get() = residuals.indices.filter { !residuals[it].isNaN() }
        .sumOf { (residuals[it] / errors[it]) * (residuals[it] / errors[it]) }
}
