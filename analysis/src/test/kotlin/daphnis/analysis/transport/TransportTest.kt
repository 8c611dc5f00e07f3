package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.format.FormatException
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.atan
import kotlin.math.sqrt

class TransportTest {
    @TempDir
    lateinit var directory: Path

    private val header =
        "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,mean_vx,mean_vy,mean_vz," +
            "centre_z,scale_height,guiding_x,collisions,sum_impact_speed,dissipated," +
            "virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy"

    private fun file(vararg rows: String): Path = directory.resolve("transport.csv").also {
        Files.write(
            it,
            listOf(header) + rows,
        )
    }

    @Test
    fun `viscosities, rates and the energy balance of made rows`() {
        // Ω = 2, γ = −3: 10 spheres of mass 1, 5 collisions a unit of time with impact speed 0.5, virial_xy 6 and
        // dissipation 4.05 a unit of time.
        val rows = (0..9).map { t ->
            "$t,$t,10,10,0.5,0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,${5 * t},${2.5 * t},${40.5 * t}," +
                "${8 * t},${8 * t},${8 * t},${6 * t},0,0,3"
        }
        val transport = Transport(TransportTable.read(file(*rows.toTypedArray())).from(2.0), -3.0)
        assertEquals(7.0, transport.duration)
        assertEquals(7.0 / PI, transport.orbits(2.0), 1e-12)
        assertEquals(1.0, transport.dispersion.mean, 1e-12)
        assertEquals(1.0 / 3, transport.temperature.mean, 1e-12)
        assertEquals(1.0, transport.collisionRate.mean, 1e-12)
        assertEquals(0.5, transport.impactSpeed.mean, 1e-12)
        assertEquals(0.2, transport.translational.mean, 1e-12)
        assertEquals(0.2, transport.collisional.mean, 1e-12)
        assertEquals(0.1, transport.gravitational.mean, 1e-12)
        assertEquals(4.05, transport.dissipation.mean, 1e-12)
        assertEquals(9 * 0.5 / 4.05, transport.energyBalance.mean, 1e-12)
        assertEquals(0.5 + 0.8, transport.pressure("xx").mean, 1e-12)
        val ratios = listOf("xx", "yy", "zz").map { transport.pressureRatio(it).mean }
        assertEquals(1.3 / 3.4 * 3, ratios[0], 1e-12)
        assertEquals(1.1 / 3.4 * 3, ratios[1], 1e-12)
        assertEquals(3.0, ratios.sum(), 1e-14)
        assertEquals(1.2 / 3.4 * 3, transport.pressureRatio("xy").mean, 1e-12)
        assertEquals(1.5, transport.scaleHeight.mean, 1e-12)
        assertEquals(0.5, transport.viscosity.mean, 1e-12)
        assertEquals((1.0 + 2.4) / 3, transport.pressure.mean, 1e-12)
        assertEquals(3.4, transport.compressibility.mean, 1e-12)
        assertEquals(0.5 * Math.atan2(1.2, 0.2), transport.orientation.mean, 1e-12)
        val hot = file(*rows.map { it.replace(",0.5,0.3,0.2,", ",1,0.6,0.4,") }.toTypedArray())
        assertEquals((2.0 + 2.4) / 2, Transport(TransportTable.read(hot), -3.0).compressibility.mean, 1e-12)
    }

    @Test
    fun `what works against the shear is momentum along the flow that is carried across it`() {
        val rows = (0..3).map { t -> "$t,$t,10,10,0.5,0.3,0.2,0,0,0,0,0,0,0,1.5,0,0,0,0,0,0,0,${6 * t},0,0,0" }
        val path = file(*rows.toTypedArray())
        // Of smooth spheres both are the same, and the file has one.
        for (axis in 0..1) {
            assertEquals(0.2, Transport(TransportTable.read(path), -3.0, flowAxis = axis).collisional.mean, 1e-12)
        }
        Files.write(path, listOf("$header,virial_yx") + rows.mapIndexed { t, row -> "$row,${4.5 * t}" })
        val rough = TransportTable.read(path)
        assertEquals(0.2, Transport(rough, -3.0, flowAxis = 0).collisional.mean, 1e-12)
        assertEquals(0.15, Transport(rough, -3.0, flowAxis = 1).collisional.mean, 1e-12)
        assertEquals(0.15, Transport(rough, -3.0, flowAxis = 1).viscosity.mean, 1e-12)
    }

