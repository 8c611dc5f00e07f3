package daphnis.analysis.report

import daphnis.analysis.occultation.Footprint
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.occultation.ObservedDepths
import daphnis.core.input.InputException

/**
 * What is computed of the light through a patch beside the transmission along one line of sight: nothing unless asked.
 *
 * @property elevations of a grid of lines of sight in degrees, each in [[LineOfSight.LOWEST], 90]; none for no grid
 * @property azimuths of the grid: so many, evenly spread over 180°, from 0 on
 * @property footprint of an instrument whose light curves are simulated, in the scenario's unit of length; null for none
 * @property scanPath direction in the plane in which it moves, from x toward y, in degrees
 * @property photons mean number of photons per footprint where nothing is in the way; null for no noise
 * @property observed depths that are compared; null for none
 */
public class OccultationOptions @JvmOverloads constructor(
    public val elevations: DoubleArray = DoubleArray(0),
    public val azimuths: Int = AZIMUTHS,
    public val footprint: Footprint? = null,
    public val scanPath: Double = 0.0,
    public val photons: Double? = null,
    public val observed: ObservedDepths? = null,
) {
    init {
        elevations.find { !(it >= LineOfSight.LOWEST && it <= RIGHT) }?.let {
            throw wrong("elevations", it, "in ${LineOfSight.LOWEST}..90 degrees")
        }
        if (elevations.size > MOST) throw wrong("elevations", "${elevations.size} of them", "at most $MOST")
        if (azimuths !in 1..MOST) throw wrong("azimuths", azimuths, "in 1..$MOST")
        if (!(scanPath >= -2 * HALF && scanPath <= 2 * HALF)) throw wrong("scanPath", scanPath, "in -360..360 degrees")
        photons?.let { if (!(it > 0 && it <= BRIGHTEST)) throw wrong("photons", it, "in (0, $BRIGHTEST]") }
    }

    /** Whether anything is. */
    internal val isAsked: Boolean get() = elevations.isNotEmpty() || footprint != null || observed != null

    /** The azimuths of the grid in degrees. */
    internal val gridAzimuths: DoubleArray get() = DoubleArray(azimuths) { it * HALF / azimuths }

    public companion object {
        /** Azimuths of a grid unless others are asked for. */
        public const val AZIMUTHS: Int = 12

        private const val MOST = 180
        private const val RIGHT = 90.0
        private const val HALF = 180.0
        private const val BRIGHTEST = 1e9

        private fun wrong(argument: String, value: Any, right: String) =
            InputException(argument, null, "is $value; it must be $right", isArgument = true)
    }
}
