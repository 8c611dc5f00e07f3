package daphnis.analysis.transport

import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.pow
import kotlin.math.sin
import kotlin.math.sqrt

class PerturbedTransportTest {
    @TempDir
    lateinit var directory: Path

    private val header =
        "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,mean_vx,mean_vy,mean_vz," +
            "centre_z,scale_height,guiding_x,collisions,sum_impact_speed,dissipated," +
            "virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy," +
            "kinetic_xx,kinetic_yy,kinetic_zz,kinetic_xy,kinetic_xz,kinetic_yz"

    private val omega = 2.0
    private val period = 2 * PI / omega
    private val nu = 0.3
    private val mass = 10.0

    private fun sheet(q: Double) = HillSheet(Box.centred(8.0, 5.0, 4.0), omega, perturbation = q)

    private fun spread(q: Double, t: Double) = q * omega * sin(omega * t) / (1 - q * cos(omega * t))

    private fun rate(q: Double, t: Double) = omega * (2 * q * cos(omega * t) - 1.5) / (1 - q * cos(omega * t))

    /**
     * A fluid with the kinematic viscosity ν, of which particles carry one part and collisions two, and that dissipates
     * what the viscosity takes; [rows] in a period.
     */
    private fun fluid(q: Double, rows: Int, periods: Double): TransportTable {
        val h = period / rows
        var xx = 0.0
        var xy = 0.0
        var lost = 0.0
        val lines = (0..(rows * periods).toInt()).map { k ->
            val t = k * h
            val line = "$k,$t,10,$mass,0,0,0,0,0,0,0,0,0,0,1,0,0,0,$lost,$xx,0,0,$xy,0,0,0," +
                "${-nu * spread(q, t) / 3},1,1,${-nu * rate(q, t) / 3},0,0"
            // In fine steps to the next row.
            for (i in 0 until FINE) {
                val s = t + (i + 0.5) / FINE * h
                xx += -nu * spread(q, s) * 2 / 3 * mass * h / FINE
                xy += -nu * rate(q, s) * 2 / 3 * mass * h / FINE
                lost += nu * (spread(q, s).pow(2) + rate(q, s).pow(2)) * mass * h / FINE
            }
            line
        }
        val path = directory.resolve("transport.csv")
        Files.write(path, listOf(header) + lines)
        return TransportTable.read(path)
    }

    @Test
    fun `the flux of a viscous fluid is that of Hahn et al, and reverses at half the root of 3`() {
        for (q in listOf(0.1, 0.5, sqrt(3.0) / 2, 0.9)) {
            // From no round phase on, and with a part of a period at the end.
            val table = fluid(q, 400, 20.6).from(0.3 * period)
            val found = PerturbedTransport(table, sheet(q), period)
            assertEquals(20, found.periods)
            val expected = nu * omega * (1.5 - 2 * q * q) / (1 - q * q).pow(1.5)
            val scale = nu * omega / (1 - q * q).pow(1.5)
            assertEquals(expected, found.angularMomentumFlux.mean, 2e-3 * scale) { "q = $q" }
            assertEquals(expected / 3, found.translationalFlux.mean, 2e-3 * scale) { "q = $q" }
            assertEquals(1.0, found.energyBalance.mean, 2e-3) { "q = $q" }
        }
    }

    @Test
    fun `by phase density goes from 1 over 1 - q to 1 over 1 + q, and fluxes are those of the time`() {
        val q = 0.5
        val found = PerturbedTransport(fluid(q, 400, 8.0), sheet(q), period)
        val (phase, density, squares, flux) = found.byPhase(100)
        assertEquals(3.0, density.max() / density.min(), 0.01)
        assertEquals(0.005, phase[0], 1e-12)
        assertTrue(squares.all { it in 1.5..2.5 })
        for (k in phase.indices) {
            val t = phase[k] * period
            assertEquals(-nu * rate(q, t) / (1 - q * cos(omega * t)), flux[k], 0.02)
        }
    }

    @Test
    fun `a sheet that stays as it is and a single row are refused`() {
        val table = fluid(0.5, 10, 2.0)
        assertThrows(IllegalArgumentException::class.java) { PerturbedTransport(table, sheet(0.0), period) }
        assertThrows(IllegalArgumentException::class.java) {
            PerturbedTransport(table.from(2 * period - 1e-9), sheet(0.5), period)
        }
        assertEquals(0, PerturbedTransport(table.until(0.5 * period), sheet(0.5), period).periods)
    }

    private companion object {
        const val FINE = 20
    }
}
