package daphnis.core.cluster.bricks

import daphnis.core.engine.Case
import daphnis.core.engine.Draw
import daphnis.core.engine.Draws
import daphnis.core.engine.OddDraw
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Bonds
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/** Bricks that look ahead, whose spheres somebody kicks, swaps, turns back, resizes and removes between steps. */
@Timeout(600)
class MovedByHandTest {
    private val draws = Draws.of(usual = 60, long = 2000)

    /** What is done to spheres between two steps. */
    private class Hand(random: SeededRandom, private val dt: Double) {
        private val kicks = random.nextInt(2) == 0
        private val swaps = random.nextInt(2) == 0
        private val turns = random.nextInt(2) == 0
        private val resizes = random.nextInt(2) == 0
        private val removes = random.nextInt(2) == 0

        /** In radii per step. */
        private val kick = doubleArrayOf(0.001, 0.01, 0.03)[random.nextInt(3)]

        override fun toString() =
            "kicks $kicks by $kick, swaps $swaps, turns $turns, resizes $resizes, removes $removes"

        fun act(p: Population, random: SeededRandom) {
            val all = p.indicesById()
            fun any() = all[random.nextInt(p.size)]
            if (kicks) all.forEach { kick(p, it, random) }
            // Pairs whose states do not fit their distances any more would heat such a gas without end.
            val areFree = p.bonds === Bonds.NONE
            if (swaps && areFree) repeat(1 + p.size / 20) { swap(p, any(), any()) }
            if (turns) repeat(1 + p.size / 40) { any().let { p.vx[it] = -p.vx[it] } }
            if (resizes && areFree) repeat(1 + p.size / 40) { p.radius[any()] *= FACTORS[random.nextInt(FACTORS.size)] }
            if (removes && p.size > 20) {
                val gone = (0..p.size / 50).map { p.id[any()] }.toSet()
                p.retain { p.id[it] !in gone }
            }
        }

        private fun kick(p: Population, k: Int, random: SeededRandom) {
            val most = kick * p.radius[k] / dt
            for (axis in 0..2) p.velocity(axis)[k] += most * random.nextGaussian()
        }

        private fun swap(p: Population, a: Int, b: Int) {
            if (p.radius[a] != p.radius[b]) return
            for (place in 0..5) {
                val column = p.column(place)
                column[a] = column[b].also { column[b] = column[a] }
            }
        }
    }

    private fun engine(random: SeededRandom): BricksTogether {
        val division = BrickDivision(1 + random.nextInt(4), 1 + random.nextInt(3), 1 + random.nextInt(3))
        val margins = HaloMargins(doubleArrayOf(0.0, 0.3, 1.0, 3.0)[random.nextInt(4)], 0.0)
        val tuning = if (random.nextInt(6) == 0) {
            HorizonTuning(1).inWindows(1 + random.nextInt(4))
        } else {
            HorizonTuning(1 + random.nextInt(64), deviation = random.nextInt(4) * 0.1)
        }
        return BricksTogether(FixedPool(1), division, margins, BrickAhead.Choice(0, tuning))
    }

    @Test
    fun `bricks find what the serial engine finds, whatever was done to spheres between steps`() {
        var ahead = 0L
        for (seed in Draws.first..<Draws.first + draws) {
            val case: Case = if (seed % 6 == 0L) OddDraw(seed) else Draw(seed)
            if (case.population.size !in 2..700) continue
            val engine = engine(case.random)
            val hand = Hand(case.random, case.dt)
            val serial = case.simulation(SerialEngine())
            case.simulation(engine).use { bricks ->
                for (step in 1..14) {
                    val story = "$case, step $step, ${engine.bricks} bricks, $hand"
                    for (p in listOf(serial.population, bricks.population)) {
                        if (step > 1) hand.act(p, SeededRandom(100 * seed + step))
                    }
                    val expected = failure(serial)
                    assertEquals(expected, failure(bricks)) { story }
                    assertSameStep(serial, bricks, story)
                    if (expected != null) break
                }
            }
            ahead += engine.crew.stepsAhead
        }
        println("$draws draws, $ahead steps ahead")
    }

    private companion object {
        val FACTORS = doubleArrayOf(0.5, 0.9, 1.0, 1.01)
    }
}
