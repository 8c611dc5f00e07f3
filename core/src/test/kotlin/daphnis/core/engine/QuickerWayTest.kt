package daphnis.core.engine

import daphnis.core.engine.QuickerWay.Companion.LEAST_PATIENCE
import daphnis.core.engine.QuickerWay.Companion.STEPS_PER_TRIAL
import daphnis.core.engine.QuickerWay.Companion.TRIAL
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class QuickerWayTest {
    private var now = 0L
    private val quicker = QuickerWay { now }

    /** Takes a step that lasts as long as its way does, and says which way it was. */
    private fun step(islands: Long, serial: Long): Way {
        val way = quicker.choose()
        now += if (way == Way.OWN) islands else serial
        quicker.finish()
        return way
    }

    private fun steps(count: Long, islands: Long, serial: Long) = List(count.toInt()) { step(islands, serial) }

    private fun List<Way>.serialAt() = indices.filter { this[it] == Way.SERIAL }

    @Test
    fun `islands that are quicker are taken but for one trial in 64 steps`() {
        assertEquals(listOf(8, 72, 136), steps(3 * STEPS_PER_TRIAL, islands = 1000, serial = 4000).serialAt())
    }

    @Test
    fun `islands that are a little slower are taken all the same`() {
        assertEquals(listOf(8, 72), steps(2 * STEPS_PER_TRIAL, islands = 1250, serial = 1000).serialAt())
    }

    @Test
    fun `islands that are clearly slower rest, the longer the more they lost`() {
        // Twice as slow: 128 steps of rest after the trial; then as many in islands as there are until the next one.
        assertEquals((8..136).toList(), steps(137, islands = 2000, serial = 1000).serialAt())
        assertEquals(Way.OWN, step(2000, 1000))
        // After a rest of its own length a trial at step 200 finds the same.
        assertEquals((62..190).toList(), steps(191, islands = 2000, serial = 1000).serialAt())
    }

    @Test
    fun `the rest is no longer than four times the loss allows`() {
        steps(TRIAL, islands = 1_000_000, serial = 1)
        val ways = steps(1 + 4 * STEPS_PER_TRIAL + 1, islands = 1_000_000, serial = 1)
        assertEquals(ways.indices.toList().dropLast(1), ways.serialAt())
    }

    @Test
    fun `the quickest step in islands counts, not one that something else made slow`() {
        repeat(TRIAL.toInt()) { step(if (it == 3) 1000 else 100_000, 1000) }
        assertEquals(Way.SERIAL, step(0, 1000))
        assertEquals(Way.OWN, step(1000, 1000))
    }

    @Test
    fun `patience has no end before the first trial, and four times its length afterwards`() {
        quicker.choose()
        now += Long.MAX_VALUE / 2
        assertFalse(quicker.isLate)
        quicker.finish()
        val serial = LEAST_PATIENCE
        steps(TRIAL, islands = serial, serial = serial)
        assertEquals(Way.OWN, quicker.choose())
        now += 4 * serial
        assertFalse(quicker.isLate)
        now++
        assertTrue(quicker.isLate)
    }

    @Test
    fun `patience is never less than 20 ms`() {
        steps(TRIAL + 1, islands = 10, serial = 10)
        quicker.choose()
        now += 20_000_000
        assertFalse(quicker.isLate)
        now++
        assertTrue(quicker.isLate)
    }

    @Test
    fun `the serial way is never late`() {
        steps(TRIAL, islands = 10, serial = 10)
        assertEquals(Way.SERIAL, quicker.choose())
        now += Long.MAX_VALUE / 2
        assertFalse(quicker.isLate)
    }

    @Test
    fun `islands that were given up rest for 256 steps, and the next trial has the patience of the rest's quickest`() {
        steps(TRIAL + 1, islands = 10, serial = 1_000_000_000)
        quicker.choose()
        quicker.giveUp()
        val rest = List(256) { step(0, if (it == 100) 10_000_000 else 1_000_000_000) }
        assertEquals(setOf(Way.SERIAL), rest.toSet())
        assertEquals(Way.OWN, quicker.choose())
        now += 40_000_000
        assertFalse(quicker.isLate)
        now++
        assertTrue(quicker.isLate)
    }

    @Test
    fun `a step that fails leaves no trace but its turn`() {
        repeat(TRIAL.toInt()) { quicker.choose() }
        assertEquals(Way.SERIAL, quicker.choose())
        assertEquals(Way.OWN, quicker.choose())
    }
}
