package daphnis.core.initial

import kotlin.math.abs

/** How large the spheres are. */
public fun interface SizeDistribution {
    /** Draws one radius > 0. */
    public fun draw(random: SeededRandom): Double

    /** Draws [count] radii. */
    public fun radii(count: Int, random: SeededRandom): DoubleArray = DoubleArray(count) { draw(random) }
}

/** Every sphere has [radius]. */
public class EqualSizes(public val radius: Double) : SizeDistribution {
    init {
        require(radius > 0 && radius.isFinite()) { "radius is $radius; it must be > 0" }
    }

    override fun draw(random: SeededRandom): Double = radius
}

/**
 * Number density n(r) ∝ r^−[exponent] between [minimum] and [maximum]; planetary rings have exponents near 3. By
 * inversion.
 */
public class PowerLawSizes(public val minimum: Double, public val maximum: Double, public val exponent: Double) :
    SizeDistribution {
    init {
        require(minimum > 0 && minimum.isFinite()) { "smallest radius is $minimum; it must be > 0" }
        require(maximum >= minimum && maximum.isFinite()) {
            "largest radius is $maximum; it must be at least the smallest, $minimum"
        }
        require(exponent.isFinite()) { "exponent is $exponent; it must be finite" }
    }

    private val k = 1 - exponent
    private val ratio = maximum / minimum
    private val power = StrictMath.pow(ratio, k)

    /** Whether to use the limit for exponent 1, near which the formula has no significant digits. */
    private val isLimit = abs(k * StrictMath.log(ratio)) <= SMALL

    override fun draw(random: SeededRandom): Double {
        val u = random.nextDouble()
        val r = if (isLimit) {
            minimum * StrictMath.pow(ratio, u)
        } else if (power.isInfinite()) {
            maximum * StrictMath.pow(u, 1 / k)
        } else {
            minimum * StrictMath.pow(1 + u * (power - 1), 1 / k)
        }
        return r.coerceIn(minimum, maximum)
    }

    private companion object {
        /** Of k ln(ratio): below it the law differs from its limit by less than the formula's round-off. */
        const val SMALL = 1e-12
    }
}

/**
 * ln r is normal with mean ln [median] and standard deviation [sigma]; draws outside [[minimum], [maximum]] are
 * rejected.
 */
public class LogNormalSizes(
    public val median: Double,
    public val sigma: Double,
    public val minimum: Double,
    public val maximum: Double,
) : SizeDistribution {
    init {
        require(median > 0 && median.isFinite()) { "median radius is $median; it must be > 0" }
        require(sigma >= 0 && sigma.isFinite()) { "sigma is $sigma; it must be at least 0" }
        require(minimum > 0 && minimum <= median) { "smallest radius is $minimum; it must be in (0, median $median]" }
        require(maximum >= median && maximum.isFinite()) {
            "largest radius is $maximum; it must be at least the median, $median"
        }
    }

    override fun draw(random: SeededRandom): Double {
        // The median is never rejected and half the mass lies on either side, but a narrow window could take long: cap
        // the tries.
        repeat(MOST_TRIES) {
            val r = median * StrictMath.exp(sigma * random.nextGaussian())
            if (r in minimum..maximum) return r
        }
        return random.nextDouble(minimum, Math.nextUp(maximum)).coerceIn(minimum, maximum)
    }

    private companion object {
        const val MOST_TRIES = 10_000
    }
}

/** The radii in [radii], repeated in this order. */
public class ListedSizes(private val radii: DoubleArray) : SizeDistribution {
    private var next = 0

    init {
        require(radii.isNotEmpty()) { "the list of radii is empty" }
        for (r in radii) require(r > 0 && r.isFinite()) { "radius $r in the list; every radius must be > 0" }
    }

    override fun draw(random: SeededRandom): Double = radii[next++ % radii.size]

    override fun radii(count: Int, random: SeededRandom): DoubleArray {
        next = 0
        return super.radii(count, random)
    }
}
