package daphnis.analysis.transport

import daphnis.core.format.FormatException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class TransportTest {
    @TempDir
    lateinit var directory: Path

    private val header = "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,mean_vx,mean_vy,mean_vz,centre_z,scale_height,guiding_x," +
        "collisions,sum_impact_speed,dissipated,virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy"

    private fun file(vararg rows: String): Path = directory.resolve("transport.csv").also { Files.write(it, listOf(header) + rows) }

    @Test
    fun `viscosities, rates and the energy balance of made rows`() {
        // Ω = 2, γ = −3: 10 spheres of mass 1, 5 collisions a unit of time with impact speed 0.5, virial_xy 6 and dissipation 4.05 a unit of time.
        val rows = (0..9).map { t -> "$t,$t,10,10,0.5,0.3,0.2,0.6,0,0,0,0,0,0,1.5,0,${5 * t},${2.5 * t},${40.5 * t},${8 * t},${8 * t},${8 * t},${6 * t},0,0,3" }
        val transport = Transport(TransportTable.read(file(*rows.toTypedArray())).from(2.0), -3.0)
        assertEquals(7.0, transport.duration)
        assertEquals(1.0, transport.dispersion.mean, 1e-12)
        assertEquals(1.0 / 3, transport.temperature.mean, 1e-12)
        assertEquals(1.0, transport.collisionRate.mean, 1e-12)
        assertEquals(0.5, transport.impactSpeed, 1e-12)
        assertEquals(0.2, transport.translational.mean, 1e-12)
        assertEquals(0.2, transport.collisional.mean, 1e-12)
        assertEquals(0.1, transport.gravitational.mean, 1e-12)
        assertEquals(4.05, transport.dissipation.mean, 1e-12)
        assertEquals(9 * 0.5 / 4.05, transport.energyBalance, 1e-12)
        assertEquals(0.5 + 0.8, transport.pressure("xx").mean, 1e-12)
        assertEquals(1.5, transport.scaleHeight.mean, 1e-12)
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
        assertTrue(assertThrows(FormatException::class.java) { TransportTable.read(file("1,1,10", good)) }.message!!.contains(":2: 3 values"))
        assertTrue(assertThrows(FormatException::class.java) { TransportTable.read(file(good.replace("0.5", "half"))) }.message!!.contains("c_xx is 'half'"))
        assertThrows(FormatException::class.java) { TransportTable.read(directory.resolve("nowhere.csv")) }
        assertThrows(IllegalArgumentException::class.java) { Transport(TransportTable.read(file(good)), -1.0) }
    }
}