    /**
     * Rows of a sheared gas whose temperature 1 + 0.1 [wobble] drives everything, pressures and stresses of both parts
     * together; γ = 2 in a box of Lees and Edwards. Intervals are of lengths 1 and 3 by turns.
     */
    private fun sheared(rows: Int, random: SeededRandom, memory: Double): TransportTable {
        val keep = Math.exp(-1 / memory)
        var wobble = random.nextGaussian()
        val sums = DoubleArray(7)
        var t = 0.0
        val lines = List(rows) { row ->
            val dt = if (row % 2 == 0) 1.0 else 3.0
            t += dt
            wobble = keep * wobble + Math.sqrt(1 - keep * keep) * random.nextGaussian()
            val f = 1 + 0.1 * wobble
            val gains = doubleArrayOf(50.0, 25.0, 48.0, 80.0, 80.0, 80.0, -60.0)
            for (k in sums.indices) sums[k] += gains[k] * dt * (f + 0.02 * random.nextGaussian())
            "$row,$t,10,10,${0.5 * f},${0.3 * f},${0.2 * f},${-1.2 * f},0,0,0,0,0,0,${1.5 * f},0," +
                "${sums.joinToString(",")},0,0,${-20 * f}"
        }
        return TransportTable.read(file(*lines.toTypedArray()))
    }

    @Tag("thorough")
    @Test
    fun `quantities whose parts move together cover the truth in 60 to 75 percent`() {
        val truth = listOf<Triple<String, Double, (Transport) -> BlockAverage>>(
            Triple("temperature", 1.0 / 3) { it.temperature },
            Triple("dispersion", 1.0) { it.dispersion },
            Triple("scale height", 1.5) { it.scaleHeight },
            Triple("collision rate", 10.0) { it.collisionRate },
            Triple("impact speed", 0.5) { it.impactSpeed },
            Triple("pressure", (1.0 + 24.0) / 3) { it.pressure },
            Triple("compressibility", 25.0) { it.compressibility },
            Triple("pressure xx", 8.5) { it.pressure("xx") },
            Triple("stress", -7.2) { it.pressure("xy") },
            Triple("viscosity, total", (1.2 + 6.0 + 2.0) / 2) { it.viscosity },
            Triple("energy balance", 4 * 4.6 / 4.8) { it.energyBalance },
        )
        val random = SeededRandom(21)
        val covered = IntArray(truth.size)
        val given = IntArray(truth.size)
        repeat(REALISATIONS) {
            val transport = Transport(sheared(120, random, 1.5), 2.0)
            for ((k, quantity) in truth.withIndex()) {
                val a = quantity.third(transport)
                if (a.isLevelled) given[k]++
                if (Math.abs(a.mean - quantity.second) <= a.error) covered[k]++
            }
        }
        for ((k, quantity) in truth.withIndex()) {
            assertTrue(given[k] > 0.95 * REALISATIONS && covered[k].toDouble() / given[k] in 0.60..0.75) {
                "${quantity.first}: ${covered[k]} of ${given[k]}"
            }
        }
    }

    /** Of a flow in which gravity does the work 45 and what is not dissipated is in [potential], γ = −3. */
    private fun attracting(potential: DoubleArray): TransportTable {
        val rows = potential.indices.map { t ->
            "$t,$t,10,10,0.5,0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,${5 * t},${2.5 * t},${45 * t - potential[t]}," +
                "${8 * t},${8 * t},${8 * t},${6 * t},0,0,3"
        }
        return TransportTable.read(file(*rows.toTypedArray()))
    }

