package daphnis.core.scenario

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * [shearProfile] adds the mean flow v_x = γ y of the boundary; [zeroMomentum] subtracts the velocity of the centre of
 * mass of the drawn velocities.
 */
@Serializable
public sealed interface VelocitiesSpec {
    public val shearProfile: Boolean
    public val zeroMomentum: Boolean

    @Serializable
    @SerialName("rest")
    public class Rest @JvmOverloads constructor(
        override val shearProfile: Boolean = false,
        override val zeroMomentum: Boolean = true,
    ) : VelocitiesSpec

    /** Every component uniform in ±[halfWidth]. */
    @Serializable
    @SerialName("uniform")
    public class Uniform @JvmOverloads constructor(
        public val halfWidth: Double,
        override val shearProfile: Boolean = false,
        override val zeroMomentum: Boolean = true,
    ) : VelocitiesSpec

    /**
     * Every component normal, with exactly one of the standard deviation [sigma], the same for all, and the kinetic
     * [temperature] T, with √(T/m) for a sphere of mass m.
     *
     * @property exact scales the drawn velocities relative to the centre of mass, so that the granular temperature, as
     *   it is measured without bias (daphnis.core.population.granularTemperature), is σ², or T over the mean mass
     */
    @Serializable
    @SerialName("gaussian")
    public class Gaussian @JvmOverloads constructor(
        public val sigma: Double? = null,
        override val shearProfile: Boolean = false,
        override val zeroMomentum: Boolean = true,
        public val temperature: Double? = null,
        public val exact: Boolean = false,
    ) : VelocitiesSpec
}
