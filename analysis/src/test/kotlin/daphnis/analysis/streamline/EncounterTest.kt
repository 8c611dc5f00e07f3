package daphnis.analysis.streamline

import daphnis.core.hill.Epicycle
import daphnis.core.orbit.OrbitalFrequencies
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cosh
import kotlin.math.exp
import kotlin.math.sqrt

class EncounterTest {
    @Test
    fun `an encounter has the wavelength, amplitude and crossing of Pan at the Encke gap`() {
        val pan = Encounter(162.0, 8.71e-12, 133_584.0)
        assertEquals(1527.0, pan.wavelength, 0.5)
        assertEquals(1.772, pan.amplitude, 0.002)
        assertEquals(1.5 * 162 * 162 / pan.amplitude, pan.crossing(pan.amplitude), 1e-9)
        assertEquals(2 * PI * 133_584 / pan.wavelength, pan.synodicOrbits, 1e-12)
        val resonances = pan.resonances(160.0, 170.0)
        assertTrue(resonances.size in 25..40)
        for (r in resonances) assertEquals(Math.pow((r.m + 1.0) / r.m, 2.0 / 3) - 1, r.offset / 133_584, 1e-12)
    }

    @Test
    fun `the integrated impulse of a moon on a circle is that of Julian and Toomre, on either side`() {
        for (distance in listOf(162.0, -30.0)) {
            val circle = Encounter(distance, 1e-12, 1e5)
            for (phase in listOf(0.0, 2.0)) {
                assertEquals(
                    circle.amplitude,
                    circle.amplitudeAt(phase),
                    3e-4 * circle.amplitude,
                )
            }
            assertEquals(circle.largestAmplitude, circle.leastAmplitude, 1e-9 * circle.amplitude)
        }
    }

    @Tag("thorough")
    @Test
    fun `a moon on an epicycle leaves what a particle integrated through its passage has`() {
        for (distance in listOf(1.0, -1.0)) {
            for (moonE in listOf(0.1, 0.4)) {
                val encounter = Encounter(distance, 1e-6, 1.0, moonE)
                for (phase in listOf(0.3, 1.7, 3.3, 5.0)) {
                    assertEquals(
                        integrated(distance, moonE, phase, 1e-6),
                        encounter.amplitudeAt(phase),
                        0.004 * encounter.amplitude,
                    ) { "$distance, $moonE, $phase" }
                }
                // Not the circle's by far: what the row of the report would be wrong by.
                assertTrue(
                    encounter.largestAmplitude > (1 + moonE) * encounter.amplitude &&
                        encounter.leastAmplitude < encounter.amplitude,
                )
            }
        }
    }

    /**
     * Amplitude of a particle from a circular orbit at [distance], after a moon of GM = [strength] has passed; Ω = 1.
     * Runge and Kutta.
     */
    private fun integrated(distance: Double, moonE: Double, phase: Double, strength: Double): Double {
        val way = 100.0
        val dt = 0.005
        var s = doubleArrayOf(distance, 1.5 * distance * way, 0.0, -1.5 * distance)
        fun rate(t: Double, q: DoubleArray): DoubleArray {
            val moon = Epicycle(0.0, 0.0, moonE, phase + t).state(1.0)
            val dx = q[0] - moon[0]
            val dy = q[1] - moon[1]
            val r3 = (dx * dx + dy * dy) * sqrt(dx * dx + dy * dy)
            return doubleArrayOf(q[2], q[3], 2 * q[3] + 3 * q[0] - strength * dx / r3, -2 * q[2] - strength * dy / r3)
        }
        fun plus(a: DoubleArray, b: DoubleArray, f: Double) = DoubleArray(4) { a[it] + f * b[it] }
        for (k in 0 until (2 * way / dt).toInt()) {
            val t = -way + k * dt
            val k1 = rate(t, s)
            val k2 = rate(t + dt / 2, plus(s, k1, dt / 2))
            val k3 = rate(t + dt / 2, plus(s, k2, dt / 2))
            val k4 = rate(t + dt, plus(s, k3, dt))
            s = DoubleArray(4) { s[it] + dt / 6 * (k1[it] + 2 * k2[it] + 2 * k3[it] + k4[it]) }
        }
        return Epicycle.of(s[0], s[1], 0.0, s[2], s[3], 0.0, 1.0).e
    }

    @Test
    fun `a moon whose epicycle reaches the ring has no small impulse`() {
        val deep = Encounter(10.0, 1e-9, 1e5, 10.0)
        assertTrue(deep.amplitudeAt(0.0).isNaN() && deep.largestAmplitude.isNaN() && deep.leastAmplitude.isNaN())
        assertThrows(IllegalArgumentException::class.java) { Encounter(10.0, 1e-9, 1e5, -1.0) }
        assertThrows(IllegalArgumentException::class.java) { Encounter(0.0, 1e-9, 1e5) }
    }

    /** Exact for a circle: with s the shear and p = κ/s, the impulse is (2p/κs) ((2/κ) K₀(p) + K₁(p)). */
    @Test
    fun `around an oblate planet the impulse is that of its κ and shear`() {
        fun bessel(order: Int, x: Double) = (0 until 12_000).sumOf { k ->
            val t = (k + 0.5) * 1e-3
            1e-3 * exp(-x * cosh(t)) * cosh(order * t)
        }
        for (kappa in listOf(0.9, 1.0, 1.1)) {
            val encounter = Encounter(10.0, 1e-9, 1e5, frequencies = OrbitalFrequencies(3.0, kappa))
            val shear = (4 - kappa * kappa) / 2
            val p = kappa / shear
            val expected = 1e4 * 2 * p / (kappa * shear) * (2 / kappa * bessel(0, p) + bessel(1, p))
            assertEquals(expected, encounter.amplitude, 5e-4 * expected)
            assertEquals(2 * PI * shear / kappa * 10, encounter.wavelength, 1e-12)
            assertEquals(1e5 / (shear * 10), encounter.synodicOrbits, 1e-9)
            assertEquals(shear / kappa * 100 / 0.5, encounter.crossing(0.5), 1e-12)
        }
        assertFalse(Encounter(10.0, 1e-9, 1e5, frequencies = OrbitalFrequencies(3.0, 0.9)).isKeplerian)
    }

    /** Saturn with J2 alone, Pan, and the rings beside the Encke gap: the roots of m (Ω_s − Ω) = ±κ by bisection. */
    @Test
    fun `resonances are those with κ around an oblate planet`() {
        val moon = 133_584.0
        fun at(a: Double) = OrbitalFrequencies.around(3.7931206e7, a, 60_330.0, 0.01629071)
        for (side in listOf(1, -1)) {
            val middle = moon + side * 162.0
            val encounter = Encounter(side * 162.0, 8.71e-12, moon, frequencies = at(middle))
            val found = encounter.resonances(side * 150.0, side * 175.0)
            assertTrue(found.isNotEmpty())
            for (resonance in found) {
                val m = if (side > 0) resonance.m else resonance.m + 1

                // Positive nearer than the resonance.
                fun excess(offset: Double) =
                    at(moon + side * offset).let { it.kappa - m * side * (at(moon).omega - it.omega) }
                var near = 100.0
                var far = 300.0
                repeat(60) { ((near + far) / 2).let { if (excess(it) > 0) near = it else far = it } }
                assertEquals(side * near, resonance.offset, 2e-5 * near) { "$side $m" }
                val kepler = moon * (Math.pow((resonance.m + 1.0) / resonance.m, side * 2.0 / 3) - 1)
                assertTrue(abs(kepler - side * near) > 5e-3 * near)
            }
        }
    }
}
