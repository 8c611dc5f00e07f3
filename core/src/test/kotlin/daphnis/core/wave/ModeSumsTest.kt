package daphnis.core.wave

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.wave.ModeQuantity.DENSITY
import daphnis.core.wave.ModeQuantity.TEMPERATURE
import daphnis.core.wave.ModeQuantity.VELOCITY_X
import daphnis.core.wave.ModeQuantity.VELOCITY_Y
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

class ModeSumsTest {
    private val length = 50.0
    private val sheet = HillSheet(Box.centred(length, 5.0, 20.0), 0.7)
    private val k = 2 * PI / length

    /** Spheres at equal distances along x, all functions of the place. */
    private fun made(
        count: Int,
        mass: (Double) -> Double = { 1.0 },
        vx: (Int, Double) -> Double = { _, _ -> 0.0 },
        vy: (Int, Double) -> Double = { _, _ -> 0.0 },
        vz: (Int, Double) -> Double = { _, _ -> 0.0 },
        each: Int = 1,
    ): Population {
        val x = DoubleArray(count * each) { -length / 2 + length * (it / each + 0.5) / count }
        val zero = DoubleArray(x.size)
        return Population(
            x,
            zero.copyOf(),
            zero.copyOf(),
            DoubleArray(x.size) { vx(it, x[it]) },
            DoubleArray(x.size) { vy(it, x[it]) - 1.5 * 0.7 * x[it] },
            DoubleArray(x.size) { vz(it, x[it]) },
            DoubleArray(x.size) { 0.1 },
            DoubleArray(x.size) { mass(x[it]) },
        )
    }

    private fun ModeSums.of(p: Population) = apply { take(p) }

    private fun ModeSums.all() = ModeQuantity.entries.flatMap { q ->
        (0..modes).flatMap { listOf(real(q, it), imaginary(q, it)) }
    }

    private fun assertMode(
        re: Double,
        im: Double,
        sums: ModeSums,
        quantity: ModeQuantity,
        m: Int,
        error: Double = 1e-12,
    ) {
        assertEquals(re, sums.real(quantity, m), error) { "real part of $quantity $m" }
        assertEquals(im, sums.imaginary(quantity, m), error) { "imaginary part of $quantity $m" }
    }

    @Test
    fun `a wave has its amplitude and phase, against the shear and the mean, and leaves no temperature`() {
        val p = made(400, vx = { _, x -> 3 + 2 * cos(2 * k * x - 0.4) }, vy = { _, x -> -1 + 0.5 * sin(3 * k * x) })
        val sums = ModeSums(4, sheet).of(p)
        assertMode(3.0, 0.0, sums, VELOCITY_X, 0)
        assertMode(2 * cos(0.4), -2 * sin(0.4), sums, VELOCITY_X, 2)
        assertMode(-1.0, 0.0, sums, VELOCITY_Y, 0)
        assertMode(0.0, -0.5, sums, VELOCITY_Y, 3)
        for (m in listOf(1, 3, 4)) assertMode(0.0, 0.0, sums, VELOCITY_X, m)
        assertMode(1.0, 0.0, sums, DENSITY, 0)
        for (m in 1..4) assertMode(0.0, 0.0, sums, DENSITY, m)
        for (m in 0..4) assertMode(0.0, 0.0, sums, TEMPERATURE, m, 1e-20)
        assertEquals(2 * k, sums.wavenumber(2), 1e-15)
    }

    @Test
    fun `where the density varies, the field still takes out the whole wave`() {
        val p = made(400, { 1 + 0.6 * cos(k * it + 0.3) }, { _, x -> 2 * sin(k * x) + cos(4 * k * x) })
        val sums = ModeSums(4, sheet).of(p)
        assertMode(0.6 * cos(0.3), 0.6 * sin(0.3), sums, DENSITY, 1)
        // ⟨(1 + 0.6 cos(kx + 0.3)) 2 sin kx⟩ = −0.6 sin 0.3.
        assertMode(-0.6 * sin(0.3), 0.0, sums, VELOCITY_X, 0)
        assertEquals(0.0, sums.real(TEMPERATURE, 0), 1e-20)
        // A wave that the modes cannot follow is temperature.
        val few = ModeSums(3, sheet).of(p)
        assertTrue(few.real(TEMPERATURE, 0) > 0.1) { "${few.real(TEMPERATURE, 0)}" }
    }

