package daphnis.core.force

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.permuted
import daphnis.core.population.Partition
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.sin
import kotlin.math.sqrt

class RadialGravityTest {
    private val box = Box.centred(1000.0, 40.0, 10.0)
    private val sheet = HillSheet(box, 1.0)

    private fun patch(count: Int): Population {
        val random = SeededRandom(8)
        return Population(
            DoubleArray(count) { random.nextDouble(-500.0, 500.0) },
            DoubleArray(count) { random.nextDouble(-20.0, 20.0) },
            DoubleArray(count) { random.nextDouble(-4.0, 4.0) },
            DoubleArray(count),
            DoubleArray(count),
            DoubleArray(count),
            DoubleArray(count) { 0.1 },
            DoubleArray(count) { 0.5 + random.nextDouble() },
        )
    }

    @Test
    fun `the force is the sum over waves`() {
        val p = patch(200)
        val modes = 12
        val a = RadialGravity(sheet, 3.0, modes).accelerations(p, 0.0)
        var error = 0.0
        var size = 0.0
        for (i in 0 until p.size) {
            var expected = 0.0
            for (j in 0 until p.size) {
                val distance = p.x[i] - p.x[j]
                for (m in 1..modes) expected -= 4 * PI * 3.0 * p.mass[j] / 4e4 * sin(2 * PI * m / 1000 * distance)
            }
            error += (a[0][i] - expected) * (a[0][i] - expected)
            size += expected * expected
        }
        assertTrue(sqrt(error / size) < 3e-4) { "rms error ${sqrt(error / size)}" }
        assertTrue(a[1].all { it == 0.0 } && a[2].all { it == 0.0 })
    }

    @Test
    fun `the slope of the energy is the force, and no y momentum is carried`() {
        val p = patch(50)
        val gravity = RadialGravity(sheet, 3.0, 12)
        for (k in listOf(3, 30)) {
            fun energy(by: Double) = p.copy().let { q ->
                q.x[k] += by
                gravity.potentialEnergy(q, sheet, 0.0)
            }
            val force = p.mass[k] * gravity.accelerations(p, 0.0)[0][k]
            assertEquals(force, -(energy(0.01) - energy(-0.01)) / 0.02, 2e-3 * abs(force))
        }
        assertEquals(0.0, gravity.stressXY(p, 0.0))
    }

    @Test
    fun `the same bits for any order and number of threads`() {
        val p = patch(20_000)
        val expected = RadialGravity(sheet, 1.0, 40).accelerations(p, 0.0)[0]
        val q = p.permuted(5)
        val permuted = RadialGravity(sheet, 1.0, 40).accelerations(q, 0.0)[0]
        val byId = DoubleArray(p.size).also { for (k in 0 until q.size) it[q.id[k]] = permuted[k] }
        assertArrayEquals(expected, byId)
        FixedPool(3).use { pool ->
            val gravity = RadialGravity(sheet, 1.0, 40)
            gravity.useLoop(ParallelLoop(pool, LoopStrategy.DYNAMIC))
            assertArrayEquals(expected, gravity.accelerations(p, 0.0)[0])
        }
    }

    @Test
    fun `a node has the answer already only where all nodes have it`() {
        var summed = 0
        var another = 0.0
        val gravity = RadialGravity(sheet, 1.0, 4)
        gravity.partition = object : Partition by Partition.Whole {
            override fun add(numbers: DoubleArray) {
                summed++
            }

            override fun max(numbers: DoubleArray) {
                numbers[0] = maxOf(numbers[0], another)
            }
        }
        val p = patch(20)
        gravity.accelerations(p, 0.0)
        val once = summed
        assertTrue(once > 0)
        gravity.accelerations(p, 0.0)
        assertEquals(once, summed)
        another = 1.0
        gravity.accelerations(p, 0.0)
        assertEquals(2 * once, summed)
    }

