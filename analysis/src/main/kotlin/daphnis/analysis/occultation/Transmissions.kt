package daphnis.analysis.occultation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.statistics.BlockAverage
import daphnis.core.boundary.Box
import kotlin.math.sqrt

/**
 * Share of the light that comes through a patch along each of several [lines] of sight: a measure of as many numbers,
 * in their order. Its average over states has the error of [BlockAverage], which includes that of the finite number of
 * rays.
 *
 * @param rays square root of the number of rays per line and state; they are equally far apart along x and y
 */
public class Transmissions @JvmOverloads constructor(
    public val lines: List<LineOfSight>,
    private val rays: Int = RAYS,
) : Measure {
    init {
        require(rays >= 1) { "$rays rays; there must be one at least" }
    }

    override fun of(state: State): DoubleArray = DoubleArray(lines.size) {
        casting(lines[it], state.boundary.box, rays).cast(state).transmission
    }

    /** Normal optical depth of the [average] transmission along line [k]; see [RayCasting.depth]. */
    public fun depth(k: Int, average: BlockAverage): BlockAverage =
        RayCasting(lines[k].elevation, lines[k].azimuth).depth(average)

    public companion object {
        /** Rays per line and state are the square of this. */
        public const val RAYS: Int = 256

        /** The rays along [line] of a patch in [box], the square of [rays] in number and equally far apart. */
        internal fun casting(line: LineOfSight, box: Box, rays: Int): RayCasting {
            val longest = maxOf(box.length(0), box.length(1))
            val along = Math.rint(rays * sqrt(longest / minOf(box.length(0), box.length(1)))).toInt()
            return RayCasting(line.elevation, line.azimuth, along)
        }
    }
}
