package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.pow
import kotlin.math.sqrt

class CoolingGasTest {
    /** Over those of the dilute elastic gas: ζ, bulk and shear viscosity, both conductivities; computed apart. */
    private fun assertCoefficients(restitution: Double, filling: Double, expected: List<Double>) {
        val first = 5.0 / 16 / sqrt(PI)
        val density = 6 * filling / PI
        val found = listOf(
            CoolingGas.coolingRate(1.0, restitution, filling, 1.0) * first / density,
            CoolingGas.bulkViscosity(1.0, 1.0, restitution, filling, 1.0) / first,
            CoolingGas.viscosity(1.0, 1.0, restitution, filling, 1.0) / first,
            CoolingGas.conductivity(1.0, 1.0, restitution, filling, 1.0) / first / 3.75,
            CoolingGas.densityConductivity(1.0, 1.0, restitution, filling, 1.0) / first / 3.75 * density,
        )
        for (k in expected.indices) assertEquals(expected[k], found[k], 1.5e-6) { "$k at $restitution, $filling" }
    }

    /** From the equations as the paper prints them, in another arrangement than that of the code. */
    @Test
    fun `coefficients are those of Garzó and Dufty`() {
        assertCoefficients(0.9, 1e-9, listOf(0.078951, 0.0, 1.043320, 1.068491, 0.115695))
        assertCoefficients(0.8, 0.2, listOf(0.263050, 1.032135, 1.886856, 2.077834, 0.436532))
        assertCoefficients(0.7, 0.4, listOf(0.787230, 8.208424, 6.894825, 6.280098, 1.509636))
    }

    @Test
    fun `elastic spheres are those of Enskog in first approximation, and do not cool`() {
        val (sigma, m, kT) = Triple(2.0, 3.0, 5.0)
        for (phi in listOf(0.01, 0.3)) {
            assertEquals(0.0, CoolingGas.coolingRate(sigma, 1.0, phi, kT / m))
            assertEquals(0.0, CoolingGas.densityConductivity(sigma, m, 1.0, phi, kT), 1e-14)
            val bulk = EnskogGas.bulkViscosity(sigma, m, phi, kT)
            assertEquals(1.0, CoolingGas.bulkViscosity(sigma, m, 1.0, phi, kT) / bulk, 1e-12)
            val shear = EnskogGas.viscosity(sigma, m, phi, kT)
            assertEquals(1.0, CoolingGas.viscosity(sigma, m, 1.0, phi, kT) / shear, 0.017)
            val heat = EnskogGas.conductivity(sigma, m, phi, kT)
            assertEquals(1.0, CoolingGas.conductivity(sigma, m, 1.0, phi, kT) / heat, 0.026)
        }
    }

    @Test
    fun `the cooling rate of all impacts is that of a heated gas in balance, with its own a2`() {
        assertEquals(-0.0125772, CoolingGas.fourthCumulant(0.8), 1e-7)
        val n = 0.3
        val phi = HardSpheres.filling(n, 1.0)
        val t = HeatedGas.temperature(0.2, 0.0, 0.8, n, 1.0)
        val rate = CoolingGas.coolingRate(1.0, 0.8, phi, t)
        val cumulants = (1 + 3.0 / 16 * HeatedGas.fourthCumulant(0.8)) / (1 + 3.0 / 16 * CoolingGas.fourthCumulant(0.8))
        assertEquals(0.2 / t, rate * cumulants, 1e-12)
        assertEquals(2.0.pow(-2), CoolingGas.temperature(1.0, 0.5, 4.0), 1e-15)
    }
}