    /** A cold sheet of rows of spheres, moved along x by sin(kx) of wave [mode], and let go. */
    private fun wave(mode: Int, strength: Double, frequencies: OrbitalFrequencies, use: (Double, Double) -> Boolean) {
        val n = 2000
        val k = 2 * PI * mode / 1000
        val kappa = frequencies.kappa
        val start = DoubleArray(n) { (it + 0.5) / n * 1000 - 500 }
        val moved = DoubleArray(n) { 0.5 * sin(k * start[it]) }
        val p = Population(
            DoubleArray(n) { start[it] + moved[it] },
            DoubleArray(n) { (it * 0.618034) % 1.0 * 40 - 20 },
            DoubleArray(n),
            DoubleArray(n),
            // Every sphere keeps the angular momentum of its place in the sheet at rest.
            DoubleArray(n) { -frequencies.shearRate * start[it] - 2 * frequencies.omega * moved[it] },
            DoubleArray(n),
            DoubleArray(n) { 0.01 },
            DoubleArray(n) { 1.0 },
        )
        // 2πGΣk = strength · κ²
        val constant = strength * kappa * kappa / (2 * PI * k * n / (1000.0 * 40))
        val sheet = HillSheet(box, frequencies)
        val forces = listOf(RadialGravity(sheet, constant, mode), HillFrame(frequencies))
        val simulation = Simulation(p, sheet, null, FixedTimeStep(0.02), forces)
        val place = DoubleArray(n) { start[it] }
        do {
            simulation.advance()
            var sum = 0.0
            for (i in 0 until p.size) {
                val d = p.x[i] - place[p.id[i]]
                sum += (d - 1000 * Math.rint(d / 1000)) * sin(k * place[p.id[i]])
            }
        } while (use(simulation.time, sum * 2 / n / 0.5))
    }

    /** ω from the first to the last of some passages through 0. */
    private fun frequency(mode: Int, strength: Double, frequencies: OrbitalFrequencies): Double {
        var before = 1.0
        var timeBefore = 0.0
        val zeros = ArrayList<Double>()
        wave(mode, strength, frequencies) { time, amplitude ->
            if (before * amplitude < 0) zeros.add(timeBefore + (time - timeBefore) * before / (before - amplitude))
            before = amplitude
            timeBefore = time
            zeros.size < 7
        }
        return PI * (zeros.size - 1) / (zeros.last() - zeros.first())
    }

    @Test
    fun `waves of a cold sheet have the frequency that Toomre gives`() {
        for ((mode, strength, frequencies) in listOf(
            Triple(1, 0.3, OrbitalFrequencies(1.0)),
            Triple(5, 0.6, OrbitalFrequencies(1.0)),
            Triple(3, 0.5, OrbitalFrequencies(1.0, 0.9, 1.1)),
        )) {
            val expected = frequencies.kappa * frequencies.kappa * (1 - strength)
            val found = frequency(mode, strength, frequencies).let { it * it }
            assertEquals(1.0, found / expected, 5e-3) { "mode $mode, 2πGΣk = $strength κ²" }
        }
    }

    @Test
    fun `a wave whose gravity outweighs epicycles grows as Toomre says`() {
        var grown = 0.0
        var last = 0.0
        wave(4, 1.5, OrbitalFrequencies(1.0)) { time, amplitude ->
            grown = amplitude
            last = time
            time < 3.0
        }
        // The amplitude is cosh γt.
        val rate = ln(grown + sqrt(grown * grown - 1)) / last
        assertEquals(0.5, rate * rate, 0.005)
    }

    @Test
    fun `bad numbers and boxes are refused`() {
        for (modes in listOf(0, -1, RadialGravity.MOST_MODES + 1)) {
            assertThrows(IllegalArgumentException::class.java) { RadialGravity(sheet, 1.0, modes) }
        }
        assertThrows(IllegalArgumentException::class.java) { RadialGravity(sheet, Double.NaN, 1) }
        assertThrows(IllegalArgumentException::class.java) { RadialGravity(Open, 1.0, 1) }
        assertThrows(IllegalArgumentException::class.java) {
            RadialGravity(HillSheet(box, 1.0, radiallyOpen = true), 1.0, 1)
        }
        RadialGravity(sheet, 1.0, 5).kick(patch(0), 0.0, 1.0)
        val one = patch(1)
        RadialGravity(sheet, 1.0, 5).kick(one, 0.0, 1.0)
        assertEquals(0.0, one.vx[0], 1e-5)
    }
}
