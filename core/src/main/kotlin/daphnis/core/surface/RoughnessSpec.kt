package daphnis.core.surface

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.scenario.all
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.abs

/**
 * Surfaces of spheres, or of a wall.
 *
 * @property momentFactor moment of inertia of the spheres over mass · radius²; 2/5 when left out, not for walls
 */
@Serializable
public sealed interface RoughnessSpec {
    public val momentFactor: Double?

    /** Whether it is no roughness at all. */
    public val isSmooth: Boolean get() = false

    /** Whether surfaces lose energy at every speed: a guard does not end that. */
    public val loses: Boolean get() = !isSmooth

    /** The law of what stands at [key]; null for a smooth surface. */
    public fun law(key: String, check: ValueCheck): Roughness?

    /** A description for a reader: [number] writes numbers. */
    public fun inWords(number: DoubleFunction<String>): String

    /** Smooth spheres that spin all the same, for walls that are rough; a wall that is smooth where others are not. */
    @Serializable
    @SerialName("smooth")
    @Described("spheres spin and nothing changes it but rough walls")
    public class Smooth @JvmOverloads constructor(
        @Described("moment of inertia over m r², at most 2/3, of discs 1; default 0.4, of discs 0.5")
        override val momentFactor: Double? = null,
    ) : RoughnessSpec {
        override val isSmooth: Boolean get() = true

        override fun law(key: String, check: ValueCheck): Roughness? = null

        override fun inWords(number: DoubleFunction<String>): String = "smooth"
    }

    /** @property coefficient β */
    @Serializable
    @SerialName("constant")
    @Described("β is the same in every impact")
    public class Constant @JvmOverloads constructor(
        @Described("β in [−1, 1]: −1 smooth, 0 ends sliding, 1 loses nothing")
        public val coefficient: Double,
        @Described("moment of inertia over m r², at most 2/3, of discs 1; default 0.4, of discs 0.5")
        override val momentFactor: Double? = null,
    ) : RoughnessSpec {
        override val loses: Boolean get() = abs(coefficient) < 1

        override fun law(key: String, check: ValueCheck): Roughness {
            check.that("$key.coefficient", coefficient, coefficient in -1.0..1.0) { "must be in [-1, 1]" }
            return ConstantRoughness(coefficient)
        }

        override fun inWords(number: DoubleFunction<String>): String =
            "constant, β = ${number.apply(coefficient)} (-1 smooth, 1 perfectly rough)"
    }

    /**
     * @property friction μ
     * @property sticking β₀
     */
    @Serializable
    @SerialName("coulomb")
    @Described("β is `sticking` unless the surfaces slide for want of friction")
    public class Coulomb @JvmOverloads constructor(
        @Described("≥ 0")
        public val friction: Double,
        @Described("in [−1, 1]")
        public val sticking: Double,
        @Described("moment of inertia over m r², at most 2/3, of discs 1; default 0.4, of discs 0.5")
        override val momentFactor: Double? = null,
    ) : RoughnessSpec {
        override val loses: Boolean get() = friction > 0 && sticking > -1

        override fun law(key: String, check: ValueCheck): Roughness {
            check.that("$key.friction", friction, friction >= 0 && friction.isFinite()) { "must be at least 0" }
            check.that("$key.sticking", sticking, sticking in -1.0..1.0) { "must be in [-1, 1]" }
            return CoulombRoughness(friction, sticking)
        }

        override fun inWords(number: DoubleFunction<String>): String =
            "sticking ${number.apply(sticking)} unless friction ${number.apply(friction)} is too weak for that"
    }
}