    @Test
    fun `what changes of the potential energy take from the balance of energies adds up, where it is known`() {
        val random = SeededRandom(31)
        val keep = Math.exp(-1 / 3.0)
        val runs = List(100) {
            var u = 20 * random.nextGaussian()
            val potential = DoubleArray(120) {
                u.also { u = keep * u + 20 * sqrt(1 - keep * keep) * random.nextGaussian() }
            }
            val table = attracting(potential)
            Transport(table, -3.0).energyBalance to Transport(table, -3.0, potential).energyBalance
        }
        fun spread(of: List<BlockAverage>) =
            sqrt(of.sumOf { (it.mean - 1) * (it.mean - 1) } / of.sumOf { it.error * it.error })
        assertTrue(spread(runs.map { it.first }) < 0.7) { "${spread(runs.map { it.first })}" }
        assertEquals(1.0, spread(runs.map { it.second }), 0.2)
        val unknown = Transport(attracting(DoubleArray(120)), -3.0, DoubleArray(120) { Double.NaN }).energyBalance
        assertEquals(1.0, unknown.mean, 1e-12)
        assertTrue(runs.all { (without, with) -> without.mean == with.mean })
        assertThrows(IllegalArgumentException::class.java) {
            Transport(attracting(DoubleArray(9)), -3.0, DoubleArray(8))
        }
    }

    /** Of grains whose walls give 45 and what their [energy] takes, per unit of time, in 10 of mass. */
    private fun walled(energy: DoubleArray): TransportTable {
        val rows = energy.indices.map { t ->
            "$t,$t,10,10,${energy[t] / 5},0,0,0,0,0,0,0,0,${energy[t] / 10},1.5,0,${5 * t},${2.5 * t},${45 * t}," +
                "0,0,0,0,0,0,0,${45 * t + 2 * energy[t]}"
        }
        return TransportTable.read(file().also { Files.write(it, listOf("$header,wall_work") + rows) })
    }

    @Tag("thorough")
    @Test
    fun `what walls give over what is dissipated is known as well as the energy is steady`() {
        val random = SeededRandom(32)
        fun energy(memory: Double): DoubleArray {
            val keep = Math.exp(-1 / memory)
            var e = random.nextGaussian()
            return DoubleArray(120) { e.also { e = keep * e + sqrt(1 - keep * keep) * random.nextGaussian() } + 50 }
        }
        val balances = List(REALISATIONS) { Transport(walled(energy(2.0)), 0.0).wallBalance!! }.filter { it.isLevelled }
        val covered = balances.count { Math.abs(it.mean - 1) <= it.error }.toDouble() / balances.size
        assertTrue(balances.size > 0.9 * REALISATIONS && covered in 0.60..0.75) { "$covered of ${balances.size}" }
        // Of what sloshes as slowly as the run is long the change is one of chance that is seen once.
        val slow = List(100) { Transport(walled(energy(60.0)), 0.0).wallBalance!! }
        assertTrue(slow.count { it.isLevelled } < 20 && slow.none { it.mean.isNaN() })
        assertNull(Transport(attracting(DoubleArray(20)), -3.0).wallBalance)
    }

    @Test
    fun `a gas that cools has no error, and neither has one of a few rows`() {
        val rows = (0..99).map { t ->
            "$t,$t,10,10,${Math.exp(-t / 30.0)},0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,${5 * t},${2.5 * t},${40.5 * t}," +
                "${8 * t},${8 * t},${8 * t},${6 * t},0,0,3"
        }
        val cooling = Transport(TransportTable.read(file(*rows.toTypedArray())), -3.0)
        assertFalse(cooling.temperature.isLevelled || cooling.pressure.isLevelled || cooling.compressibility.isLevelled)
        assertTrue(cooling.collisional.isLevelled)
        assertFalse(Transport(TransportTable.read(file(rows[0], rows[1], rows[2])), -3.0).collisional.isLevelled)
        assertTrue(Transport(TransportTable.read(file(*rows.toTypedArray())), 0.0).viscosity.mean.isNaN())
    }

