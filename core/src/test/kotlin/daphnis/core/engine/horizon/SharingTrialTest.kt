package daphnis.core.engine.horizon

import daphnis.core.engine.horizon.SharingTrial.Companion.AFTER_CHANGE
import daphnis.core.engine.horizon.SharingTrial.Companion.LONGEST
import daphnis.core.engine.horizon.SharingTrial.Companion.MEASURED
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SharingTrialTest {
    private var now = 0L
    private val trial = SharingTrial(isAlone = true) { now }

    /** Takes steps of which each begins an epoch of [epoch] steps now and then; the ways in which they were taken. */
    private fun steps(count: Int, alone: Long, shared: Long, epoch: Int = 1): List<Boolean> = List(count) { step ->
        val isAlone = trial.isAlone
        trial.begin()
        now += if (isAlone) alone else shared
        trial.finish(beganEpoch = step % epoch == 0)
        isAlone
    }

    /** Lengths of the stretches of one way after the other. */
    private fun List<Boolean>.stretches(): List<Int> {
        val changes = indices.filter { it > 0 && this[it] != this[it - 1] }
        return (listOf(0) + changes + size).zipWithNext { a, b -> b - a }
    }

    @Test
    fun `threads that are slower are asked ever more seldom, and for two epochs or 20 ms each time`() {
        val ways = steps(4000, alone = MEASURED / 10, shared = MEASURED / 8)
        val stretches = ways.stretches()
        assertTrue(ways[0])
        // Alone for 1, 2, 4 … times what is measured, and a step for each change.
        assertEquals(listOf(11, 9, 21, 9, 41, 9, 81, 9), stretches.take(8))
        val longest = (LONGEST / MEASURED * 10 + 1).toInt()
        assertTrue(stretches.dropLast(1).max() == longest) { "$stretches" }
    }

    @Test
    fun `threads that are quicker share nearly all steps`() {
        val ways = steps(4000, alone = MEASURED / 8, shared = MEASURED / 10)
        assertTrue(ways.count { !it } > 3700) { "${ways.stretches()}" }
        // The way that has won is tried against the other soon.
        assertEquals(listOf(9, 10 + (AFTER_CHANGE / MEASURED * 10).toInt() + 1), ways.stretches().take(2))
    }

    @Test
    fun `what is hardly quicker does not win`() {
        assertTrue(steps(2000, alone = 100_000, shared = 98_000).count { it } > 1000)
    }

    @Test
    fun `when things change, so does the way`() {
        assertTrue(steps(3000, alone = 1_000_000, shared = 2_000_000).takeLast(100).count { it } > 75)
        // However long the present way may last, in some seconds the other is asked.
        val later = steps(8000, alone = 1_000_000, shared = 500_000)
        assertTrue(later.indexOfFirst { !it } < 2600) { "${later.stretches()}" }
        assertTrue(later.takeLast(4000).count { !it } > 3600) { "${later.stretches()}" }
    }

    @Test
    fun `whole epochs are compared, and none that began in the other way`() {
        // The first step of an epoch takes as long as the others together, so that parts of epochs would mislead.
        val epoch = 8
        var way = true
        var changes = 0
        var last = -2 * epoch
        for (step in 0 until 4000) {
            if (trial.isAlone != way) {
                changes++
                assertTrue(step - last >= 2 * epoch) { "after ${step - last} steps" }
                last = step
                way = trial.isAlone
                // It changes after the first step of an epoch.
                assertEquals(1, step % epoch) { "step $step" }
            }
            trial.begin()
            now += (if (step % epoch == 0) 7_000_000L else 1_000_000L) * (if (way) 4 else 5)
            trial.finish(beganEpoch = step % epoch == 0)
        }
        assertTrue(changes in 6..60) { "$changes" }
        assertTrue(way || changes % 2 == 1)
    }

    @Test
    fun `steps that are slower and slower do not make a way win that is as slow`() {
        // The present way is judged by its last 20 ms, not by all of a long spell.
        var cost = 1_000_000.0
        var shared = 0
        for (step in 0 until 6000) {
            if (!trial.isAlone) shared++
            trial.begin()
            now += (cost * if (trial.isAlone) 1.0 else 1.02).toLong()
            trial.finish(beganEpoch = true)
            cost *= 0.9998
        }
        assertTrue(shared < 600) { "$shared" }
    }

    @Test
    fun `a step that fails is not measured`() {
        steps(5, alone = 1_000_000, shared = 1_000_000)
        trial.begin()
        now += 100 * MEASURED
        assertTrue(steps(10, alone = 1_000_000, shared = 1_000_000).all { it })
        assertFalse(steps(30, alone = 1_000_000, shared = 1_000_000).all { it })
    }
}
