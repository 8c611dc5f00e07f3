package daphnis.core.boundary

import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import kotlin.math.abs

/**
 * The sheared periodic box of Lewis & Massingill: at the end of a step a sphere beyond a face is put on the other side,
 * and the x velocity of a sphere that passed a y face changes by [velocityJump]. There is no offset of position and no
 * collision search through the faces. Such a box is therefore not a consistent replica of itself, and a wrap can put
 * one sphere onto another. The pair then collides if it approaches and separates if it recedes. Use it for the paper's
 * figures, [LeesEdwards] for physics.
 */
public class ShearedPeriodic(override val box: Box, public val velocityJump: Double) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(velocityJump.isFinite()) { "velocity jump is $velocityJump; it must be finite" }
    }

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = velocityJump / box.length(1))

    override fun contactFaces(axis: Int): ContactFaces =
        if (axis < space.dimensions) ContactFaces.WRAPPING else ContactFaces.OPEN

    /** As the jumps of a sphere that passes very many boxes at once are finite. */
    override fun keepsFinite(asked: PerSphereBoundary): Boolean =
        asked === this && abs(velocityJump) <= LARGE && box.length(1) >= 1 / LARGE

    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        val vx = population.vx
        // v_x = γ y with γ L_y = jump: a sphere that leaves above enters below, where the flow is slower by the jump.
        wrap(population, 1, box, from, to) { k, boxes -> vx[k] -= boxes * velocityJump }
        wrap(population, 0, box, from, to)
        if (!space.isPlane) wrap(population, 2, box, from, to)
    }

    private companion object {
        private const val LARGE = 1e90
    }
}
