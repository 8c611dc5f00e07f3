package daphnis.core.boundary

import daphnis.core.population.MeanFlow
import daphnis.core.population.Population

/**
 * Images across the faces of [normalAxis] slide along [slideAxis] with the mean flow: the image at `+m` boxes is
 * displaced by `m · offset(t)` and moves with `m · velocity` relative to its original.
 *
 * @param flow of the spheres in [box]; images one box away move with the flow that is there
 * @throws IllegalArgumentException when the flow is along its own normal or along z, along which no image can slide
 */
public class ImageShear(private val box: Box, flow: MeanFlow) {
    public val normalAxis: Int = flow.normalAxis
    public val slideAxis: Int = flow.flowAxis

    /** Velocity of the image at +1 relative to its original. */
    public val velocity: Double = flow.rate * box.length(normalAxis)
    private val slideLength = box.length(slideAxis)

    init {
        require(slideAxis < AXES - 1 && slideAxis != normalAxis) {
            "images slide along ${AXIS_NAMES[slideAxis]} across ${AXIS_NAMES[normalAxis]}; " +
                "they can slide along x or y, across another axis"
        }
    }

    /**
     * Displacement of the image at +1 at [time], reduced to [0, length along the slide axis). A pure function of time.
     */
    public fun offset(time: Double): Double {
        val raw = (velocity * time) % slideLength
        return if (raw < 0) raw + slideLength else raw
    }

    /** Whole lengths of the box that [offset] does not contain: `velocity · time = turns · length + offset`. */
    public fun turns(time: Double): Double = Math.rint((velocity * time - offset(time)) / slideLength)

    /**
     * Puts the spheres [from] until [to] back across the normal axis: to the place of their image in the box at [time],
     * with its velocity. Along the slide axis they may be outside afterwards.
     */
    internal fun wrap(population: Population, time: Double, from: Int, to: Int) {
        val along = population.position(slideAxis)
        val speed = population.velocity(slideAxis)
        val offset = offset(time)
        val turns = turns(time)
        wrap(population, normalAxis, box, from, to) { k, boxes ->
            along[k] -= boxes * offset
            speed[k] -= boxes * velocity
            population.addCrossing(k, slideAxis, (-boxes * turns).toInt())
        }
    }
}
