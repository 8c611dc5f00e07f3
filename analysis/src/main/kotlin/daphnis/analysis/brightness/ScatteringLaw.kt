package daphnis.analysis.brightness

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * How the surface of a sphere scatters light. An element of it that is lit at the cosine μ₀ to its normal and seen at μ
 * has the radiance I; the light comes with the flux πF through an area across it. All laws are reciprocal: I/F over μ₀
 * stays the same when light and eye change places.
 *
 * @property words what scatters, in words
 * @property albedo of a Lambert surface, the single-scattering albedo ϖ₀ of the grains of another, in 0..1, or the
 *   spherical albedo A that goes with a phase function of whole spheres
 */
public abstract class ScatteringLaw internal constructor(public val words: String, public val albedo: Double) {
    init {
        require(albedo in 0.0..1.0) { "albedo is $albedo; it must be in [0, 1]" }
    }

    /** I/F of an element at [light] = μ₀ > 0, [eye] = μ > 0 and the phase angle [angle] in radians. */
    public abstract fun radiance(light: Double, eye: Double, angle: Double): Double

    /**
     * A P(α) of a sphere alone: four times its I/F averaged over the disc that the eye sees. [angle] is α in radians.
     */
    public abstract fun ofSphere(angle: Double): Double

    /** The table of phase angles that it is made of; null if they do not matter. Beyond it what it has at its ends. */
    public open val table: PhaseTable? get() = null

    /** Share of the light on a sphere alone that it scatters: ½ ∫ A P(α) sin α dα, by Simpson's rule. */
    public val sphericalAlbedo: Double by lazy {
        var sum = 0.0
        for (k in 0..PANELS) {
            val angle = PI * k / PANELS
            val weight = if (k == 0 || k == PANELS) {
                1
            } else if (k % 2 == 1) {
                4
            } else {
                2
            }
            sum += weight * ofSphere(angle) * StrictMath.sin(angle)
        }
        sum * PI / PANELS / 6
    }

    /** Cosine to the normal of a direction that light may come from, of a [uniform] number in [0, 1). */
    internal abstract fun drawn(uniform: Double): Double

    /**
     * Mean I/F that light of unit radiance from directions which are [drawn] so adds: by what the light of a path is
     * multiplied where it was scattered from the drawn [from] toward [to], cosines to the normal.
     */
    internal abstract fun weight(from: Double, to: Double, angle: Double): Double

    private class Lambert(albedo: Double) : ScatteringLaw("Lambert surfaces of the albedo $albedo", albedo) {
        override fun radiance(light: Double, eye: Double, angle: Double) = albedo * light

        override fun ofSphere(angle: Double) =
            albedo * 8 / (3 * PI) * (StrictMath.sin(angle) + (PI - angle) * StrictMath.cos(angle))

        // As the cosine: 1 − u is not 0.
        override fun drawn(uniform: Double) = sqrt(1 - uniform)

        override fun weight(from: Double, to: Double, angle: Double) = albedo
    }

    private class LommelSeeliger(
        words: String,
        albedo: Double,
        override val table: PhaseTable?,
        private val isWhole: Boolean,
    ) : ScatteringLaw(words, albedo) {
        override fun radiance(light: Double, eye: Double, angle: Double) = grains(angle) / 4 * (light / (light + eye))

        override fun ofSphere(angle: Double) = grains(angle) / 2 * ofDisc(angle)

        /** ϖ₀ f(α). */
        private fun grains(angle: Double): Double {
            val value = table?.at(angle) ?: 1.0
            // At 180° nothing is lit and seen, whatever a sphere is said to scatter there.
            return albedo * if (isWhole) 2 * value / maxOf(ofDisc(angle), LEAST) else value
        }

        override fun drawn(uniform: Double) = 1 - uniform

        override fun weight(from: Double, to: Double, angle: Double) = 2 * radiance(from, to, angle)
    }

    public companion object {
        private const val SEELIGER = "surfaces of Lommel and Seeliger"
        private const val PANELS = 2000
        private const val LEAST = 1e-12
        private const val NEAR = 1e-2

        /** I/F = A μ₀. A sphere has the phase function (8/3π)(sin α + (π − α) cos α). */
        @JvmStatic
        public fun lambert(albedo: Double): ScatteringLaw = Lambert(albedo)

        /**
         * I/F = (ϖ₀ f(α)/4) μ₀/(μ₀ + μ), Lommel and Seeliger. A sphere has A P(α) = (ϖ₀ f(α)/2) (1 − sin(α/2) tan(α/2)
         * ln cot(α/4)).
         *
         * @param grains f, the phase function of the grains of the surface; null for 1 at all angles
         */
        @JvmStatic
        @JvmOverloads
        public fun lommelSeeliger(albedo: Double, grains: PhaseTable? = null): ScatteringLaw =
            LommelSeeliger("$SEELIGER of the single-scattering albedo $albedo", albedo, grains, false)

        /**
         * A surface of Lommel and Seeliger whose f(α) is such that a sphere has the phase function [whole] P(α), times
         * the spherical albedo [albedo], if P has the mean 1 over all directions.
         */
        @JvmStatic
        public fun ofSpheres(albedo: Double, whole: PhaseTable): ScatteringLaw =
            LommelSeeliger("$SEELIGER, and $albedo times the phase function given", albedo, whole, true)

        /** 1 − sin(α/2) tan(α/2) ln cot(α/4), by its series near α = π. */
        internal fun ofDisc(angle: Double): Double {
            val rest = (PI - angle) / 2
            if (abs(rest) < NEAR) return rest * rest * (2.0 / 3 - rest * rest * 4 / 45)
            if (angle < LEAST) return 1.0
            val half = angle / 2
            return 1 - StrictMath.sin(half) * StrictMath.tan(half) * -StrictMath.log(StrictMath.tan(half / 2))
        }
    }
}
