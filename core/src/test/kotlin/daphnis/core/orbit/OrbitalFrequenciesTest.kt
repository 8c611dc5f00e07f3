package daphnis.core.orbit

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class OrbitalFrequenciesTest {
    /** Saturn: Jacobson and others 2006 (AJ 132, 2520), radius 60,330 km. */
    private fun saturn(km: Double, j2: Double = J2, j4: Double = J4, j6: Double = J6) =
        OrbitalFrequencies.around(GM, km * 1e3, 60_330e3, j2, j4, j6)

    /** Of the apse, in degrees a day. */
    private fun precession(f: OrbitalFrequencies) = Math.toDegrees((f.omega - f.kappa) * 86_400)

    @Test
    fun `apses of the F ring and of Prometheus advance as they are seen to`() {
        assertEquals(2.698, precession(saturn(140_224.0)), 0.002)
        assertEquals(2.757, precession(saturn(139_380.0)), 0.002)
    }

    /** Independently of the series: the derivatives of the potential, by differences, in the plane and off it. */
    @Test
    fun `frequencies are those of the potential`() {
        val radius = 60_330e3
        fun potential(distance: Double, z: Double): Double {
            val r = sqrt(distance * distance + z * z)
            val u = z / r
            val s = (radius / r) * (radius / r)
            val p2 = (3 * u * u - 1) / 2
            val p4 = (35 * u * u * u * u - 30 * u * u + 3) / 8
            val p6 = (231 * Math.pow(u, 6.0) - 315 * Math.pow(u, 4.0) + 105 * u * u - 5) / 16
            return -GM / r * (1 - J2 * s * p2 - J4 * s * s * p4 - J6 * s * s * s * p6)
        }
        for (km in listOf(67_000.0, 92_000.0, 140_000.0)) {
            val a = km * 1e3
            val d = a * 1e-4
            fun force(at: Double) = (potential(at + d, 0.0) - potential(at - d, 0.0)) / (2 * d)
            val omega2 = force(a) / a
            val kappa2 = 3 * omega2 + (force(a + d) - force(a - d)) / (2 * d)
            val nu2 = (potential(a, d) - 2 * potential(a, 0.0) + potential(a, -d)) / (d * d)
            val f = saturn(km)
            assertEquals(sqrt(omega2), f.omega, 1e-7 * f.omega)
            assertEquals(sqrt(kappa2), f.kappa, 1e-6 * f.kappa)
            assertEquals(sqrt(nu2), f.nu, 1e-6 * f.nu)
        }
    }

    @Test
    fun `a point mass has one frequency, to the bit, and the shear of Kepler`() {
        val f = saturn(100_000.0, 0.0, 0.0, 0.0)
        assertEquals(sqrt(GM / (1e8 * 1e8 * 1e8)), f.omega)
        assertEquals(1.0, f.radialFactor)
        assertEquals(1.0, f.verticalFactor)
        assertEquals(1.5 * f.omega, f.shearRate)
    }

    @Test
    fun `what is no stable orbit is refused`() {
        for (wrong in listOf<() -> Unit>(
            { OrbitalFrequencies(0.0) },
            { OrbitalFrequencies(1.0, 0.0) },
            { OrbitalFrequencies(1.0, 2.0) },
            { OrbitalFrequencies(1.0, Double.NaN) },
            { OrbitalFrequencies(1.0, 1.0, -0.1) },
            { OrbitalFrequencies(1.0, 1.0, Double.POSITIVE_INFINITY) },
            { OrbitalFrequencies.around(0.0, 1.0) },
            { OrbitalFrequencies.around(1.0, 1.0, -1.0) },
            { OrbitalFrequencies.around(1.0, 1.0, 1.0, j2 = 0.7) },
            { OrbitalFrequencies.around(1.0, 1.0, 1.0, j2 = Double.NaN) },
        )) {
            val message = assertThrows(IllegalArgumentException::class.java) { wrong() }.message!!
            assertTrue('\n' !in message) { message }
        }
    }

    private companion object {
        const val GM = 3.7931206e16
        const val J2 = 16290.71e-6
        const val J4 = -935.83e-6
        const val J6 = 86.14e-6
    }
}
