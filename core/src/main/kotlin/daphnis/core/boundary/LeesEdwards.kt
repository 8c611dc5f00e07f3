package daphnis.core.boundary

import daphnis.core.population.MeanFlow

/**
 * Lees–Edwards boundaries (Lees & Edwards 1972, J. Phys. C 5, 1921), the consistent form of a sheared periodic box. The
 * image above the upper y face slides with `shearRate · L_y` along x, its offset is `shearRate · L_y · t` (mod L_x),
 * and contacts are found through all faces. x and z are periodic; a flat box is open along z.
 */
public class LeesEdwards(override val box: Box, public val shearRate: Double) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(shearRate.isFinite()) { "shear rate is $shearRate; it must be finite" }
    }

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = shearRate)

    override val shear: ImageShear = ImageShear(box, meanFlow)

    override fun contactFaces(axis: Int): ContactFaces =
        if (axis < space.dimensions) ContactFaces.PERIODIC else ContactFaces.OPEN
}
