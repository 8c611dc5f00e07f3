package daphnis.core.initial

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
    public class Equal(override val radius: Double) : SizesSpec {
        override val range: Pair<Double, Double> get() = radius to radius

        override fun distribution(): SizeDistribution = EqualSizes(radius)
    }

    @Serializable
    @SerialName("power-law")
    public class PowerLaw(public val minimum: Double, public val maximum: Double, public val exponent: Double) :
        SizesSpec {
        override val isContinuous: Boolean get() = true
        override val range: Pair<Double, Double> get() = minimum to maximum

        override fun distribution(): SizeDistribution = PowerLawSizes(minimum, maximum, exponent)
    }

    @Serializable
    @SerialName("log-normal")
    public class LogNormal(
        public val median: Double,
        public val sigma: Double,
        public val minimum: Double,
        public val maximum: Double,
    ) : SizesSpec {
        override val isContinuous: Boolean get() = true
        override val range: Pair<Double, Double> get() = minimum to maximum

        override fun distribution(): SizeDistribution = LogNormalSizes(median, sigma, minimum, maximum)
    }

    @Serializable
    @SerialName("list")
    public class Listed(public val radii: List<Double>) : SizesSpec {
        override val isInOrder: Boolean get() = true
        override val range: Pair<Double, Double> get() = radii.min() to radii.max()

        override fun distribution(): SizeDistribution = ListedSizes(radii.toDoubleArray())
    }
}
