package daphnis.core.boundary

import daphnis.core.population.MeanFlow
import daphnis.core.population.Population

/**
 * Images across the faces of [normalAxis] slide along [slideAxis] with the mean flow: the image at `+m` boxes is
 * displaced by `m · offset(t)` and moves with `m · velocity` relative to its original. In a box that widens they move
 * away too.
 *
 * @property normalAxis across which images slide
 * @property slideAxis along which they do
 * @property velocity of the image at +1 relative to its original, along the slide axis
 * @property velocityAcross the same along the normal axis: 0 unless the box widens or narrows
 * @param start what has been slid at the time [startTime]
 */
public class ImageShear private constructor(
    private val box: Box,
    public val normalAxis: Int,
    public val slideAxis: Int,
    public val velocity: Double,
    public val velocityAcross: Double,
    private val start: Double,
    private val startTime: Double,
) {
    /**
     * Images that stand above one another at time 0.
     *
     * @param flow of the spheres in [box]; images one box away move with the flow that is there
     * @throws IllegalArgumentException when the flow is along its own normal or along z, along which no image can slide
     */
    public constructor(box: Box, flow: MeanFlow) : this(box, flow, Double.NaN, 0.0)

    private constructor(box: Box, flow: MeanFlow, start: Double, startTime: Double) : this(
        box,
        flow.normalAxis,
        flow.flowAxis,
        flow.rate * box.length(flow.normalAxis),
        flow.spread * box.length(flow.normalAxis),
        start,
        startTime,
    )

    private val slideLength = box.length(slideAxis)

    init {
        require(slideAxis < AXES - 1 && slideAxis != normalAxis) {
            "images slide along ${AXIS_NAMES[slideAxis]} across ${AXIS_NAMES[normalAxis]}; " +
                "they can slide along x or y, across another axis"
        }
    }

    /** The rate at which images come nearer across the normal axis, see [BoundaryConditions.approach]. */
    internal val approach: Double
        get() = if (velocityAcross == 0.0) 0.0 else -velocityAcross / box.length(normalAxis)

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
        val across = population.velocity(normalAxis)
        val offset = offset(time)
        val turns = turns(time)
        wrap(population, normalAxis, box, from, to) { k, boxes ->
            along[k] -= boxes * offset
            speed[k] -= boxes * velocity
            if (velocityAcross != 0.0) across[k] -= boxes * velocityAcross
            population.addCrossing(k, slideAxis, (-boxes * turns).toInt())
        }
    }

    public companion object {
        /** Images of which the one at +1 is displaced by [offset] at [time]. */
        @JvmStatic
        public fun at(box: Box, flow: MeanFlow, offset: Double, time: Double): ImageShear =
            ImageShear(box, flow, offset, time)

        /**
         * Images in [box], of which the one at +1 along x has slid by [slid] along y at [time], and moves with
         * [velocityX] and [velocityY].
         */
        internal fun at(box: Box, slid: Double, time: Double, velocityX: Double, velocityY: Double): ImageShear =
            ImageShear(box, 0, 1, velocityY, velocityX, slid, time)
    }
}
