package daphnis.analysis.transport

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt
import kotlin.math.tanh

/** Bulk viscosity and conductivity of made data, whose answer is known. [HelfandGasTest] has those of a gas. */
class HelfandCoefficientsTest {
    @TempDir
    lateinit var directory: Path

    private val header =
        "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,mean_vx,mean_vy,mean_vz,scale_height,collisions," +
            "sum_impact_speed,dissipated,virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy"
    private val ofHeat = ",kinetic_heat_x,kinetic_heat_y,kinetic_heat_z,collisional_heat_x,collisional_heat_y," +
        "collisional_heat_z"

    private fun read(lines: List<String>, hasHeat: Boolean = true): TransportTable {
        val path = directory.resolve("transport.csv")
        Files.write(path, listOf(header + if (hasHeat) ofHeat else "") + lines)
        return TransportTable.read(path)
    }

    /**
     * Rows 0.1 apart of 20 spheres of mass 2 and temperature 3. The virial has a mean pressure and white noise of
     * intensity [noise] in Σ Δp·δ/3; the heat has white noise of [jumps] and what is carried of the variance [carried],
     * which forgets within 0.5, as it is seen from a box in which the centre of mass moves with [velocity].
     */
    private fun made(rows: Int, random: SeededRandom, velocity: DoubleArray = DoubleArray(3)): List<String> {
        val virial = DoubleArray(6)
        val heat = DoubleArray(3)
        val carried = DoubleArray(3) { sqrt(CARRIED) * random.nextGaussian() }
        val keep = exp(-STEP / MEMORY)
        val index = listOf(listOf(0, 3, 4), listOf(3, 1, 5), listOf(4, 5, 2))
        return List(rows) { row ->
            for (k in 0..5) {
                virial[k] +=
                    if (k < 3) STEP * 80 + sqrt(3 * STEP * NOISE) * random.nextGaussian() else random.nextGaussian()
            }
            for (a in 0..2) {
                heat[a] += sqrt(STEP * JUMPS) * random.nextGaussian()
                carried[a] = keep * carried[a] + sqrt((1 - keep * keep) * CARRIED) * random.nextGaussian()
            }
            val seen = List(3) { a -> heat[a] + (0..2).sumOf { b -> velocity[b] * virial[index[a][b]] } }
            "$row,${STEP * row},20,40,3,3,3,0,0,0,${velocity.joinToString(",")},1,${30 * STEP * row},0,0," +
                "${virial.joinToString(",")},0,${carried.joinToString(",")},${seen.joinToString(",")}"
        }
    }

    private fun covers(truth: Double, rows: Int, measure: (TransportTable) -> Pair<Double, Double>) {
        val random = SeededRandom(7)
        val found = List(REALISATIONS) { measure(read(made(rows, random))) }
        val given = found.filter { !it.second.isNaN() }
        val covered = given.count { abs(it.first - truth) <= it.second }
        val mean = found.sumOf { it.first } / found.size
        val said = "$covered of ${given.size}, $mean of $truth"
        if (isFull) println(said)
        assertTrue(given.size > 0.9 * found.size && covered.toDouble() / given.size in 0.60..0.75) { said }
        assertEquals(truth, mean, (if (isFull) 0.02 else 0.05) * truth) { said }
    }

    @Test
    fun `the bulk viscosity of white noise is known, and covered in 60 to 75 percent`() {
        covers(NOISE / (2 * VOLUME * THERMAL), 801) {
            val found = HelfandBulkViscosity.of(it, VOLUME, 0.1)!!
            assertEquals(3.4, found.lag, 1e-9)
            found.average.mean to found.average.error
        }
    }

    @Tag("thorough")
    @Test
    fun `a mean pressure from few lags leaves the bulk viscosity as it is`() {
        val random = SeededRandom(3)
        val runs = 400
        // 136 rows are four lags: without its factor the mean would be 0.62 of this.
        val mean =
            (1..runs).sumOf { HelfandBulkViscosity.of(read(made(136, random)), VOLUME, 0.1)!!.average.mean } / runs
        val truth = NOISE / (2 * VOLUME * THERMAL)
        assertEquals(truth, mean, 0.12 * truth)
    }

    @Test
    fun `the conductivity of white noise and of what forgets is known, and covered in 60 to 75 percent`() {
        val x = STEP / MEMORY / 2
        val truth = (JUMPS / 2 + CARRIED * MEMORY * x / tanh(x)) / (VOLUME * THERMAL * THERMAL)
        covers(truth, 1201) {
            val found = HelfandConductivity.of(it, VOLUME, 0.1)!!
            assertEquals(5.0, found.lag, 1e-9)
            found.average.mean to found.average.error
        }
    }

    @Test
    fun `a centre of mass that moves changes no conductivity`() {
        val still = HelfandConductivity.of(read(made(801, SeededRandom(1))), VOLUME, 0.1)!!
        val velocity = doubleArrayOf(1.0, -2.0, 0.5)
        val moving = HelfandConductivity.of(read(made(801, SeededRandom(1), velocity)), VOLUME, 0.1)!!
        assertEquals(still.average.mean, moving.average.mean, 1e-9 * still.average.mean)
        assertEquals(still.average.error, moving.average.error, 1e-9)
    }

    @Test
    fun `a table without heat has no conductivity, and too few rows have neither`() {
        val lines = made(801, SeededRandom(2))
        val bare = read(lines.map { it.split(',').dropLast(6).joinToString(",") }, hasHeat = false)
        assertNull(HelfandConductivity.of(bare, VOLUME, 0.1))
        assertNotNull(HelfandBulkViscosity.of(bare, VOLUME, 0.1))
        assertNull(HelfandConductivity.of(read(lines.take(51)), VOLUME, 0.1))
        assertNull(HelfandBulkViscosity.of(read(lines.take(34)), VOLUME, 0.1))
        assertNull(HelfandBulkViscosity.of(read(lines.take(1)), VOLUME, 0.1))
    }

    private companion object {
        const val VOLUME = 5.0
        const val THERMAL = 6.0
        const val STEP = 0.1
        const val NOISE = 4.0
        const val JUMPS = 5.0
        const val CARRIED = 9.0
        const val MEMORY = 0.5
        val isFull = System.getProperty("daphnis.physics") == "full"
        val REALISATIONS = if (isFull) 400 else 60
    }
}
