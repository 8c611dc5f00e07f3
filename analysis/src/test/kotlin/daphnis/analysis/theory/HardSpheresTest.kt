package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs

class HardSpheresTest {
    /** Measured by others in the limit of many spheres, nσ³ = 0.1, 0.2 … 0.9. */
    private val measured =
        doubleArrayOf(1.239724, 1.55361, 1.96824, 2.52164, 3.26936, 4.2949, 5.7268, 7.7699, 10.7629)

    private fun filling(k: Int) = HardSpheres.filling(0.1 * (k + 1), 1.0)

    @Test
    fun `the fluid has the measured pressure within what is said of each formula`() {
        fun worst(z: (Double) -> Double) = measured.indices.maxOf { abs(z(filling(it)) / measured[it] - 1) }
        assertTrue(worst(HardSpheres::kolafaLabikMalijevsky) < HardSpheres.KOLAFA_LABIK_MALIJEVSKY_ACCURACY)
        assertTrue(worst(HardSpheres::kolafa) in 2e-4..HardSpheres.KOLAFA_ACCURACY)
        assertTrue(worst(HardSpheres::carnahanStarling) in 2e-3..HardSpheres.CARNAHAN_STARLING_ACCURACY)
        val freezing = HardSpheres.kolafaLabikMalijevsky(HardSpheres.FREEZING)
        assertEquals(freezing, HardSpheres.kolafa(HardSpheres.FREEZING), HardSpheres.KOLAFA_ACCURACY * freezing)
    }

    @Test
    fun `few spheres have the second virial coefficient of their pairs, and another curvature of the pressure`() {
        assertEquals(1 + 4e-6 * 0.9, HardSpheres.kolafaLabikMalijevsky(1e-6, 10), 1e-10)
        val (phi, h) = 0.3 to 1e-4
        val at = { p: Double -> HardSpheres.kolafaLabikMalijevsky(p) }
        val first = phi * (at(phi + h) - at(phi - h)) / (2 * h)
        val second = phi * phi * (at(phi + h) - 2 * at(phi) + at(phi - h)) / (h * h)
        val expected = at(phi) - (2 * first + second) / (at(phi) + first) / 1000
        assertEquals(expected, HardSpheres.kolafaLabikMalijevsky(phi, 500), 1e-7)
    }

    @Test
    fun `the crystal has its published pressure, and freezes where both are equal`() {
        assertEquals(11.148, HardSpheres.speedy(0.5433), 5e-4)
        // Coexistence at pσ³/kT = 11.5727 (Fernandez et al. 2012, Phys. Rev. Lett. 108, 165701).
        fun pressure(z: Double, filling: Double) = z * filling * 6 / PI
        assertEquals(11.573, pressure(HardSpheres.kolafaLabikMalijevsky(0.4917), 0.4917), 0.05)
        assertEquals(11.573, pressure(HardSpheres.speedy(0.5433), 0.5433), 0.05)
    }

    @Test
    fun `a mixture has the pressure of its contact values, and that of one size if sizes are equal`() {
        val diameters = doubleArrayOf(1.0, 0.6, 0.3)
        val densities = doubleArrayOf(0.3, 0.5, 2.0)
        val mixture = HardSphereMixture(diameters, densities)
        var z = 1.0
        for (i in 0..2) {
            for (j in 0..2) {
                val s = (diameters[i] + diameters[j]) / 2
                z += 2 * PI / 3 * densities[i] * densities[j] / 2.8 * s * s * s * mixture.contactValue(i, j)
            }
        }
        assertEquals(z, mixture.compressibility, 1e-12)
        assertEquals(PI / 6 * (0.3 + 0.5 * 0.216 + 2 * 0.027), mixture.filling, 1e-14)
        val same = HardSphereMixture(doubleArrayOf(1.0, 1.0), doubleArrayOf(0.2, 0.4))
        assertEquals(HardSpheres.carnahanStarling(PI / 10), same.compressibility, 1e-12)
        assertEquals(HardSpheres.carnahanStarlingContact(PI / 10), same.contactValue(0, 1), 1e-12)
    }

    @Test
    fun `a mixture that cannot be is refused`() {
        val one = doubleArrayOf(1.0)
        for (bad in listOf(doubleArrayOf(), doubleArrayOf(0.0), doubleArrayOf(2.0), doubleArrayOf(Double.NaN))) {
            assertThrows(IllegalArgumentException::class.java) { HardSphereMixture(one, bad) }
        }
        assertThrows(IllegalArgumentException::class.java) { HardSphereMixture(doubleArrayOf(0.0), one) }
    }

    /** The virial coefficients are those of Clisby & McCoy 2006, J. Stat. Phys. 122, 15. */
    @Test
    fun `discs have the pressure of their virial series`() {
        val series = doubleArrayOf(
            1.0, 2.0, 3.12801775, 4.25785446, 5.33689664, 6.3630259, 7.351863, 8.319099, 9.272159, 10.2163,
        )
        fun sum(filling: Double) = series.foldRight(0.0) { b, z -> z * filling + b }
        assertEquals(sum(0.3), HardDiscs.luding(0.3), 1e-4 * sum(0.3))
        assertEquals(sum(0.3), HardDiscs.henderson(0.3), 4e-4 * sum(0.3))
        assertEquals(1.96322, HardDiscs.henderson(0.2827433), 1e-5)
        // Beyond the tenth coefficient they go on growing by 0.94 each.
        var (z, power, b) = Triple(sum(0.5), 1.0, 10.2163)
        repeat(9) { power *= 0.5 }
        repeat(60) {
            power *= 0.5
            b += 0.94
            z += b * power
        }
        assertEquals(z, HardDiscs.luding(0.5), 2e-3 * z)
        assertEquals(5e-3, HardDiscs.henderson(0.5) / z - 1, 1e-3)
    }
}
