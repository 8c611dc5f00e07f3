package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sin
import kotlin.math.sqrt

class VelocitySpectraTest {
    private val box = Periodic(Box.centred(6.0, 6.0, 6.0))

    @Test
    fun `without correlation both are 1, and density has the structure factor`() {
        val spectra = VelocitySpectra(6.0, 6)
        val sum = DoubleArray(18)
        repeat(60) { k ->
            val state = uniform(100, box, k + 1L) { it.nextGaussian() }
            val found = spectra.of(state)
            for (n in 0 until 18) sum[n] += found[n] / 60
            assertArrayEquals(SpatialStructureFactor(6.0, 6).of(state), found.copyOfRange(12, 18), 1e-9)
        }
        for (n in listOf(2, 3, 4, 5, 8, 9, 10, 11)) assertEquals(1.0, sum[n], 0.06) { "$n: ${sum[n]}" }
        assertTrue(sum[0].isNaN())
    }

    @Test
    fun `a shear wave is seen across its wave vector, a sound wave along it, and a common drift nowhere`() {
        for (isShear in listOf(true, false)) {
            val base = uniform(3000, box).population
            val wave = DoubleArray(3000) { 5 + sin(2 * PI / 6 * base.x[it]) }
            val still = DoubleArray(3000) { 5.0 }
            val p = Population(
                base.x,
                base.y,
                base.z,
                if (isShear) still else wave,
                if (isShear) wave else still,
                still.copyOf(),
                base.radius,
                base.mass,
            )
            val found = VelocitySpectra(1.2, 1).of(State(p, box, 0.0))
            // |j|² = (N/2)² for one of three wave vectors, over N τ = N/6, half of it for each of two directions across.
            val expected = 3000.0 / 2 / 2 * 6 / 2 / 3 * 2
            assertEquals(expected / (if (isShear) 2 else 1), found[if (isShear) 0 else 1], 0.1 * expected)
            assertTrue(found[if (isShear) 1 else 0] < 0.02 * expected)
        }
    }

    @Test
    fun `particles at rest and single ones have none, and there is a bin`() {
        val spectra = VelocitySpectra(3.0, 2)
        assertTrue(spectra.of(uniform(10, box)).all { it.isNaN() })
        assertTrue(spectra.of(uniform(1, box) { it.nextGaussian() }).all { it.isNaN() })
        // Three waves of π/3 and six of √2 π/3.
        assertEquals(PI / 3 * (3 + 6 * sqrt(2.0)) / 9, spectra.waveNumbers(uniform(10, box))[0], 1e-12)
        assertEquals(listOf(0.25), VelocitySpectra(0.5, 1).waveNumbers(uniform(10, box)).asList())
        assertThrows(IllegalArgumentException::class.java) { VelocitySpectra(-1.0, 2) }
    }
}
