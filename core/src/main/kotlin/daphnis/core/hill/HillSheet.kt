package daphnis.core.hill

import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.requireFinite
import daphnis.core.population.MeanFlow

/**
 * The shearing sheet for Hill's frame of angular speed [omega] (Wisdom & Tremaine 1988, AJ 95, 925): a patch of a ring
 * that is continued by its own images, radially with the Keplerian shear and along the orbit without it, and is open
 * vertically. The image at +L_x slides with −(3/2) Ω L_x along y. A sphere that leaves outward comes back at the inner
 * face displaced by +(3/2) Ω L_x t along y (mod L_y) and faster by (3/2) Ω L_x; e, φ, i and ζ of its epicycle do not
 * change.
 *
 * ```
 *   x ▲ (outward)    image: ◀── ○ ○  −(3/2) Ω L_x
 *     ├──────────────────────┐
 *     │            ◀─────    │  outer half lags
 *     │    ──────▶           │  inner half leads
 *     └──────────────────────┴─▶ y (along the orbit)
 *          image: ○ ○ ──▶  +(3/2) Ω L_x
 * ```
 *
 * @param box finite along x and y; its extent along z is nominal: spheres are placed within it at the start and may
 *   leave it
 * @param radiallyOpen whether the patch ends at its radial faces (a ringlet, a ring edge) instead of being continued by
 *   images
 */
public class HillSheet @JvmOverloads constructor(
    override val box: Box,
    public val omega: Double,
    public val radiallyOpen: Boolean = false,
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(omega > 0 && omega.isFinite()) { "angular speed is $omega; it must be > 0" }
    }

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -1.5 * omega)

    override val shear: ImageShear? = if (radiallyOpen) null else ImageShear(box, meanFlow)

    override fun contactFaces(axis: Int): ContactFaces = if (axis == 1 || axis == 0 && !radiallyOpen) {
        ContactFaces.PERIODIC
    } else {
        ContactFaces.OPEN
    }
}
