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
public class ImageShear private constructor(
    private val box: Box,
    flow: MeanFlow,
    private val start: Double,
    private val startTime: Double,
) {
    /** Images that stand above one another at time 0. */
    public constructor(box: Box, flow: MeanFlow) : this(box, flow, Double.NaN, 0.0)

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
        val raw = slid(time) % slideLength
        return if (raw < 0) raw + slideLength else raw
    }

    /** Whole lengths of the box that [offset] does not contain: what was slid is `turns · length + offset`. */
    public fun turns(time: Double): Double = Math.rint((slid(time) - offset(time)) / slideLength)

    private fun slid(time: Double) = if (start.isNaN()) velocity * time else start + velocity * (time - startTime)

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

    public companion object {
        /** Images of which the one at +1 is displaced by [offset] at [time]. */
        @JvmStatic
        public fun at(box: Box, flow: MeanFlow, offset: Double, time: Double): ImageShear =
            ImageShear(box, flow, offset, time)
    }
}
