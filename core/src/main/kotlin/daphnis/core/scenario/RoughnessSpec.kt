package daphnis.core.scenario

import daphnis.core.input.ValueCheck
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.CoulombRoughness
import daphnis.core.surface.Roughness
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.abs
import kotlin.math.sqrt

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
    public class Smooth @JvmOverloads constructor(override val momentFactor: Double? = null) : RoughnessSpec {
        override val isSmooth: Boolean get() = true

        override fun law(key: String, check: ValueCheck): Roughness? = null

        override fun inWords(number: DoubleFunction<String>): String = "smooth"
    }

    /** @property coefficient β */
    @Serializable
    @SerialName("constant")
    public class Constant @JvmOverloads constructor(
        public val coefficient: Double,
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
    public class Coulomb @JvmOverloads constructor(
        public val friction: Double,
        public val sticking: Double,
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

/** Surfaces of walls: of [all] that are not named, and of the lower and upper face across each axis. */
@Serializable
public class WallRoughnessSpec @JvmOverloads constructor(
    public val all: RoughnessSpec? = null,
    public val lowerX: RoughnessSpec? = null,
    public val upperX: RoughnessSpec? = null,
    public val lowerY: RoughnessSpec? = null,
    public val upperY: RoughnessSpec? = null,
    public val lowerZ: RoughnessSpec? = null,
    public val upperZ: RoughnessSpec? = null,
) {
    private val named: List<RoughnessSpec?> get() = listOf(lowerX, upperX, lowerY, upperY, lowerZ, upperZ)

    /** The surfaces of the walls across [axes] for a reader, such as `smooth; lowerZ sticking 0 …`. */
    internal fun inWords(axes: String, number: DoubleFunction<String>): String {
        val others = "xyz".withIndex().any { (axis, name) ->
            name in axes && (0..1).any { named[2 * axis + it] == null }
        }
        val parts = named.mapIndexedNotNull { face, spec -> spec?.let { "${NAMES[face]} ${it.inWords(number)}" } }
        val rest = (all?.inWords(number) ?: "smooth").takeIf { others }
        return (parts + listOfNotNull(rest?.let { if (parts.isEmpty()) it else "others $it" })).joinToString("; ")
    }

    /** The laws of the faces −x, +x, −y, +y, −z, +z, of which those across [axes] are walls. */
    internal fun laws(axes: String, check: ValueCheck): List<Roughness?> {
        for ((spec, name) in (named + all).zip(NAMES + "all")) {
            check.must("$KEY.$name.momentFactor", spec?.momentFactor == null) {
                "is that of spheres; give it as roughness.momentFactor"
            }
        }
        return named.mapIndexed { face, spec ->
            val isWall = "xyz"[face / 2] in axes
            check.must("$KEY.${NAMES[face]}", spec == null || isWall) { "is of no wall; there are walls across $axes" }
            val said = if (spec == null) "all" else NAMES[face]
            if (isWall) (spec ?: all)?.law("$KEY.$said", check) else null
        }
    }

    private companion object {
        const val KEY = "boundary.roughness"
        val NAMES = listOf("lowerX", "upperX", "lowerY", "upperY", "lowerZ", "upperZ")
    }
}

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
    public class Rest @JvmOverloads constructor(override val mean: List<Double> = listOf(0.0, 0.0, 0.0)) : SpinsSpec

    /**
     * Every component normal around the mean, with exactly one of the standard deviation [sigma], the same for all, and
     * the [temperature] T of rotation, with √(T/I) for a sphere with the moment of inertia I.
     */
    @Serializable
    @SerialName("gaussian")
    public class Gaussian @JvmOverloads constructor(
        public val sigma: Double? = null,
        public val temperature: Double? = null,
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