    @Test
    fun `the temperature is that around the wave, with its own modes, and without bias`() {
        val sign = { it: Int -> if (it % 2 == 0) 1.0 else -1.0 }
        val thermal = { it: Int, x: Double -> sign(it) * sqrt(4 + cos(2 * k * x) - 2 * sin(k * x)) }
        val n = 200
        val p =
            made(n / 2, vx = { i, x -> thermal(i, x) + 7 * cos(k * x) }, vz = { i, x -> 5 + thermal(i, x) }, each = 2)
        val sums = ModeSums(2, sheet).of(p)
        val factor = (n / (n - 5.0) + n / (n - 1.0)) / 3
        assertMode(4 * factor, 0.0, sums, TEMPERATURE, 0)
        assertMode(0.0, 2 * factor, sums, TEMPERATURE, 1)
        assertMode(factor, 0.0, sums, TEMPERATURE, 2)
    }

    @Test
    fun `the mean temperature of few spheres is that of the distribution they are drawn from`() {
        val random = SeededRandom(5)
        val found = DoubleArray(400) {
            fun gauss(i: Int, x: Double) = 2 * random.nextGaussian() + 0 * i * x
            ModeSums(8, sheet).of(made(40, vx = ::gauss, vy = ::gauss, vz = ::gauss)).real(TEMPERATURE, 0)
        }
        val mean = found.average()
        val error = sqrt(found.sumOf { (it - mean) * (it - mean) } / found.size / (found.size - 1.0))
        assertEquals(4.0, mean, 3 * error)
        assertTrue(error < 0.1) { "$error" }
    }

    @Test
    fun `order, threads and bodies change no bit`() {
        val random = SeededRandom(3)
        val p =
            made(5000, {
                1 + random.nextDouble()
            }, { _, _ -> random.nextGaussian() }, { _, _ -> random.nextGaussian() })
        val expected = ModeSums(8, sheet).of(p).all()
        assertEquals(expected, ModeSums(8, sheet).of(p.permuted(9)).all())
        FixedPool(3).use { pool ->
            val loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
            val sums = ModeSums(8, sheet)
            repeat(2) {
                sums.take(p, loop)
                assertEquals(expected, sums.all())
            }
        }
        val body = Population(
            doubleArrayOf(1.0), doubleArrayOf(0.0), doubleArrayOf(0.0), doubleArrayOf(9.0), doubleArrayOf(9.0),
            doubleArrayOf(9.0), doubleArrayOf(3.0), doubleArrayOf(1e4), intArrayOf(5000),
        )
        val more = p.copy().also { it.add(body) }
        assertEquals(expected, ModeSums(8, sheet, 5000).of(more).all())
        assertTrue(expected != ModeSums(8, sheet).of(more).all())
    }

    @Test
    fun `waves are across the flow that a boundary drives, and along x without one`() {
        val box = Box.centred(10.0, 20.0, 30.0)
        assertEquals(1, ModeSums(1, LeesEdwards(box, 0.5)).axis)
        assertEquals(2 * PI / 20, ModeSums(1, LeesEdwards(box, 0.5)).wavenumber(1), 1e-15)
        assertEquals(0, ModeSums(1, Periodic(box)).axis)
        val y = doubleArrayOf(-5.0, 5.0)
        val zero = DoubleArray(2)
        val one = DoubleArray(2) { 1.0 }
        val flow = DoubleArray(2) { 0.5 * y[it] + 3 }
        val p = Population(zero, y, zero.copyOf(), flow, zero.copyOf(), zero.copyOf(), one, one.copyOf())
        assertMode(3.0, 0.0, ModeSums(1, LeesEdwards(box, 0.5)).of(p), VELOCITY_X, 0)
    }

    @Test
    fun `without enough spheres there is no temperature, without any nothing, and odd requests are refused`() {
        val sums = ModeSums(2, sheet).of(made(5, vx = { _, x -> cos(k * x) }))
        assertEquals(1.0, sums.real(VELOCITY_X, 1), 1e-12)
        assertTrue(sums.real(TEMPERATURE, 0).isNaN())
        // All at one place.
        sums.take(made(100).also { it.x.fill(1.0) })
        assertTrue(sums.real(TEMPERATURE, 0).isNaN())
        assertEquals(2.0, Math.hypot(sums.real(DENSITY, 2), sums.imaginary(DENSITY, 2)), 1e-12)
        sums.take(made(0))
        assertTrue(sums.all().filterIndexed { i, _ -> i % 2 == 0 }.all { it.isNaN() }) { "${sums.all()}" }
        for (modes in listOf(0, 65)) {
            val e = assertThrows(IllegalArgumentException::class.java) { ModeSums(modes, sheet) }
            assertEquals("$modes modes; there must be 1 to 64", e.message)
        }
        for (boundary in listOf(Open, HillSheet(sheet.box, 1.0, radiallyOpen = true))) {
            val e = assertThrows(IllegalArgumentException::class.java) { ModeSums(1, boundary) }
            assertEquals("needs a box that repeats along x, along which the modes are", e.message)
        }
    }
}
