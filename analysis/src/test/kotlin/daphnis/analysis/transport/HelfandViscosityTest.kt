package daphnis.analysis.transport

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt
import kotlin.math.tanh

/** The shear viscosity of made data, whose answer is known. [HelfandGasTest] has that of a gas. */
class HelfandViscosityTest {
    @TempDir
    lateinit var directory: Path

    private val header =
        "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,scale_height,collisions,sum_impact_speed,dissipated," +
            "virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy"

    private fun read(lines: List<String>): TransportTable {
        val path = directory.resolve("transport.csv")
        Files.write(path, listOf(header) + lines)
        return TransportTable.read(path)
    }

    /**
     * Rows 0.1 apart of 20 spheres of mass 2 and temperature 3 in a volume 5. Jumps of the virial are white noise of
     * intensity [jumps] in each shear, under a pressure that fluctuates; what particles carry has the variance
     * [carried] and forgets within 0.3.
     */
    private fun made(
        rows: Int,
        random: SeededRandom,
        jumps: Double = 1.0,
        carried: Double = 0.0,
        rate: Double = 3.0,
        time: (Int) -> Double = { 0.1 * it },
    ): TransportTable {
        val virial = DoubleArray(6)
        val stress = DoubleArray(6) { scale(it) * sqrt(carried) * random.nextGaussian() }
        val keep = exp(-0.1 / MEMORY)
        return read(
            List(rows) { row ->
                val pressure = 8 + random.nextGaussian()
                for (k in 0..5) {
                    stress[k] =
                        keep * stress[k] + sqrt(1 - keep * keep) * sqrt(carried) * scale(k) * random.nextGaussian()
                    virial[k] += scale(k) * sqrt(0.1 * jumps) * random.nextGaussian() + if (k < 3) pressure else 0.0
                }
                val c = List(6) { stress[it] / MASS + if (it < 3) TEMPERATURE else 0.0 }
                "$row,${time(row)},20,$MASS,${c.joinToString(",")},1,${rate * 10 * time(row)},0,0," +
                    "${virial.joinToString(",")},0"
            },
        )
    }

    /** Of each diagonal component: half the difference of two then has the variance of xy. */
    private fun scale(component: Int) = if (component < 3) sqrt(2.0) else 1.0

    @Test
    fun `of white noise and of what forgets the value is known, and covered in 60 to 75 percent`() {
        // S/(2 V kT), and variance times memory over V kT, with the sum in place of the integral.
        val x = 0.1 / MEMORY / 2
        val truth = 4.0 / (2 * VOLUME * 6) + 3.0 * MEMORY * x / tanh(x) / (VOLUME * 6)
        val random = SeededRandom(5)
        var covered = 0
        var given = 0
        var sum = 0.0
        repeat(REALISATIONS) {
            val found = HelfandViscosity.of(made(801, random, 4.0, 3.0), VOLUME, 0.1)!!
            assertEquals(3.4, found.lag, 1e-9)
            sum += found.average.mean
            if (found.average.isLevelled) given++
            if (abs(found.average.mean - truth) <= found.average.error) covered++
        }
        val said = "$covered of $given, ${sum / REALISATIONS} of $truth"
        assertTrue(given > 0.9 * REALISATIONS && covered.toDouble() / given in 0.60..0.75) { said }
        assertEquals(truth, sum / REALISATIONS, (if (isFull) 0.02 else 0.04) * truth) { said }
    }

    @Test
    fun `what momentum particles carry counts, not what is corrected for a temperature of few`() {
        val table = made(400, SeededRandom(7), jumps = 0.0, carried = 3.0)
        val path = directory.resolve("transport.csv")
        val lines = Files.readAllLines(path)
        val components = listOf("xx", "yy", "zz", "xy", "xz", "yz")
        val twice = lines.mapIndexed { k, line ->
            val more = if (k ==
                0
            ) {
                components.map { "kinetic_$it" }
            } else {
                line.split(",").subList(4, 10).map { 2 * it.toDouble() }
            }
            "$line,${more.joinToString(",")}"
        }
        Files.write(path, twice)
        val plain = HelfandViscosity.of(table, VOLUME, 0.1)!!.average.mean
        assertEquals(
            4 * plain,
            HelfandViscosity.of(TransportTable.read(path), VOLUME, 0.1)!!.average.mean,
            1e-9 * plain,
        )
    }

    @Test
    fun `the lag is ten mean free times, or two diameters at thermal speed`() {
        val table = made(400, SeededRandom(1))
        assertEquals(3.4, HelfandViscosity.of(table, VOLUME, 0.1)!!.lag, 1e-9)
        assertEquals(5.8, HelfandViscosity.of(table, VOLUME, 2.88 * sqrt(TEMPERATURE))!!.lag, 1e-9)
    }

    @Test
    fun `rows that are too few, too far apart or uneven have no viscosity, and a last one that is near is left out`() {
        val random = SeededRandom(2)
        assertNull(HelfandViscosity.of(made(1, random), VOLUME, 0.1))
        assertNull(HelfandViscosity.of(made(34, random), VOLUME, 0.1))
        assertNull(HelfandViscosity.of(made(400, random, rate = 0.0), VOLUME, 0.1))
        assertNull(HelfandViscosity.of(made(400, random, rate = 5.1), VOLUME, 0.1))
        assertNotNull(HelfandViscosity.of(made(400, random, rate = 4.9), VOLUME, 0.1))
        assertNull(HelfandViscosity.of(made(400, random) { 0.1 * it + if (it > 200) 0.05 else 0.0 }, VOLUME, 0.1))
        val even = HelfandViscosity.of(made(400, SeededRandom(3)), VOLUME, 0.1)!!
        val near = HelfandViscosity.of(made(401, SeededRandom(3)) { if (it < 400) 0.1 * it else 39.95 }, VOLUME, 0.1)!!
        assertEquals(even.average.mean, near.average.mean, 1e-2 * even.average.mean)
        assertEquals(even.lag, near.lag, 1e-12)
    }

    private companion object {
        const val VOLUME = 5.0
        const val MASS = 40
        const val TEMPERATURE = 3.0
        const val MEMORY = 0.3

        val isFull = System.getProperty("daphnis.physics") == "full"
        val REALISATIONS = if (isFull) 400 else 80
    }
}
