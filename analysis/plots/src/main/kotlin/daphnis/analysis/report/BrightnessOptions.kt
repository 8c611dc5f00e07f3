package daphnis.analysis.report

import daphnis.analysis.brightness.Brightness
import daphnis.analysis.brightness.Illumination
import daphnis.analysis.brightness.ObservedBrightness
import daphnis.analysis.brightness.ScatteringLaw
import daphnis.analysis.occultation.Transmissions
import daphnis.core.input.InputException
import kotlin.math.abs

/**
 * What is computed of the brightness of a patch: I/F over the elevations and azimuths of
 * [AnalysisOptions.occultation], the latter over a whole turn, and over phase angles at [AnalysisOptions.elevation] and
 * [AnalysisOptions.azimuth].
 *
 * @property law of the surfaces of spheres
 * @property lightElevation of the light in degrees, below 0 from below; null for that of the eye, whichever it is
 * @property phaseAngle of the grid over elevations and azimuths in degrees, see [Illumination]; null for the least
 * @property phaseAngles in degrees, over which the brightness is computed; none for a choice
 * @property orders of scattering, see [Brightness], [paths] and [seed] too
 * @property observed brightness that is compared; null for none
 * @throws InputException for one of these that is out of range, with its name
 */
public class BrightnessOptions @JvmOverloads constructor(
    public val law: ScatteringLaw,
    public val lightElevation: Double? = null,
    public val phaseAngle: Double? = null,
    public val phaseAngles: DoubleArray = DoubleArray(0),
    public val orders: Int = 1,
    public val paths: Int = Brightness.PATHS,
    public val seed: Long = 1,
    public val observed: ObservedBrightness? = null,
) {
    init {
        lightElevation?.let {
            if (!Illumination.isElevation(it)) throw wrong("lightElevation", it, Illumination.ELEVATIONS)
        }
        phaseAngle?.let { checkPhase("phaseAngle", it) }
        for (angle in phaseAngles) checkPhase("phaseAngles", angle)
        if (phaseAngles.size > MOST) throw wrong("phaseAngles", "${phaseAngles.size} of them", "at most $MOST")
        if (orders !in 1..Brightness.MOST_ORDERS) throw wrong("orders", orders, "in 1..${Brightness.MOST_ORDERS}")
        if (paths !in 1..MOST_PATHS) throw wrong("paths", paths, "in 1..$MOST_PATHS")
        if (orders > 1) checkWhole()
    }

    private fun checkPhase(argument: String, angle: Double) {
        if (!(abs(angle) <= HALF)) throw wrong(argument, angle, "in -180..180 degrees")
    }

    /** Light that is scattered again may come from any direction. */
    private fun checkWhole() {
        val table = law.table ?: return
        if (!table.covers(0.0) || !table.covers(Math.PI)) {
            val span = "${said(table.first)} to ${said(table.last)}"
            throw InputException(TABLE, null, "covers $span degrees; further orders take 0 to 180", isArgument = true)
        }
        if (law.sphericalAlbedo > 1 + SLACK) {
            val problem = "makes a sphere scatter ${ReportText.short(
                law.sphericalAlbedo,
            )} of the light that falls on it"
            throw InputException(TABLE, null, "$problem; it must be 1 at most", isArgument = true)
        }
    }

    /** Refuses what cannot be at the elevations of [options]. */
    internal fun check(options: AnalysisOptions) {
        for (elevation in elevations(options)) checkLine("phaseAngle", elevation, phase(elevation))
        for (angle in phaseAngles) checkLine("phaseAngles", options.elevation, angle)
        for (line in observed?.lines.orEmpty()) {
            checkTable("observedBrightness", ObservedRows.degrees(line.phaseAngle))
        }
    }

    private fun checkLine(argument: String, elevation: Double, angle: Double) {
        Illumination.problem(elevation, light(elevation), angle)?.let { throw wrong(argument, angle, it) }
        checkTable(argument, angle)
    }

    private fun checkTable(argument: String, angle: Double) {
        val table = law.table ?: return
        if (table.covers(abs(Math.toRadians(angle)))) return
        val span = "${said(table.first)} to ${said(table.last)}"
        throw wrong(argument, angle, "in the phase function, which covers $span degrees")
    }

    /** The elevations of the grid in degrees, ascending. */
    internal fun elevations(options: AnalysisOptions): DoubleArray =
        options.occultation.elevations.let { if (it.isEmpty()) doubleArrayOf(options.elevation) else it.sortedArray() }

    /** Its azimuths in degrees, over a whole turn. */
    internal fun azimuths(options: AnalysisOptions): DoubleArray =
        options.occultation.gridAzimuths.let { half -> half + half.map { it + HALF } }

    /** Elevation of the light for an eye at [elevation], in degrees. */
    internal fun light(elevation: Double): Double = lightElevation ?: elevation

    /** Phase angle of the grid at [elevation], in degrees. */
    internal fun phase(elevation: Double): Double = phaseAngle ?: abs(elevation - light(elevation))

    /** The phase angles over which the brightness is computed at [elevation], ascending, in degrees. */
    internal fun phases(elevation: Double): DoubleArray {
        if (phaseAngles.isNotEmpty()) return phaseAngles.sortedArray()
        val least = abs(elevation - light(elevation))
        val usual = (listOf(least) + USUAL.filter { it > least }).filter {
            Illumination.problem(elevation, light(elevation), it) == null &&
                law.table?.covers(Math.toRadians(it)) != false
        }
        return usual.toDoubleArray()
    }

    /** Light and sight at [elevation], [azimuth] and [phase] in degrees. */
    internal fun line(elevation: Double, azimuth: Double, phase: Double): Illumination =
        Illumination.degrees(elevation, azimuth, light(elevation), phase)

    /** I/F along [lines]; at opposition, which takes no ray to the light, from as many rays as the transmission. */
    internal fun measure(lines: List<Illumination>): Brightness {
        val rays = if (lines.all { it.phaseAngle == 0.0 }) Transmissions.RAYS else Transmissions.RAYS / 2
        return Brightness(lines, law, rays, orders, paths, seed)
    }

    private companion object {
        const val HALF = 180.0
        const val MOST = 180
        const val MOST_PATHS = 1_000_000
        const val SLACK = 1e-3
        const val TABLE = "phaseFunction"
        val USUAL = doubleArrayOf(0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)

        fun said(radians: Double) = ReportText.short(Math.toDegrees(radians))

        fun wrong(argument: String, value: Any, right: String) =
            InputException(argument, null, "is $value; it must be $right", isArgument = true)
    }
}
