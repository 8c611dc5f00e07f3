package daphnis.core.engine.lists

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.assertSameStep
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** Where the last bit decides. */
class ListTiesTest {
    @Tag("thorough")
    @Test
    fun `collisions at one time come in the order of ids, whichever sphere knows of them`() {
        var tied = 0
        for (seed in 1L..60L) {
            val random = SeededRandom(seed)
            // All numbers are short in binary digits, so that many times are equal to the last bit.
            val start = crowd(1.25, jitter = 0.0)
            for (k in 0 until start.size) {
                start.vx[k] = random.nextInt(3) - 1.0
                start.vy[k] = if (seed % 3 == 0L) random.nextInt(3) - 1.0 else 0.0
                start.vz[k] = 0.0
                start.id[k] = start.size - start.id[k]
            }
            start.orderChanged()
            val boundary = Periodic(Box.centred(10.0, 10.0, 10.0))
            val law = ConstantRestitution(if (seed % 2 == 0L) 1.0 else 0.5)
            val serial = simulationOf(start.copy(), boundary, 0.25, law)
            val listed = simulationOf(start.copy(), boundary, 0.25, law, engine = CoreEngines.lists())
            for (step in 1..20) {
                serial.advance()
                listed.advance()
                assertSameStep(serial, listed, "seed $seed, step $step")
                val record = serial.collisions!!.record!!
                tied += (1 until record.size).count { record.time[it] == record.time[it - 1] }
            }
        }
        println("$tied collisions at the time of another")
        assertTrue(tied > 60_000) { "$tied" }
    }

    @Test
    fun `whether a sphere grazes another is decided by the last bit, many steps after it was predicted`() {
        val random = SeededRandom(8)
        val n = 1000

        // Pairs: one at rest, and one that flies past it along x, at a distance that is two radii but for some bits.
        fun place(k: Int) = 6.0 * (k / 2 % 10)
        val offset = DoubleArray(n) { 1.0 - (random.nextInt(9) - 4) * 1.1e-16 }
        val start = Population(
            DoubleArray(n) { place(it) + (it % 2) * random.nextDouble(-1.5, -1.0) },
            DoubleArray(n) { 6.0 * (it / 20 % 10) + if (it % 2 == 1) offset[it] * 0.8 else 0.0 },
            DoubleArray(n) { 6.0 * (it / 200) + if (it % 2 == 1) offset[it] * 0.6 else 0.0 },
            DoubleArray(n) { (it % 2) * random.nextDouble(0.5, 1.5) },
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { 0.5 },
            DoubleArray(n) { 1.0 },
        )
        val serial = simulationOf(start.copy(), Open, 0.011)
        val listed = simulationOf(start.copy(), Open, 0.011, engine = CoreEngines.lists())
        for (step in 1..200) {
            serial.advance()
            listed.advance()
            assertSameStep(serial, listed, "step $step")
        }
        val collisions = serial.collisions!!.counters.collisions
        println("$collisions of ${n / 2} that graze")
        assertTrue(collisions in 20L..480L) { "$collisions" }
    }

    @Test
    fun `a sphere that has grown gets a new list`() {
        fun of(vararg v: Double) = v
        // The third makes shells as large as they are.
        val start = Population(
            of(0.0, 2.0, 20.0),
            of(0.0, 0.0, 0.0),
            of(0.0, 0.0, 0.0),
            of(1.0, -1.0, 0.0),
            of(0.0, 0.0, 0.0),
            of(0.0, 0.0, 0.0),
            of(0.35, 0.35, 1.0),
            of(1.0, 1.0, 1.0),
        )
        val engine = CoreEngines.lists()
        val serial = simulationOf(start.copy(), Open, 0.01)
        val listed = simulationOf(start.copy(), Open, 0.01, engine = engine)
        for (step in 1..60) {
            serial.advance()
            listed.advance()
            assertSameStep(serial, listed, "step $step")
            if (step == 1) for (s in listOf(serial, listed)) s.population.run { radius[indexOf(0)] = 1.0 }
        }
        assertEquals(1L, serial.collisions!!.counters.collisions)
        assertEquals(1L, engine.lists.built)
    }
}
