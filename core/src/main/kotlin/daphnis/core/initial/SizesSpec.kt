package daphnis.core.initial

import daphnis.core.input.Described
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Radii of spheres. */
@Serializable
public sealed interface SizesSpec {
    /** The radius, where all have one; else null. */
    public val radius: Double? get() = null

    /** Whether radii are drawn, so that no two are the same. */
    public val isContinuous: Boolean get() = false

    /** Whether radii come in an order, and are not drawn one by one. */
    public val isInOrder: Boolean get() = false

    /** The least and the largest radius. */
    public val range: Pair<Double, Double>

    /** @throws IllegalArgumentException for values that are wrong */
    public fun distribution(): SizeDistribution

    @Serializable
    @SerialName("equal")
    @Described("one radius")
    public class Equal(
        @Described("of all spheres, a length")
        override val radius: Double,
    ) : SizesSpec {
        override val range: Pair<Double, Double> get() = radius to radius

        override fun distribution(): SizeDistribution = EqualSizes(radius)
    }

    @Serializable
    @SerialName("power-law")
    @Described("n(r) ∝ r^−q between two radii")
    public class PowerLaw(
        @Described("least radius")
        public val minimum: Double,
        @Described("greatest radius")
        public val maximum: Double,
        @Described("q")
        public val exponent: Double,
    ) : SizesSpec {
        override val isContinuous: Boolean get() = true
        override val range: Pair<Double, Double> get() = minimum to maximum

        override fun distribution(): SizeDistribution = PowerLawSizes(minimum, maximum, exponent)
    }

    @Serializable
    @SerialName("log-normal")
    @Described("ln r is normal, cut off at two radii")
    public class LogNormal(
        @Described("of r, a length")
        public val median: Double,
        @Described("standard deviation of ln r")
        public val sigma: Double,
        @Described("least radius")
        public val minimum: Double,
        @Described("greatest radius")
        public val maximum: Double,
    ) : SizesSpec {
        override val isContinuous: Boolean get() = true
        override val range: Pair<Double, Double> get() = minimum to maximum

        override fun distribution(): SizeDistribution = LogNormalSizes(median, sigma, minimum, maximum)
    }

    @Serializable
    @SerialName("list")
    @Described("radii one by one")
    public class Listed(
        @Described("repeated in order")
        public val radii: List<Double>,
    ) : SizesSpec {
        override val isInOrder: Boolean get() = true
        override val range: Pair<Double, Double> get() = radii.min() to radii.max()

        override fun distribution(): SizeDistribution = ListedSizes(radii.toDoubleArray())
    }
}
