package daphnis.core.hill

import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.requireFinite
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population

/**
 * The shearing sheet for Hill's frame (Wisdom & Tremaine 1988, AJ 95, 925): a patch of a ring that is continued by its
 * own images, radially with the shear s of circular orbits and along the orbit without it, and is open vertically. The
 * image at +L_x slides with −s L_x along y. A sphere that leaves outward comes back at the inner face displaced by
 * +s L_x t along y (mod L_y) and faster by s L_x; e, φ, i and ζ of its epicycle do not change.
 *
 * ```
 *   x ▲ (outward)    image: ◀── ○ ○  −s L_x
 *     ├──────────────────────┐
 *     │            ◀─────    │  outer half lags
 *     │    ──────▶           │  inner half leads
 *     └──────────────────────┴─▶ y (along the orbit)
 *          image: ○ ○ ──▶  +s L_x
 * ```
 *
 * **A perturbed sheet** has images that breathe, as in a ring near a satellite: the one at +1 is displaced by ΔX = L_x (1
 * − q cos κt), ΔY = −s L_x t + 2 (Ω/κ) q L_x sin κt, a solution of Hill's equations. So free spheres and their images
 * stay images, and the surface density goes up and down between 1/(1 + q) and 1/(1 − q) of its mean. [box], [shear] and
 * [meanFlow] are then those of guiding centres; what there is at a time says [during]. It takes a
 * [HillFrame] with the same [frequencies].
 *
 * @param box finite along x and y; its extent along z is nominal: spheres are placed within it at the start and may
 *   leave it
 * @property frequencies of circular orbits; s is their [OrbitalFrequencies.shearRate], (3/2) Ω around a point mass
 * @param radiallyOpen whether the patch ends at its radial faces (a ringlet, a ring edge) instead of being continued by
 *   images
 * @property perturbation q, in [0, 1); 0 for a sheet that is not perturbed
 * @throws IllegalArgumentException also for a ringlet that is perturbed: it has no images to breathe
 */
public class HillSheet @JvmOverloads constructor(
    override val box: Box,
    public val frequencies: OrbitalFrequencies,
    public val radiallyOpen: Boolean = false,
    public val perturbation: Double = 0.0,
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(perturbation >= 0 && perturbation < 1) { "perturbation is $perturbation; it must be in [0, 1)" }
        require(perturbation == 0.0 || !radiallyOpen) { "a ringlet that is radially open cannot be perturbed" }
    }

    private val path: ImagePath? =
        if (perturbation == 0.0) null else ImagePath(box.length(0), frequencies, perturbation)

    /** Around a point mass, with angular speed [omega]. */
    @JvmOverloads
    public constructor(box: Box, omega: Double, radiallyOpen: Boolean = false, perturbation: Double = 0.0) :
        this(box, OrbitalFrequencies(omega), radiallyOpen, perturbation)

    /** Ω in radians per unit of time. */
    public val omega: Double get() = frequencies.omega

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -frequencies.shearRate)

    override val shear: ImageShear? = if (radiallyOpen) null else ImageShear(box, meanFlow)

    override fun during(start: Double, duration: Double): PerSphereBoundary? =
        path?.let { PresentSheet(this, it, start, duration) }

    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        val then = during(time, 0.0)
        if (then == null) super.endStep(population, time, from, to) else then.endStep(population, time, from, to)
    }

    override fun contactFaces(axis: Int): ContactFaces = if (axis == 1 || axis == 0 && !radiallyOpen) {
        ContactFaces.PERIODIC
    } else {
        ContactFaces.OPEN
    }
}
