package daphnis.core.engine

import daphnis.core.engine.QuickerWay.Companion.AFTER_CHANGE
import daphnis.core.engine.QuickerWay.Companion.LEAST_PATIENCE
import daphnis.core.engine.QuickerWay.Companion.LONGEST
import daphnis.core.engine.QuickerWay.Companion.MEASURED
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class QuickerWayTest {
    private var now = 0L
    private val quicker = QuickerWay(longArrayOf(MEASURED, MEASURED)) { now }
    private val both = intArrayOf(0, 1)

    /** Takes a step of which each way takes so long, and returns the way in which it was taken. */
    private fun step(vararg times: Long, begins: Boolean = true, of: QuickerWay = quicker): Int {
        val way = of.choose(times.indices.toList().toIntArray())
        now += times[way]
        of.finish(begins)
        return way
    }

    private fun steps(count: Int, vararg times: Long, of: QuickerWay = quicker) = List(count) { step(*times, of = of) }

    /** Lengths of the stretches of one way after the other. */
    private fun List<Int>.stretches(): List<Int> {
        val changes = indices.filter { it > 0 && this[it] != this[it - 1] }
        return (listOf(0) + changes + size).zipWithNext { a, b -> b - a }
    }

    @Test
    fun `a slower way is tried ever more seldom, for two stretches or 20 ms each time`() {
        val ways = steps(4000, MEASURED / 10, MEASURED / 8)
        assertEquals(0, ways[0])
        // 1 time what is measured, then 8 and 16 times what a trial took, 2, 4 … times; and a step for each change.
        val stretches = ways.stretches()
        assertEquals(listOf(11, 9), stretches.take(2))
        val spells = stretches.dropLast(1).filterIndexed { k, _ -> k % 2 == 0 }
        assertTrue(spells.zipWithNext().all { (a, b) -> b >= a }) { "$stretches" }
        assertEquals((LONGEST / MEASURED * 10 + 1).toInt(), spells.max()) { "$stretches" }
    }

    @Test
    fun `a trial that takes long makes the way wait for eight times as long, and then longer`() {
        // Two stretches of a second each: 16 s, and twice as long each time, up to 128.
        val stretches = steps(1200, 500_000_000, 1_000_000_000).stretches().dropLast(1)
        val spells = stretches.drop(2).filterIndexed { k, _ -> k % 2 == 0 }
        assertEquals(listOf(33, 65, 129, 257, 257), spells.take(5)) { "$stretches" }
    }

    @Test
    fun `where each step is a stretch, a way that is far slower is left after one`() {
        var lost = 0L
        val ways = List(20_000) {
            quicker.choose(both).also { way ->
                now += if (way == 0) 200_000_000 else 20_000_000_000
                if (way == 1) lost += 20_000_000_000
                quicker.finish(begins = true, ends = true)
            }
        }
        assertTrue(ways.stretches().filterIndexed { k, _ -> k % 2 == 1 }.dropLast(1).all { it == 1 })
        assertTrue(lost > 0 && lost < 0.03 * now) { "$lost of $now" }
    }

    @Test
    fun `a way that is quicker takes nearly all steps`() {
        val ways = steps(4000, MEASURED / 8, MEASURED / 10)
        assertTrue(ways.count { it == 1 } > 3700) { "${ways.stretches()}" }
        // The one before is tried against it soon.
        assertEquals(listOf(9, 10 + (AFTER_CHANGE / MEASURED * 10).toInt() + 1), ways.stretches().take(2))
    }

    @Test
    fun `of three ways the quickest wins, wherever it stands`() {
        for (best in 0..2) {
            val times = LongArray(3) { if (it == best) 1_000_000 else 1_500_000L + it }
            val three = QuickerWay(LongArray(3) { MEASURED }) { now }
            val ways = steps(8000, *times, of = three)
            assertEquals(setOf(0, 1, 2), ways.toSet())
            assertTrue(ways.takeLast(7000).count { it == best } > 6300) { "${ways.stretches()}" }
        }
    }

    @Test
    fun `what is not allowed is neither tried nor kept`() {
        val three = QuickerWay(LongArray(3) { MEASURED }) { now }
        var third = 0
        repeat(2000) {
            // The last way is far quicker, where it is allowed.
            val allowed = if (it in 500 until 1000) intArrayOf(0, 1, 2) else intArrayOf(1, 0)
            val way = three.choose(allowed)
            assertTrue(way in allowed)
            if (way == 2) third++
            now += if (way == 2) 100_000 else 1_000_000
            three.finish(begins = true)
            if (it == 0 || it == 1000) assertEquals(1, way)
        }
        assertTrue(third > 300) { "$third" }
    }

    @Test
    fun `a way is first tried when it is to be`() {
        val late = QuickerWay(longArrayOf(MEASURED, 50 * MEASURED)) { now }
        val ways = steps(2000, MEASURED / 10, MEASURED / 100, of = late)
        assertEquals(501, ways.indexOf(1))
    }

    @Test
    fun `what is hardly quicker does not win`() {
        assertTrue(steps(2000, 100_000, 98_000).count { it == 0 } > 1000)
    }

    @Test
    fun `when things change, so does the way`() {
        assertTrue(steps(3000, 1_000_000, 2_000_000).takeLast(100).count { it == 0 } > 75)
        // However long the present way may last, in some seconds the other is asked.
        val later = steps(8000, 1_000_000, 500_000)
        assertTrue(later.indexOfFirst { it == 1 } < 2600) { "${later.stretches()}" }
        assertTrue(later.takeLast(4000).count { it == 1 } > 3600) { "${later.stretches()}" }
    }

    @Test
    fun `whole stretches are compared, and none that began in the other way`() {
        // The first step of a stretch takes as long as the others together, so that parts would mislead.
        val length = 8
        var way = 0
        var changes = 0
        var last = -2 * length
        for (step in 0 until 4000) {
            val next = quicker.choose(both)
            if (next != way) {
                changes++
                assertTrue(step - last >= 2 * length) { "after ${step - last} steps" }
                last = step
                way = next
                // It changes after the first step of a stretch.
                assertEquals(1, step % length) { "step $step" }
            }
            now += (if (step % length == 0) 7_000_000L else 1_000_000L) * (if (way == 0) 4 else 5)
            quicker.finish(begins = step % length == 0)
        }
        assertTrue(changes in 6..60) { "$changes" }
        assertTrue(way == 0 || changes % 2 == 1)
    }

    @Test
    fun `steps that are slower and slower do not make a way win that is as slow`() {
        // The present way is judged by its last 20 ms, not by all of a long spell.
        var cost = 1_000_000.0
        var other = 0
        repeat(6000) {
            other += step(cost.toLong(), (1.02 * cost).toLong())
            cost *= 0.9998
        }
        assertTrue(other < 600) { "$other" }
    }

    @Test
    fun `a step that fails is not measured`() {
        steps(5, 1_000_000, 1_000_000)
        quicker.choose(both)
        now += 100 * MEASURED
        assertTrue(steps(10, 1_000_000, 1_000_000).all { it == 0 })
        assertFalse(steps(30, 1_000_000, 1_000_000).all { it == 0 })
    }

    @Test
    fun `patience has no end before another way is known, and four times its length afterwards`() {
        quicker.choose(both)
        now += Long.MAX_VALUE / 2
        assertFalse(quicker.isLate)
        val time = MEASURED
        assertTrue(steps(9, time, time).toSet() == setOf(0, 1))
        quicker.choose(both)
        now += 4 * time
        assertFalse(quicker.isLate)
        now++
        assertTrue(quicker.isLate)
    }

    @Test
    fun `patience is never less than 20 ms`() {
        val eager = QuickerWay(longArrayOf(1, 1)) { now }
        steps(5 * MEASURED.toInt() / 10_000, 10_000, 10_000, of = eager)
        eager.choose(both)
        now += LEAST_PATIENCE.toLong()
        assertFalse(eager.isLate)
        now++
        assertTrue(eager.isLate)
    }

    @Test
    fun `a way that is given up is not taken soon, whether it had won or was tried`() {
        for (hasWon in listOf(true, false)) {
            val two = QuickerWay(longArrayOf(MEASURED, MEASURED)) { now }
            steps(9, MEASURED, MEASURED, of = two)
            // The first way has won; the second is being tried now and then.
            while (two.choose(both) != (if (hasWon) 0 else 1)) {
                now += MEASURED
                two.finish(begins = true)
            }
            now += 10 * MEASURED
            assertTrue(two.isLate)
            two.giveUp()
            val other = if (hasWon) 1 else 0
            assertEquals(List(80) { other }, steps(80, MEASURED, MEASURED, of = two))
            assertTrue(steps(10, MEASURED, MEASURED, of = two).toSet().size == 2)
        }
    }
}
