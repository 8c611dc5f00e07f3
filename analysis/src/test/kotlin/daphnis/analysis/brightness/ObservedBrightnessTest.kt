package daphnis.analysis.brightness

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.format.FormatException
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.sqrt

@Tag("jdk-neutral")
class ObservedBrightnessTest {
    @TempDir
    lateinit var directory: Path

    private fun file(text: String): Path = Files.writeString(directory.resolve("seen.csv"), text)

    private val head = "elevation,azimuth,light_elevation,phase_angle,i_over_f,error\n"

    @Test
    fun `a table has the light of each row, from above and from below`() {
        val table = ObservedBrightness.read(
            file(
                "# HST\nerror,i_over_f [1],elevation [°],azimuth,phase_angle [deg],light_elevation\n" +
                    "0.01,0.4,28,110,-6,24\n\n0.02,0.1,20,0,90,-30\n0.02,0.1,90,0,62,28\n",
            ),
        )
        assertEquals(listOf(0.4, 0.1, 0.1), table.values.toList())
        assertEquals(listOf(0.01, 0.02, 0.02), table.errors.toList())
        val first = table.lines[0]
        assertEquals(Math.toRadians(24.0), first.lightElevation)
        assertTrue(first.lightAzimuth < first.eye.azimuth)
        assertEquals(Math.toRadians(-30.0), table.lines[1].lightElevation)
        assertEquals(0.0, table.lines[2].lightAzimuth)
    }

    @Test
    fun `each fault of a file is one line, which names the file and the line of it`() {
        for ((text, words) in listOf(
            head to ": has no rows",
            "elevation,azimuth,phase_angle,i_over_f,error\n1,2,3,4,5\n" to ": column 'light_elevation' is missing",
            head + "0,0,28,28,0.4,0.1\n" to ":2: elevation is '0'; it must be in 0.1..90 degrees",
            head + "28,0,0.05,28,0.4,0.1\n" to ":2: light_elevation is '0.05'; it must be in 0.1..90 degrees",
            head + "28,0,-91,28,0.4,0.1\n" to ":2: light_elevation is '-91'",
            head + "28,0,24,200,0.4,0.1\n" to ":2: phase_angle is '200'; it must be in -180..180 degrees",
            head + "28,0,24,3.9,0.4,0.1\n" to ":2: phase_angle is '3.9'; it must be 4 to 128 degrees in size",
            head + "28,0,24,-129,0.4,0.1\n" to ":2: phase_angle is '-129'; it must be 4 to 128",
            head + "28,0,24,6,bright,0.1\n" to ":2: i_over_f is 'bright'; it must be a number in -1000..1000",
            head + "28,0,24,6,0.4,0\n" to ":2: error is '0'",
        )) {
            val path = file(text)
            val said = assertThrows(FormatException::class.java, { ObservedBrightness.read(path) }, words).message!!
            assertTrue(said.startsWith("$path$words") && '\n' !in said) { said }
        }
    }

    @Test
    fun `χ² of what was drawn from the patch is about the number of rows, and the factor is found`() {
        val random = SeededRandom(4)
        val truth = List(400) { 0.1 + it / 2000.0 }
        val rows = truth.joinToString("\n") {
            "28,0,28,0,${1.5 * it * (1 + 0.03 * random.nextGaussian())},${0.045 * it}"
        }
        val observed = ObservedBrightness.read(file(head + rows))
        val seen = truth.map { BlockAverage(it * (1 + 0.02 * random.nextGaussian()), Double.NaN, 5) }
        val comparison = BrightnessComparison(observed, seen)
        // The patch has no error, so that of the observation alone is left: a third of the scatter more, each way.
        assertEquals(1.5, comparison.factor, 4 * comparison.factorError)
        assertEquals(0.03 * 1.5 / 20, comparison.factorError, 1e-4)
        assertEquals(400 * 13.0 / 9, comparison.chiSquareOfFactor, 4 * 13.0 / 9 * sqrt(800.0))
        assertTrue(comparison.chiSquare > 40_000)
        val known = BrightnessComparison(observed, truth.map { BlockAverage(1.5 * it, 0.06 * it, 30) })
        assertEquals(400 * 9.0 / 25, known.chiSquare, 4 * 9.0 / 25 * sqrt(800.0))
        assertEquals(observed.values[7] - 1.5 * truth[7], known.residuals[7], 1e-15)
    }

