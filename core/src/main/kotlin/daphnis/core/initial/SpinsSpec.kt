package daphnis.core.initial

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.scenario.all
import daphnis.core.scenario.around
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.math.sqrt

/**
 * Angular velocities at the start, in Hill's frame relative to the frame.
 *
 * @property mean along x, y, z
 */
@Serializable
public sealed interface SpinsSpec {
    public val mean: List<Double>

    /**
     * Standard deviation of a component, of a sphere of [mass] and [radius] with the moment of inertia [momentFactor] ·
     * mass · radius², with its values checked.
     */
    public fun deviation(momentFactor: Double, mass: Double, radius: Double, check: ValueCheck): Double = 0.0

    /** All spheres spin alike. */
    @Serializable
    @SerialName("rest")
    @Described("all spheres have the same spin")
    public class Rest @JvmOverloads constructor(
        @Described("that spin, radians per unit of time; of discs only z; default [0, 0, 0]")
        override val mean: List<Double> = listOf(0.0, 0.0, 0.0),
    ) : SpinsSpec

    /**
     * Every component normal around the mean, with exactly one of the standard deviation [sigma], the same for all, and
     * the [temperature] T of rotation, with √(T/I) for a sphere with the moment of inertia I.
     */
    @Serializable
    @SerialName("gaussian")
    @Described("each component is normal around the mean; exactly one of `sigma` and `temperature`")
    public class Gaussian @JvmOverloads constructor(
        @Described("standard deviation of a component, radians per unit of time, the same for all sizes")
        public val sigma: Double? = null,
        @Described("T, mass · speed², the same energy for all sizes: the standard deviation is √(T/I)")
        public val temperature: Double? = null,
        @Described("radians per unit of time; of discs only z; default [0, 0, 0]")
        override val mean: List<Double> = listOf(0.0, 0.0, 0.0),
    ) : SpinsSpec {
        override fun deviation(momentFactor: Double, mass: Double, radius: Double, check: ValueCheck): Double {
            check.must("spins", (sigma == null) != (temperature == null)) {
                "needs exactly one of sigma and temperature"
            }
            if (sigma != null) {
                check.atLeast0("spins.sigma", sigma)
                return sigma
            }
            val temperature = temperature ?: 0.0
            check.atLeast0("spins.temperature", temperature)
            return sqrt(temperature / (momentFactor * mass)) / radius
        }
    }
}