    @Test
    fun `the orientation of an axis near a right angle has the error of a small angle`() {
        val random = SeededRandom(3)
        val rows = (0..60).map { t ->
            "$t,$t,10,10,0.2,0.5,0.2,${0.02 * random.nextGaussian()},0,0,0,0,0,0,1.5,0,0,0,0,0,0,0,0,0,0,0"
        }
        val orientation = Transport(TransportTable.read(file(*rows.toTypedArray())), -3.0).orientation
        assertEquals(PI / 2, Math.abs(orientation.mean), 0.05)
        assertEquals(0.02 / 0.3 / Math.sqrt(60.0), orientation.error, 0.004)
    }

    @Test
    fun `temperature is of the peculiar velocities, stresses are around the imposed flow, and an older file says so`() {
        val old = (0..3).map { t -> "$t,$t,10,10,0.5,0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,0,0,0,0,0,0,0,0,0,0" }
        val path = file(*old.toTypedArray())
        val before = Transport(TransportTable.read(path), -3.0)
        assertFalse(before.isPeculiar)
        assertEquals(0.6, before.kinetic("xy").mean, 1e-15)
        val more = ",kinetic_xx,kinetic_yy,kinetic_zz,kinetic_xy,kinetic_xz,kinetic_yz"
        Files.write(path, listOf(header + more) + old.map { "$it,0.8,0.4,0.25,0.9,0,0" })
        val transport = Transport(TransportTable.read(path), -3.0)
        assertTrue(transport.isPeculiar)
        assertEquals(1.0 / 3, transport.temperature.mean, 1e-12)
        assertEquals(1.0, transport.dispersion.mean, 1e-12)
        assertEquals(0.6, transport.moment("xy").mean, 1e-15)
        assertEquals(0.3, transport.translational.mean, 1e-12)
        assertEquals(0.8, transport.pressure("xx").mean, 1e-12)
    }

    @Test
    fun `a line cut short at the end is left out, elsewhere and other damage are named`() {
        val good = "0,0,10,10,0.5,0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,5,1,1,8,8,8,6,0,0,3"
        assertEquals(1, TransportTable.read(file(good, "1,1,10,10,0.5")).size)
        assertTrue(
            assertThrows(FormatException::class.java) {
                TransportTable.read(file("1,1,10", good))
            }.message!!.contains(":2: 3 values"),
        )
        assertTrue(
            assertThrows(FormatException::class.java) {
                TransportTable.read(file(good.replace("0.5", "half")))
            }.message!!.contains("c_xx is 'half'"),
        )
        assertThrows(FormatException::class.java) { TransportTable.read(directory.resolve("nowhere.csv")) }
        assertThrows(IllegalArgumentException::class.java) { Transport(TransportTable.read(file(good)), -1.0) }
    }

    @Test
    fun `the axis of parts that lie to either side of a right angle is the nearer one, not half a turn off`() {
        // The whole is a little to one side; without its first interval it is to the other.
        val rows = (0..40).map { t ->
            val xy = if (t == 1) 0.03 else -0.0005
            "$t,$t,10,10,0.2,0.5,0.2,$xy,0,0,0,0,0,0,1.5,0,0,0,0,0,0,0,0,0,0,0"
        }
        val orientation = Transport(TransportTable.read(file(*rows.toTypedArray())), -3.0).orientation
        assertEquals(PI / 2 - 0.5 * atan(2 * 0.0105 / 40 / 0.3), orientation.mean, 1e-12)
        // Of the angle ½ atan(2 xy / 0.3) from the right angle: a scatter of 0.0048 in xy, over √40.
        assertEquals(0.0048 / 0.3 / Math.sqrt(40.0), orientation.error, 0.0005)
    }

    @Test
    fun `the last row at least is from its own time on, and none is from later`() {
        val rows = (0..4).map { t -> "$t,${2 * t},10,10,0.5,0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,0,0,0,0,0,0,0,0,0,0" }
        val table = TransportTable.read(file(*rows.toTypedArray()))
        for ((time, size) in listOf(-1.0 to 5, 0.0 to 5, 3.0 to 3, 4.0 to 3, 8.0 to 1, 8.1 to 0)) {
            assertEquals(size, table.from(time).size) { "rows from $time on" }
        }
        assertThrows(IllegalArgumentException::class.java) { Transport(table.from(8.0), -3.0) }
        assertEquals(2.0, Transport(table.from(6.0), -3.0).duration)
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
