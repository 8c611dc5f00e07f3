package daphnis.analysis.occultation

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * The part of the ring plane that one number of a light curve is the mean over: the path of a star's image, or of the
 * beam, during one exposure.
 *
 * @property length along the path; the diameter of a disc
 * @property width across the path; the diameter of a disc
 */
public class Footprint private constructor(
    public val length: Double,
    public val width: Double,
    public val isDisc: Boolean,
) {
    init {
        require(length > 0 && length.isFinite() && width > 0 && width.isFinite()) {
            "a footprint is $length long and $width wide; both must be finite and > 0"
        }
    }

    public val area: Double get() = if (isDisc) PI / 4 * length * length else length * width

    /**
     * Set covariance: the area that the footprint has in common with itself displaced by [along] the path and [across]
     * it.
     */
    public fun overlap(along: Double, across: Double): Double = if (isDisc) {
        ofDiscs(length / 2, hypot(along, across))
    } else {
        maxOf(0.0, length - abs(along)) * maxOf(0.0, width - abs(across))
    }

    override fun toString(): String = if (isDisc) "disc of diameter $length" else "$length x $width"

    public companion object {
        /** A rectangle, [length] along the path and [width] across it. */
        @JvmStatic
        public fun rectangle(length: Double, width: Double): Footprint = Footprint(length, width, false)

        @JvmStatic
        public fun disc(diameter: Double): Footprint = Footprint(diameter, diameter, true)

        /** The area that two discs of [radius] have in common, their centres [distance] apart. */
        internal fun ofDiscs(radius: Double, distance: Double): Double {
            if (distance >= 2 * radius) return 0.0
            val half = distance / 2
            return 2 * radius * radius * acos(half / radius) - 2 * half * sqrt((radius - half) * (radius + half))
        }
    }
}
