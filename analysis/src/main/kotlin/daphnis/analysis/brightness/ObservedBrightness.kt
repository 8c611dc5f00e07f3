package daphnis.analysis.brightness

import daphnis.analysis.occultation.ObservedDepths
import daphnis.analysis.table.CheckedColumns
import daphnis.core.format.FormatException
import java.nio.file.Path
import kotlin.math.abs

/**
 * What was observed of the brightness of a ring, I/F, under several [lines] of light and sight.
 *
 * @property values I/F by line, each with its standard error in [errors]
 */
public class ObservedBrightness private constructor(
    public val lines: List<Illumination>,
    public val values: DoubleArray,
    public val errors: DoubleArray,
) {
    public companion object {
        private const val LIGHT = "light_elevation"
        private const val PHASE = "phase_angle"
        private const val BRIGHTNESS = "i_over_f"
        private const val MOST_VALUE = 1000.0
        private const val HALF = 180.0

        /**
         * Reads a CSV file with the columns `elevation`, `azimuth`, `light_elevation` and `phase_angle` in degrees, as
         * those of [Illumination], and `i_over_f` and `error`; for the rest it is like a table of [ObservedDepths].
         *
         * @throws FormatException naming file and line when it cannot be read, a column is missing, there twice or in
         * another unit, a value is no decimal number or out of range, light and eye cannot stand so, or there is no row
         * or too many
         */
        @JvmStatic
        public fun read(path: Path): ObservedBrightness {
            val angles = listOf(ObservedDepths.ELEVATION, ObservedDepths.AZIMUTH, LIGHT, PHASE)
            val numbers = listOf(BRIGHTNESS, ObservedDepths.ERROR)
            val columns = CheckedColumns.read(path, angles, numbers, ObservedDepths.MOST)
            val lines = List(columns.size) { line(columns, it) }
            val values = DoubleArray(columns.size) { row ->
                columns.number(row, BRIGHTNESS, "a number in -1000..1000") { abs(it) <= MOST_VALUE }
            }
            return ObservedBrightness(lines, values, DoubleArray(columns.size) { ObservedDepths.error(columns, it) })
        }

        private fun line(columns: CheckedColumns, row: Int): Illumination {
            val eye = ObservedDepths.line(columns, row)
            val light = columns.number(row, LIGHT, Illumination.ELEVATIONS) { Illumination.isElevation(it) }
            // As it was typed: the way to radians and back misses by the last digits.
            val elevation = columns.number(row, ObservedDepths.ELEVATION, "an elevation") { true }
            val phase = columns.number(row, PHASE, "in -180..180 degrees") { abs(it) <= HALF }
            val problem = Illumination.problem(elevation, light, phase)
            if (problem != null) columns.number(row, PHASE, problem) { false }
            return Illumination(eye, Math.toRadians(light), Math.toRadians(phase))
        }
    }
}
