package daphnis.core.boundary

import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import kotlin.math.floor

/**
 * Lees–Edwards boundaries (Lees & Edwards 1972, J. Phys. C 5, 1921), the consistent form of a sheared periodic box: the
 * image above the upper y face slides with `shearRate · L_y` along x, its offset is `shearRate · L_y · t` (mod L_x),
 * and contacts are found through all faces. x and z are periodic.
 */
public class LeesEdwards(override val box: Box, public val shearRate: Double) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(shearRate.isFinite()) { "shear rate is $shearRate; it must be finite" }
    }

    override val shear: ImageShear =
        ImageShear(normalAxis = 1, slideAxis = 0, velocity = shearRate * box.length(1), slideLength = box.length(0))

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = shearRate)

    override fun contactFaces(axis: Int): ContactFaces = ContactFaces.PERIODIC

    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        val x = population.x
        val y = population.y
        val vx = population.vx
        val offset = shear.offset(time)
        val length = box.length(1)
        for (k in from until to) {
            if (y[k] >= box.lowerY && y[k] < box.upperY) continue
            val boxes = floor((y[k] - box.lowerY) / length)
            y[k] = inside(y[k] - boxes * length, box.lowerY, box.upperY)
            x[k] -= boxes * offset
            vx[k] -= boxes * shear.velocity
            shear.count(population, k, boxes, time)
        }
        wrap(population, 0, box, from, to)
        wrap(population, 2, box, from, to)
    }
}
