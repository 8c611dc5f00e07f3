package daphnis.core.initial

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.scenario.all
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.math.sqrt

/**
 * [shearProfile] adds the mean flow v_x = γ y of the boundary; [zeroMomentum] subtracts the velocity of the centre of
 * mass of the drawn velocities.
 */
@Serializable
public sealed interface VelocitiesSpec {
    public val shearProfile: Boolean
    public val zeroMomentum: Boolean

    /** What draws the velocity of a sphere of a mass, with its values checked; null for none. */
    public fun field(check: ValueCheck): DrawnVelocity? = null

    /** The granular temperature over the mean of [masses] to which velocities are scaled; null for as they are drawn. */
    public fun exactly(masses: DoubleArray): Double? = null

    @Serializable
    @SerialName("rest")
    @Described("zero")
    public class Rest @JvmOverloads constructor(
        @Described("adds the mean flow of a sheared boundary; default false")
        override val shearProfile: Boolean = false,
        @Described("subtracts the velocity of the centre of mass that the draw left; default true")
        override val zeroMomentum: Boolean = true,
    ) : VelocitiesSpec

    /** Every component uniform in ±[halfWidth]. */
    @Serializable
    @SerialName("uniform")
    @Described("each component is uniform in ±`halfWidth`")
    public class Uniform @JvmOverloads constructor(
        @Described("a speed")
        public val halfWidth: Double,
        @Described("adds the mean flow of a sheared boundary; default false")
        override val shearProfile: Boolean = false,
        @Described("subtracts the velocity of the centre of mass that the draw left; default true")
        override val zeroMomentum: Boolean = true,
    ) : VelocitiesSpec {
        override fun field(check: ValueCheck): DrawnVelocity {
            check.atLeast0("velocities.halfWidth", halfWidth)
            val field = UniformVelocities(halfWidth)
            return DrawnVelocity { _, random, into -> field.draw(random, into) }
        }
    }

    /**
     * Every component normal, with exactly one of the standard deviation [sigma], the same for all, and the kinetic
     * [temperature] T, with √(T/m) for a sphere of mass m.
     *
     * @property exact scales the drawn velocities relative to the centre of mass, so that the granular temperature, as
     *   it is measured without bias (daphnis.core.population.granularTemperature), is σ², or T over the mean mass
     */
    @Serializable
    @SerialName("gaussian")
    @Described("each component is normal; exactly one of `sigma` and `temperature`")
    public class Gaussian @JvmOverloads constructor(
        @Described("standard deviation of a component, a speed, the same for all sizes")
        public val sigma: Double? = null,
        @Described("adds the mean flow of a sheared boundary; default false")
        override val shearProfile: Boolean = false,
        @Described("subtracts the velocity of the centre of mass that the draw left; default true")
        override val zeroMomentum: Boolean = true,
        @Described("T, mass · speed², the same energy for all sizes: the standard deviation is √(T/m)")
        public val temperature: Double? = null,
        @Described(
            "scales what is drawn, so that the first row of `series.csv` has the temperature asked for; default " +
                "false",
        )
        public val exact: Boolean = false,
    ) : VelocitiesSpec {
        override fun field(check: ValueCheck): DrawnVelocity {
            check.must("velocities", (sigma == null) != (temperature == null)) {
                "needs exactly one of sigma and temperature"
            }
            sigma?.let { check.atLeast0("velocities.sigma", it) }
            temperature?.let { check.atLeast0("velocities.temperature", it) }
            val field = GaussianVelocities(1.0)
            return DrawnVelocity { mass, random, into ->
                field.draw(random, into)
                val sigma = sigma ?: sqrt((temperature ?: 0.0) / mass)
                for (axis in 0..2) into[axis] *= sigma
            }
        }

        override fun exactly(masses: DoubleArray): Double? = when {
            !exact -> null
            sigma != null -> sigma * sigma
            else -> (temperature ?: 0.0) * masses.size / masses.sum()
        }
    }
}

/** Draws the velocity of a sphere. */
public fun interface DrawnVelocity {
    /** Draws that of a sphere of [mass] from [random], and writes it to [into]. */
    public fun draw(mass: Double, random: SeededRandom, into: DoubleArray)
}