    @Test
    fun `a phase function is ascending, not below 0, and has two rows at least`() {
        val columns = "phase_angle [degrees],phase_function\n"
        val table = PhaseTable.read(file("$columns# Callisto\n0,4\n10,2\n180,0\n"))
        assertEquals(3.0, table.at(Math.toRadians(5.0)), 1e-12)
        assertEquals(1.0, table.at(Math.toRadians(95.0)), 1e-12)
        assertEquals(PI, table.last)
        assertTrue(table.covers(PI) && table.covers(0.0))
        assertEquals(2.0, PhaseTable(doubleArrayOf(0.1, 0.2), doubleArrayOf(2.0, 5.0)).at(0.0))
        for ((text, words) in listOf(
            "" to ": is empty",
            columns + "0,1\n" to ": has one row; it must have two at least",
            "phase_angle\n0\n" to ": column 'phase_function' is missing",
            "phase_angle [rad],phase_function\n0,1\n1,1\n" to ": phase_angle is in 'rad'; it must be in degrees",
            columns + "0,1\n20,1\n10,1\n" to ":4: phase_angle is '10'; it must be more than that of the row before, 20",
            columns + "0,1\n0,1\n" to ":3: phase_angle is '0'; it must be more than",
            columns + "-1,1\n0,1\n" to ":2: phase_angle is '-1'; it must be in 0..180",
            columns + "0,1\n181,1\n" to ":3: phase_angle is '181'; it must be in 0..180",
            columns + "0,1\n10,-0.1\n" to ":3: phase_function is '-0.1'; it must be a number in 0..",
            columns + "0,1\n10,NaN\n" to ":3: phase_function is 'NaN'",
        )) {
            val path = file(text)
            val said = assertThrows(FormatException::class.java, { PhaseTable.read(path) }, words).message!!
            assertTrue(said.startsWith("$path$words") && '\n' !in said) { said }
        }
        for ((angles, values) in listOf(
            doubleArrayOf(0.0) to doubleArrayOf(1.0),
            doubleArrayOf(0.0, 0.0) to doubleArrayOf(1.0, 1.0),
            doubleArrayOf(0.0, 4.0) to doubleArrayOf(1.0, 1.0),
            doubleArrayOf(0.0, 1.0) to doubleArrayOf(1.0, Double.NaN),
        )) {
            assertThrows(IllegalArgumentException::class.java) { PhaseTable(angles, values) }
        }
    }

    @Test
    fun `laws have the spherical albedos of the books, and albedos beyond 0 and 1 are refused`() {
        assertEquals(0.7, ScatteringLaw.lambert(0.7).sphericalAlbedo, 1e-9)
        // (2/3)(1 − ln 2) of the single-scattering albedo.
        assertEquals(0.5 * 2 / 3 * (1 - Math.log(2.0)), ScatteringLaw.lommelSeeliger(0.5).sphericalAlbedo, 1e-7)
        val even = PhaseTable(doubleArrayOf(0.0, PI), doubleArrayOf(1.0, 1.0))
        assertEquals(0.3, ScatteringLaw.ofSpheres(0.3, even).sphericalAlbedo, 1e-6)
        for (wrong in listOf(-0.1, 1.1, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) { ScatteringLaw.lambert(wrong) }
        }
        // The series near 180° meets the formula.
        val near = PI - 0.0200001
        assertEquals(ScatteringLaw.ofDisc(PI - 0.0199999), ScatteringLaw.ofDisc(near), 1e-7)
        assertEquals(1.0, ScatteringLaw.ofDisc(0.0))
    }

    @Test
    fun `light and eye stand at the phase angle, where they can`() {
        for ((b, light, phase) in listOf(
            Triple(28.0, 28.0, 0.0),
            Triple(28.0, 28.0, 1e-5),
            Triple(28.0, 24.0, 4.0),
            Triple(28.0, 24.0, 60.0),
            Triple(28.0, -24.0, 176.0),
            Triple(90.0, 20.0, 70.0),
            Triple(1.0, 1.0, 178.0),
            Triple(30.0, 40.0, -50.0),
        )) {
            val line = Illumination.degrees(b, 33.0, light, phase)
            val e = line.toEye
            val s = line.light
            val cross = doubleArrayOf(e[1] * s[2] - e[2] * s[1], e[2] * s[0] - e[0] * s[2], e[0] * s[1] - e[1] * s[0])
            val angle = StrictMath.atan2(sqrt(cross.sumOf { it * it }), (0..2).sumOf { e[it] * s[it] })
            assertEquals(Math.toRadians(Math.abs(phase)), angle, 1e-9) { "$b, $light, $phase" }
            assertEquals(Math.toRadians(light), StrictMath.asin(s[2]), 1e-9)
            assertTrue(if (phase < 0) cross[2] < 0 else cross[2] >= -1e-12)
        }
        for ((b, light, phase) in listOf(Triple(28.0, 24.0, 3.9), Triple(28.0, 24.0, 129.0), Triple(28.0, 0.0, 40.0))) {
            assertThrows(IllegalArgumentException::class.java) { Illumination.degrees(b, 0.0, light, phase) }
        }
    }
}
