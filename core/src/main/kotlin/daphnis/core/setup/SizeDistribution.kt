package daphnis.core.setup

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

/** Number density n(r) ∝ r^−[exponent] between [minimum] and [maximum]; planetary rings have exponents near 3. By inversion. */
public class PowerLawSizes(public val minimum: Double, public val maximum: Double, public val exponent: Double) : SizeDistribution {
    init {
        require(minimum > 0 && minimum.isFinite()) { "smallest radius is $minimum; it must be > 0" }
        require(maximum >= minimum && maximum.isFinite()) { "largest radius is $maximum; it must be >= the smallest, $minimum" }
        require(exponent.isFinite()) { "exponent is $exponent; it must be finite" }
    }

    override fun draw(random: SeededRandom): Double {
        val u = random.nextDouble()
        val k = 1 - exponent
        val ratio = maximum / minimum
        val r = if (k == 0.0) minimum * StrictMath.pow(ratio, u) else minimum * StrictMath.pow(1 + u * (StrictMath.pow(ratio, k) - 1), 1 / k)
        return r.coerceIn(minimum, maximum)
    }
}

/** ln r is normal with mean ln [median] and standard deviation [sigma]; draws outside [[minimum], [maximum]] are rejected. */
public class LogNormalSizes(public val median: Double, public val sigma: Double, public val minimum: Double, public val maximum: Double) : SizeDistribution {
    init {
        require(median > 0 && median.isFinite()) { "median radius is $median; it must be > 0" }
        require(sigma >= 0 && sigma.isFinite()) { "sigma is $sigma; it must be >= 0" }
        require(minimum > 0 && minimum <= median) { "smallest radius is $minimum; it must be in (0, median $median]" }
        require(maximum >= median && maximum.isFinite()) { "largest radius is $maximum; it must be >= the median, $median" }
    }

    override fun draw(random: SeededRandom): Double {
        // The median is never rejected and half the mass lies on either side, but a narrow window could take long: cap the tries.
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

/** The radii in [radii], over and over, in this order. */
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
