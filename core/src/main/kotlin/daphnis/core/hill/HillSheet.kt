package daphnis.core.hill

import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.requireFinite
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.MeanFlow

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
 * @param box finite along x and y; its extent along z is nominal: spheres are placed within it at the start and may
 *   leave it
 * @property frequencies of circular orbits; s is their [OrbitalFrequencies.shearRate], (3/2) Ω around a point mass
 * @param radiallyOpen whether the patch ends at its radial faces (a ringlet, a ring edge) instead of being continued by
 *   images
 */
public class HillSheet @JvmOverloads constructor(
    override val box: Box,
    public val frequencies: OrbitalFrequencies,
    public val radiallyOpen: Boolean = false,
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
    }

    /** Around a point mass, with angular speed [omega]. */
    @JvmOverloads
    public constructor(box: Box, omega: Double, radiallyOpen: Boolean = false) :
        this(box, OrbitalFrequencies(omega), radiallyOpen)

    /** Ω in radians per unit of time. */
    public val omega: Double get() = frequencies.omega

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -frequencies.shearRate)

    override val shear: ImageShear? = if (radiallyOpen) null else ImageShear(box, meanFlow)

    override fun contactFaces(axis: Int): ContactFaces = if (axis == 1 || axis == 0 && !radiallyOpen) {
        ContactFaces.PERIODIC
    } else {
        ContactFaces.OPEN
    }
}
