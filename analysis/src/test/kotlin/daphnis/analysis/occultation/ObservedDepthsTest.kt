package daphnis.analysis.occultation

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.format.FormatException
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.exp
import kotlin.math.sin
import kotlin.math.sqrt

@Tag("jdk-neutral")
class ObservedDepthsTest {
    @TempDir
    lateinit var directory: Path

    private fun file(text: String): Path = Files.writeString(directory.resolve("seen.csv"), text)

    @Test
    fun `a table has its columns in any order, with units, remarks and further columns`() {
        val table = ObservedDepths.read(
            file(
                "# A ring\nstar [J],error,azimuth [°],optical_depth [1],elevation [degrees]\n" +
                    "α,1e-1,+30,.7,20.\n\n  # β\nβ,0.2,-15,0.5,90\n",
            ),
        )
        assertTrue(table.areDepths)
        assertEquals(listOf(0.7, 0.5), table.values.toList())
        assertEquals(listOf(0.1, 0.2), table.errors.toList())
        assertEquals(listOf(Math.toRadians(20.0), PI / 2), table.lines.map { it.elevation })
        assertEquals(listOf(Math.toRadians(30.0), Math.toRadians(-15.0)), table.lines.map { it.azimuth })
        assertFalse(ObservedDepths.read(file("elevation,azimuth,transmission,error\n20,0,0.5,0.01")).areDepths)
    }

    @Test
    fun `transmissions that noise carried beyond 0 and 1 are remarked with their lines, farther ones refused`() {
        val head = "elevation,azimuth,transmission,error\n"
        val table = ObservedDepths.read(file("# B\n${head}20,0,1.2,0.1\n20,0,1,0.1\n20,0,-0.01,0.1\n20,0,0,0.1\n"))
        assertEquals(
            listOf(
                "Line 3 of the file has the transmission 1.2, which is not in 0 to 1.",
                "Line 5 of the file has the transmission -0.01, which is not in 0 to 1.",
            ),
            table.remarks,
        )
        assertEquals(1.2, table.values[0])
        val depth = "elevation,azimuth,optical_depth,error\n"
        assertEquals(emptyList<String>(), ObservedDepths.read(file(depth + "20,0,1.2,0.1\n")).remarks)
        for (row in listOf("20,0,1.6,0.1", "20,0,-0.6,0.1")) {
            val path = file(head + row)
            val said = assertThrows(FormatException::class.java) { ObservedDepths.read(path) }.message!!
            assertTrue(said.startsWith("$path:2: transmission is '${row.split(',')[2]}'; it must be in [0, 1]")) {
                said
            }
        }
    }

