package daphnis.core.cluster.bricks

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.at
import daphnis.core.engine.Case
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.Draw
import daphnis.core.engine.Draws
import daphnis.core.engine.OddDraw
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/** Bricks of every shape and with halos of every width against the serial engine. */
@Timeout(600)
class BricksAgreeTest {
    private val draws = Draws.of(usual = 120, long = 120)

    private fun case(seed: Long): Case = if (seed % 4 == 0L) OddDraw(seed) else Draw(seed)

    /** Of the case's own stream: the shape of the bricks, how wide their halos are, the number of threads. */
    private fun engine(case: Case): BricksTogether {
        val random = case.random
        val division = BrickDivision(1 + random.nextInt(4), 1 + random.nextInt(4), 1 + random.nextInt(3))
        val margins = HaloMargins(WIDTHS[random.nextInt(WIDTHS.size)], 0.0)
        val pool = FixedPool(1 + random.nextInt(2))
        return BricksTogether(pool, division, margins, ahead(random))
    }

    private fun ahead(random: SeededRandom) = when (random.nextInt(4)) {
        0 -> BrickAhead.Choice.NEVER
        1 -> BrickAhead.Choice(0, null)
        else -> BrickAhead.Choice(0, HorizonTuning(1 + random.nextInt(12), deviation = random.nextInt(3) * 0.1))
    }

    @Test
    fun `bricks of any shape, with halos of any width, give the digest, counts and collisions of the serial engine`() {
        var redone = 0L
        var replays = 0L
        var ahead = 0L
        for (seed in Draws.first..<Draws.first + draws) {
            val case = case(seed)
            val serial = case.simulation(SerialEngine())
            val engine = engine(case)
            case.simulation(engine).use { bricks ->
                for (step in 1..STEPS) {
                    val expected = failure(serial)
                    val story = "$case, step $step, ${engine.bricks} bricks on ${engine.threads} threads"
                    assertEquals(expected, failure(bricks)) { story }
                    assertSameStep(serial, bricks, story)
                    if (expected != null) break
                }
                replays += bricks.collisions!!.counters.causalityReplays
            }
            redone += engine.redone
            ahead += engine.crew.stepsAhead
        }
        println("$draws draws, $ahead steps ahead, $redone redone with wider halos, $replays replays")
        if (draws >= 120) assertTrue(redone > draws / 4) { "only $redone steps redone: halos are never too narrow" }
        assertTrue(replays < draws / 4) { "$replays of $draws draws left to the serial engine" }
    }

    @Tag("thorough")
    @Test
    fun `bricks that do not compare paths go wrong, so the draws test the comparison`() {
        var wrong = 0
        for (seed in 1..20L) {
            val case = LongBox(seed)
            val start = case.population
            val serial = simulationOf(start.copy(), case.boundary, LongBox.DT)
            val engine = BricksTogether(FixedPool(1), case.slabs(4), HaloMargins(0.0, 0.0))
            engine.crew.isTrusting = true
            simulationOf(start.copy(), case.boundary, LongBox.DT, engine = engine).use {
                serial.advance()
                it.advance()
                if (stateDigest(serial.population) != stateDigest(it.population)) wrong++
            }
        }
        assertTrue(wrong > 5) { "only $wrong cases are wrong without a comparison" }
    }

    @Test
    fun `a box that narrows and widens under its cuts changes no bit`() {
        val boundary = HillSheet(Box.centred(12.0, 20.0, 6.0), 0.2, perturbation = 0.6)
        val start = randomSpheres(300, boundary.at(0.0), 4, 0.5) { 0.3 }
        fun sheet(engine: CollisionEngine) = Simulation(
            start.copy(),
            boundary,
            CollisionForcing(ConstantRestitution(0.7), engine = engine, recordCollisions = true),
            FixedTimeStep(0.4),
            listOf(HillFrame(0.2)),
        )
        val serial = sheet(SerialEngine())
        sheet(BricksTogether(FixedPool(2), BrickDivision(4, 1, 1))).use { bricks ->
            for (step in 1..80) {
                serial.advance()
                bricks.advance()
                assertSameStep(serial, bricks, "step $step")
            }
        }
        assertTrue(serial.collisions!!.counters.collisions > 1000)
    }

    @Test
    fun `a full slide of the sheet under its cuts changes no bit`() {
        // The images slide by one length of the box in 20 / (1.5 · 0.2 · 12) = 5.6.
        val boundary = HillSheet(Box.centred(12.0, 20.0, 6.0), 0.2)
        val start = randomSpheres(500, boundary, 4, 0.5) { 0.4 }
        val serial = simulationOf(start.copy(), boundary, 0.15, ConstantRestitution(0.7))
        val engine = BricksTogether(FixedPool(2), BrickDivision(4, 1, 1))
        simulationOf(start.copy(), boundary, 0.15, ConstantRestitution(0.7), engine = engine).use { bricks ->
            for (step in 1..40) {
                serial.advance()
                bricks.advance()
                assertSameStep(serial, bricks, "step $step")
            }
        }
        assertEquals(4, engine.bricks)
        assertTrue(serial.collisions!!.counters.collisions > 1000)
    }

    @Tag("thorough")
    @Test
    fun `chains of collisions across many cuts change no bit`() {
        var redone = 0L
        for (seed in 1..10L) {
            val case = LongBox(seed)
            val serial = simulationOf(case.population.copy(), case.boundary, LongBox.DT)
            val engine = BricksTogether(FixedPool(2), case.slabs(5), HaloMargins(0.0, 0.0))
            simulationOf(case.population.copy(), case.boundary, LongBox.DT, engine = engine).use { bricks ->
                for (step in 1..6) {
                    serial.advance()
                    bricks.advance()
                    assertSameStep(serial, bricks, "seed $seed, step $step")
                }
                assertEquals(0, bricks.collisions!!.counters.causalityReplays)
            }
            redone += engine.redone
        }
        assertTrue(redone > 10) { "only $redone redone" }
    }

    private companion object {
        const val STEPS = 5

        /** In mean diameters. */
        val WIDTHS = doubleArrayOf(0.0, 0.0, 0.3, 1.0, 3.0)
    }
}
