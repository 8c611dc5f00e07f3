package daphnis.analysis.diffusion

import daphnis.analysis.insitu.State
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp

class IntermediateScatteringTest {
    private val isFull = System.getProperty("daphnis.physics") == "full"
    private val unit = 2 * PI / 5

    private fun walk(count: Int, times: Int, random: SeededRandom, from: Double, to: Double, most: Int = 48) =
        IntermediateScattering(from, to, most).also { f ->
            Walkers.walk(count, times, random, 0.3) { p, t -> f.add(State(p, Walkers.BOUNDARY, t)) }
        }

    @Test
    fun `of walkers F is exp(−D k² t), and errors cover it in 60 to 75 percent`() {
        val random = SeededRandom(3)
        val realisations = if (isFull) 400 else 80
        val covered = IntArray(2)
        val sum = DoubleArray(2)
        // Six waves: one of each axis and its diagonals are not in so thin a shell.
        repeat(realisations) {
            val f = walk(60, 400, random, 0.9 * unit, 1.1 * unit)
            assertEquals(3, f.vectorCount)
            assertEquals(unit, f.waveNumber, 1e-12)
            val function = f.function()
            for ((k, lag) in listOf(0.0, 4.0).withIndex()) {
                val l = function.lag.indexOfFirst { abs(it - lag) < 1e-9 }
                val known = exp(-unit * unit * 0.09 * lag / 2)
                sum[k] += function.scattering[l] / realisations
                if (abs(function.scattering[l] - known) < function.error[l]) covered[k]++
                if (k == 1) assertEquals(known, sum[1] * realisations / (it + 1), 1.0)
            }
            assertTrue(function.error.last().isNaN())
        }
        if (isFull) println("S ${sum[0]}, F ${sum[1]}, covered ${covered.asList()} of $realisations")
        assertEquals(1.0, sum[0], 0.05)
        assertEquals(exp(-unit * unit * 0.18), sum[1], 0.05)
        for (c in covered) assertTrue(c in realisations * 55 / 100..realisations * 80 / 100) { "$c of $realisations" }
    }

    @Test
    fun `what drifts as a whole forgets nothing`() {
        val p = Walkers.population(40)
        val random = SeededRandom(2)
        for (axis in 0..2) {
            for (k in 0 until 40) {
                p.position(axis)[k] = 5 * random.nextDouble() - 2.5
                p.velocity(axis)[k] = 0.7 + axis
            }
        }
        val f = IntermediateScattering(0.0, 3 * unit, 1000)
        for (t in 0 until 20) {
            f.add(State(p, Walkers.BOUNDARY, t * 0.1))
            for (axis in 0..2) for (k in 0 until 40) p.position(axis)[k] += 0.1 * p.velocity(axis)[k]
            Walkers.BOUNDARY.endStep(p, t * 0.1)
        }
        val found = f.function()
        assertTrue(f.vectorCount > 40)
        for (value in found.scattering) assertEquals(found.scattering[0], value, 1e-9)
    }

    @Test
    fun `of many vectors some are taken from the whole shell, and those of the shell alone`() {
        val all = walk(10, 16, SeededRandom(1), 4 * unit, 5 * unit, 100_000)
        val some = walk(10, 16, SeededRandom(1), 4 * unit, 5 * unit, 20)
        // 4π/3 (5³ − 4³)/2 of them.
        assertTrue(all.vectorCount in 110..145 && some.vectorCount == 20) { "${all.vectorCount} ${some.vectorCount}" }
        assertTrue(all.waveNumber in 4.3 * unit..4.7 * unit && some.waveNumber in 4.2 * unit..4.8 * unit)
        assertEquals(0, walk(10, 16, SeededRandom(1), 0.1 * unit, 0.2 * unit).vectorCount)
    }

    @Test
    fun `a time that comes again, others than before, a sheared box and no waves are refused`() {
        val p = Walkers.population(5)
        val f = IntermediateScattering(unit / 2, 2 * unit)
        f.add(State(p, Walkers.BOUNDARY, 0.0))
        fun refused(state: State) = assertThrows(IllegalArgumentException::class.java) { f.add(state) }
        refused(State(p, Walkers.BOUNDARY, 0.0))
        refused(State(Walkers.population(6), Walkers.BOUNDARY, 1.0))
        refused(State(p, LeesEdwards(Box.centred(5.0, 5.0, 5.0), 1.0), 1.0))
        refused(State(p, Periodic(Box.centred(5.0, 5.0, 5.0), false, true, true), 1.0))
        assertThrows(IllegalStateException::class.java) { f.function() }
        assertThrows(IllegalArgumentException::class.java) { IntermediateScattering(2.0, 1.0) }
    }
}