    @Test
    fun `each fault of a file is one line, which names the file and the line of it`() {
        val head = "elevation,azimuth,optical_depth,error\n"
        for ((text, words) in listOf(
            "" to ": is empty",
            "# nothing\n" to ": is empty",
            head to ": has no rows",
            "elevation,azimuth,error\n1,2,3\n" to ": column 'transmission' is missing, and there is no 'optical_depth'",
            "elevation,optical_depth,error\n1,2,3\n" to ": column 'azimuth' is missing",
            "elevation,azimuth,optical_depth,transmission,error\n1,2,3,4,5\n" to
                ": there are optical_depth and transmission",
            head + "20,0,0.5,0.1\n20,0,0.5\n" to ":3: 3 values, the header has 4",
            head + "\n0,0,0.5,0.1\n" to ":3: elevation is '0'; it must be in 0.1..90 degrees",
            head + "1e-9,0,0.5,0.1\n" to ":2: elevation is '1e-9'; it must be in 0.1..90 degrees",
            head + "91,0,0.5,0.1\n" to ":2: elevation is '91'",
            head + "20,400,0.5,0.1\n" to ":2: azimuth is '400'; it must be in -360..360",
            head + "20,0,NaN,0.1\n" to ":2: optical_depth is 'NaN'; it must be a number in -1000..1000",
            head + "20,0,half,0.1\n" to ":2: optical_depth is 'half'",
            head + "20,0,0.5,0\n" to ":2: error is '0'; it must be finite and at least 1.0E-12",
            head + "20,0,0.5,1e-300\n" to ":2: error is '1e-300'",
            head + "20,0,0.5,Infinity\n" to ":2: error is 'Infinity'",
            head + "20,0,1e200,0.1\n" to ":2: optical_depth is '1e200'",
            head + "20,0,0x1p-1,0.1\n" to ":2: optical_depth is '0x1p-1'",
            head + "20,0,0.5d,0.1\n" to ":2: optical_depth is '0.5d'",
            head + "20,0,0.5,1f\n" to ":2: error is '1f'",
            "elevation [rad],azimuth,optical_depth,error\n1,2,3,4\n" to
                ": elevation is in 'rad'; it must be in degrees",
            "elevation,azimuth [h],optical_depth,error\n1,2,3,4\n" to ": azimuth is in 'h'; it must be in degrees",
            "elevation,azimuth,transmission [%],error\n1,2,3,4\n" to
                ": transmission is in '%'; it must be a pure number",
            "elevation,azimuth,transmission,error [mag],error\n1,2,3,4,5\n" to ": column 'error' occurs twice",
            head + "20,0,0.5,-1\n" to ":2: error is '-1'",
            head + "20,0,0.5,0.1\n".repeat(1001) to ": 1001 rows; at most 1000",
        )) {
            val path = file(text)
            val said = assertThrows(FormatException::class.java, { ObservedDepths.read(path) }, words).message!!
            assertTrue(said.startsWith("$path$words") && '\n' !in said) { said }
        }
        val none = directory.resolve("none.csv")
        assertTrue("no such file" in assertThrows(FormatException::class.java) { ObservedDepths.read(none) }.message!!)
        val bytes = Files.write(directory.resolve("bytes.csv"), byteArrayOf(-1, -2, 7))
        val said = assertThrows(FormatException::class.java) { ObservedDepths.read(bytes) }.message
        assertEquals("$bytes: is not UTF-8 text", said)
    }

    @Test
    fun `χ² of what was drawn from the patch is about the number of lines, and more where the patch has no error`() {
        val random = SeededRandom(4)
        val rows = List(400) { 10.0 + it / 5.0 }
        val truth = rows.map { exp(-0.4 / sin(Math.toRadians(it))) }
        for (kind in listOf("transmission", "optical_depth")) {
            val text = rows.mapIndexed { k, b ->
                val t = truth[k] * (1 + 0.03 * random.nextGaussian())
                val depth = -sin(Math.toRadians(b)) * Math.log(t)
                if (kind ==
                    "transmission"
                ) {
                    "$b,0,$t,${0.03 * truth[k]}"
                } else {
                    "$b,0,$depth,${0.03 * sin(Math.toRadians(b))}"
                }
            }
            val observed = ObservedDepths.read(file("elevation,azimuth,$kind,error\n" + text.joinToString("\n")))
            val seen = truth.map { BlockAverage(it * (1 + 0.02 * random.nextGaussian()), 0.02 * it, 30) }
            val comparison = DepthComparison(observed, seen)
            assertEquals(400, comparison.count)
            assertEquals(400.0, comparison.chiSquare, 3 * sqrt(800.0)) { kind }
            // Without an error of the patch that of the observation alone is left, which is too small.
            val bare = DepthComparison(observed, seen.map { BlockAverage(it.mean, Double.NaN, 5) })
            assertEquals(400 * 13.0 / 9, bare.chiSquare, 3 * 13.0 / 9 * sqrt(800.0)) { kind }
        }
    }

    @Test
    fun `a line along which nothing comes through has no depth and is left out`() {
        val observed = ObservedDepths.read(file("elevation,azimuth,optical_depth,error\n30,0,0.5,0.1\n30,90,0.5,0.1\n"))
        val comparison = DepthComparison(observed, listOf(BlockAverage(0.0, 0.0, 20), BlockAverage(exp(-0.8), 0.0, 20)))
        assertEquals(1, comparison.count)
        assertTrue(comparison.residuals[0].isNaN())
        assertEquals(0.1, comparison.residuals[1], 1e-12)
        assertEquals(1.0, comparison.chiSquare, 1e-9)
        val thin = ObservedDepths.read(file("elevation,azimuth,transmission,error\n30,0,0.2,0.1\n"))
        assertEquals(4.0, DepthComparison(thin, listOf(BlockAverage(0.0, 0.0, 20))).chiSquare, 1e-9)
    }
}
