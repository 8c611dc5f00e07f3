package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ln

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
        assertThrows(IllegalArgumentException::class.java) { HardSphereMixture(doubleArrayOf(-0.1), one) }
        assertThrows(IllegalArgumentException::class.java) { HardDiscs.contactValue(0, 0, one, doubleArrayOf()) }
        assertThrows(IllegalArgumentException::class.java) { HardDiscs.contactValue(0, 0, one, doubleArrayOf(1.28)) }
    }

    @Test
    fun `points beside spheres or discs see the void that these leave`() {
        val diameters = doubleArrayOf(0.0, 1.0)
        val mixture = HardSphereMixture(diameters, doubleArrayOf(5.0, 1.2 / PI))
        for (i in 0..1) {
            assertEquals(1 / 0.8, mixture.contactValue(0, i), 1e-12)
            val disc = HardDiscs.contactValue(i, 0, diameters, doubleArrayOf(5.0, 0.8 / PI))
            assertEquals(1 / 0.8, disc, 1e-12)
        }
    }

    @Test
    fun `S(0) and contact values are those of the equation of state`() {
        fun check(z: (Double) -> Double, zero: (Double) -> Double, contact: (Double) -> Double, virial: Int) {
            for (phi in listOf(0.05, 0.3, 0.49)) {
                val h = 1e-4 * phi
                val slope = ((phi + h) * z(phi + h) - (phi - h) * z(phi - h)) / (2 * h)
                assertEquals(1.0, zero(phi) * slope, 1e-6) { "φ = $phi" }
                assertEquals(z(phi), 1 + virial * phi * contact(phi), 1e-12 * z(phi)) { "φ = $phi" }
            }
        }
        val spheres = HardSpheres
        val discs = HardDiscs
        check(
            spheres::carnahanStarling,
            spheres::carnahanStarlingLongWaveLimit,
            spheres::carnahanStarlingContact,
            virial = 4,
        )
        check(discs::henderson, discs::hendersonLongWaveLimit, discs::hendersonContact, virial = 2)
    }

    /** Half of the discs of each size, ν = 0.4, from the formula as the paper prints it. */
    @Test
    fun `a mixture of discs has the contact values of Jenkins and Mancini, and of one size those of Henderson`() {
        val diameters = doubleArrayOf(0.6, 1.0)
        // π/4 Σ n σ = 0.4 · 1.6/1.36, and 2 σ_i σ_j/(σ_i + σ_j) is 0.6 or 0.75.
        val densities = DoubleArray(2) { 0.4 / (PI / 4 * 1.36) }
        val known = DoubleArray(2) { 1 / 0.6 + 9.0 / 16 * (0.6 + 0.15 * it) * 0.4 * 1.6 / 1.36 / 0.36 }
        assertEquals(known[0], HardDiscs.contactValue(0, 0, diameters, densities), 1e-12)
        assertEquals(known[1], HardDiscs.contactValue(0, 1, diameters, densities), 1e-12)
        assertEquals(known[1], HardDiscs.contactValue(1, 0, diameters, densities), 1e-12)
        val same = HardDiscs.contactValue(0, 1, doubleArrayOf(2.0, 2.0), doubleArrayOf(0.1 / PI, 0.2 / PI))
        assertEquals(HardDiscs.hendersonContact(0.3), same, 1e-12)
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

    @Test
    fun `chemical potentials are the integrals of their equations of state, and of a point what is free`() {
        for ((filling, known) in listOf(0.1 to 0.97805, 0.2 to 2.46875, 0.3 to 4.87172)) {
            assertEquals(known, HardSpheres.carnahanStarlingChemicalPotential(filling), 5e-6)
            val one = HardSphereMixture(doubleArrayOf(1.0), doubleArrayOf(filling * 6 / PI))
            assertEquals(known, one.excessChemicalPotential(1.0), 5e-6)
            assertEquals(-ln(1 - filling), one.excessChemicalPotential(0.0), 1e-15)
        }
        // Of discs: φ dμ/dφ = d(φ Z)/dφ − 1.
        val h = 1e-5
        fun rise(of: (Double) -> Double) = (of(0.4 + h) - of(0.4 - h)) / (2 * h)
        val expected = rise { it * HardDiscs.henderson(it) } - 1
        assertEquals(expected, 0.4 * rise(HardDiscs::hendersonChemicalPotential), 1e-6)
        assertEquals(0.0, HardDiscs.hendersonChemicalPotential(0.0))
    }

    @Test
    fun `chemical potentials of a mixture are derivatives of one free energy, whose pressure is its own`() {
        val diameters = doubleArrayOf(1.0, 0.6)
        fun mixture(a: Double, b: Double) = HardSphereMixture(diameters, doubleArrayOf(a, b))
        val (a, b, h) = Triple(0.3, 0.5, 1e-5)
        // Of one free energy, so that ∂μ_a/∂n_b = ∂μ_b/∂n_a.
        val first = (mixture(a, b + h).excessChemicalPotential(1.0) - mixture(a, b - h).excessChemicalPotential(1.0))
        val second = (mixture(a + h, b).excessChemicalPotential(0.6) - mixture(a - h, b).excessChemicalPotential(0.6))
        assertEquals(first, second, 1e-9)
        // Gibbs and Duhem: Σ n dμ_ex = d(p − n kT).
        fun pressure(s: Double) = mixture(a * s, b * s).let { it.compressibility - 1 } * (a + b) * s
        fun sum(s: Double) = mixture(a * s, b * s).let {
            a * it.excessChemicalPotential(1.0) + b * it.excessChemicalPotential(0.6)
        }
        assertEquals(pressure(1 + h) - pressure(1 - h), sum(1 + h) - sum(1 - h), 1e-9)
        // A large one makes room against the pressure, which this equation has to 1 % only.
        val far = mixture(a, b).excessChemicalPotential(1e5) / (PI / 6 * 1e15)
        assertEquals(1.0, far / ((a + b) * mixture(a, b).compressibility), 0.01)
        assertThrows(IllegalArgumentException::class.java) { mixture(a, b).excessChemicalPotential(-1.0) }
    }

    @Test
    fun `stresses of a dilute shear flow are those of Grad, and add up`() {
        for ((alpha, known) in listOf(
            0.8 to listOf(0.84848, 1.30303, 0.43913),
            0.9 to listOf(0.92063, 1.15873, 0.33106),
        )) {
            val shear = DiluteShear(alpha)
            assertEquals(known[0], shear.acrossFlow, 5e-6)
            assertEquals(known[1], shear.alongFlow, 5e-6)
            assertEquals(known[2], shear.shearStress, 5e-6)
            assertEquals(3.0, shear.alongFlow + 2 * shear.acrossFlow, 1e-15)
            assertEquals(2.0, DiluteShear(alpha, 2).let { it.alongFlow + it.acrossFlow }, 1e-15)
        }
        assertEquals(0.0, DiluteShear(1.0).shearStress)
        assertThrows(IllegalArgumentException::class.java) { DiluteShear(1.1) }
        assertThrows(IllegalArgumentException::class.java) { DiluteShear(0.9, 4) }
    }
}
