package daphnis.core.surface

/**
 * ε between measured points: linear in the impact speed from one to the next, and constant below the first and beyond
 * the last.
 *
 * @param speeds of the points in cm/s, ≥ 0, each larger than the one before; copied
 * @param coefficients at these speeds, in [0, 1]; copied
 * @property cmPerSecond how many cm/s one unit of speed of the scenario is
 */
public class TableRestitution @JvmOverloads constructor(
    speeds: DoubleArray,
    coefficients: DoubleArray,
    public val cmPerSecond: Double = 1.0,
) : Restitution {
    private val speeds = speeds.copyOf()
    private val coefficients = coefficients.copyOf()

    init {
        require(speeds.size == coefficients.size && speeds.isNotEmpty()) {
            "there are ${speeds.size} speeds and ${coefficients.size} coefficients; " +
                "there must be as many, and one at least"
        }
        for (k in speeds.indices) {
            val least = if (k == 0) 0.0 else Math.nextUp(speeds[k - 1])
            require(speeds[k] >= least && speeds[k].isFinite()) {
                "speed ${k + 1} of the table is ${speeds[k]} cm/s; it must be at least 0, and more than the one before"
            }
            require(coefficients[k] in 0.0..1.0) {
                "coefficient ${k + 1} of the table is ${coefficients[k]}; it must be in [0, 1]"
            }
        }
        require(cmPerSecond > 0 && cmPerSecond.isFinite()) { "one unit of speed is $cmPerSecond cm/s; it must be > 0" }
    }

    override fun coefficient(impactSpeed: Double): Double {
        val v = impactSpeed * cmPerSecond
        var low = 0
        var high = speeds.size - 1
        if (v <= speeds[low]) return coefficients[low]
        if (v >= speeds[high]) return coefficients[high]
        // speeds[low] < v < speeds[high], or v is at a point between.
        while (high - low > 1) {
            val middle = (low + high) ushr 1
            if (speeds[middle] <= v) low = middle else high = middle
        }
        val share = (v - speeds[low]) / (speeds[high] - speeds[low])
        return coefficients[low] + (coefficients[high] - coefficients[low]) * share
    }
}
