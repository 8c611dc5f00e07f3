package daphnis.core.engine.horizon

import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.growth.GrowingTable

/**
 * The pairs of which one is a giant that have been asked in a step, by giant, and the courses of giants; see
 * [SteadyGiants]. An entry holds as long as neither sphere has got a new line. Two giants have an entry each.
 */
internal class AskedGiants(private val lines: Lines) : GrowingTable() {
    private var data = IntArray(0)

    /** The time for which an entry waits; [NEVER] when it does not. */
    private var waits = DoubleArray(0)
    private val giants = Giants()
    private val waiting = TimedHeap()

    override fun resize(room: Int) {
        data = data.copyOf(room * WIDTH)
        waits = waits.copyOf(room)
    }

    /** Forgets all; slots are below [spheres]. */
    fun begin(spheres: Int) {
        giants.begin(spheres)
        waiting.clear()
        clear()
    }

    /** The slots [i] and [j], of which one is [giant], have been asked. @return the entry, which does not wait yet */
    fun add(giant: Int, i: Int, j: Int, code: Int): Int {
        val g = giants.of(giant)
        val e = append()
        val p = e * WIDTH
        data[p] = i
        data[p + 1] = j
        data[p + 2] = code
        data[p + 3] = lines.version[i]
        data[p + 4] = lines.version[j]
        data[p + IMMINENT] = 0
        waits[e] = NEVER
        data[p + NEXT] = giants.entries[g]
        giants.entries[g] = e
        return e
    }

    fun first(e: Int): Int = data[e * WIDTH]

    fun second(e: Int): Int = data[e * WIDTH + 1]

    /** Of the second line, as seen from the first. */
    fun image(e: Int): Int = data[e * WIDTH + 2]

    fun holds(e: Int): Boolean {
        val p = e * WIDTH
        return lines.version[data[p]] == data[p + 3] && lines.version[data[p + 1]] == data[p + 4]
    }

    fun isImminent(e: Int): Boolean = data[e * WIDTH + IMMINENT] != 0

    /** Entry [e], which is one of [giant] and not imminent, is so from now on. */
    fun setImminent(giant: Int, e: Int) {
        val g = giants.of(giant)
        data[e * WIDTH + IMMINENT] = 1
        data[e * WIDTH + NEXT_IMMINENT] = giants.imminent[g]
        giants.imminent[g] = e
    }

    /** Entry [e] waits for [time], or an earlier moment for which it waits already. */
    fun wait(e: Int, time: Double) {
        if (time >= waits[e]) return
        waits[e] = time
        waiting.add(time, e)
    }

    /** Takes an entry that waits for a time up to [time]; [NONE] when there is none. */
    fun takeUntil(time: Double): Int {
        if (waiting.size == 0 || waiting.least > time) return NONE
        return waiting.take().also { waits[it] = NEVER }
    }

    /** Whether [giant] has a course since it got its line. */
    fun hasCourse(giant: Int): Boolean {
        val g = giants.of(giant)
        return giants.versions[g] == lines.version[giant]
    }

    /** [giant] takes its course along the path at [p] of [state]; no entry of it is imminent any more. */
    fun setCourse(giant: Int, state: DoubleArray, p: Int) {
        val g = giants.of(giant)
        giants.versions[g] = lines.version[giant]
        state.copyInto(giants.courses, g * StepRows.STRIDE, p, p + StepRows.STRIDE)
        var e = giants.imminent[g]
        while (e != NONE) {
            data[e * WIDTH + IMMINENT] = 0
            e = after(e, NEXT_IMMINENT)
        }
        giants.imminent[g] = NONE
    }

    /** Copies the course of [giant], as in [StepRows.state]. */
    fun copyCourse(giant: Int, into: DoubleArray) {
        val p = giants.of(giant) * StepRows.STRIDE
        giants.courses.copyInto(into, 0, p, p + StepRows.STRIDE)
    }

    /** Calls [use] with each entry of [giant] that holds. */
    inline fun forEachPresent(giant: Int, use: (e: Int) -> Unit) {
        var e = last(giant)
        while (e != NONE) {
            if (holds(e)) use(e)
            e = after(e, NEXT)
        }
    }

    /** The same with those that are imminent. Drops those that do not hold. */
    inline fun forEachImminent(giant: Int, use: (e: Int) -> Unit) {
        var before = NONE
        var e = lastImminent(giant)
        while (e != NONE) {
            val next = after(e, NEXT_IMMINENT)
            if (holds(e)) {
                use(e)
                before = e
            } else {
                linkImminent(giant, before, next)
            }
            e = next
        }
    }

    /** Entry [next] follows [before] among those that are imminent; it is the first where that is [NONE]. */
    fun linkImminent(giant: Int, before: Int, next: Int) {
        val g = giants.of(giant)
        if (before == NONE) giants.imminent[g] = next else data[before * WIDTH + NEXT_IMMINENT] = next
    }

    fun last(giant: Int): Int {
        val g = giants.of(giant)
        return giants.entries[g]
    }

    fun lastImminent(giant: Int): Int {
        val g = giants.of(giant)
        return giants.imminent[g]
    }

    fun after(e: Int, list: Int): Int = data[e * WIDTH + list]

    /** The giants that have been asked for, numbered. */
    private class Giants : GrowingTable() {
        private var numbers = IntArray(0)
        private var slots = IntArray(0)

        /** The last entry of each, the last that became imminent, the version of its line when it took its course. */
        var entries = IntArray(0)
        var imminent = IntArray(0)
        var versions = IntArray(0)
        var courses = DoubleArray(0)

        override fun resize(room: Int) {
            slots = slots.copyOf(room)
            entries = entries.copyOf(room)
            imminent = imminent.copyOf(room)
            versions = versions.copyOf(room)
            courses = courses.copyOf(room * StepRows.STRIDE)
        }

        fun begin(spheres: Int) {
            for (g in 0 until size) numbers[slots[g]] = NONE
            clear()
            if (numbers.size < spheres) numbers = IntArray(spheres) { NONE }
        }

        /** The number of the giant in [slot]. */
        fun of(slot: Int): Int {
            if (numbers[slot] == NONE) {
                val g = append()
                slots[g] = slot
                entries[g] = NONE
                imminent[g] = NONE
                versions[g] = NONE
                numbers[slot] = g
            }
            return numbers[slot]
        }
    }

    companion object {
        const val NONE = -1
        private const val WIDTH = 8
        private const val IMMINENT = 5
        const val NEXT = 6
        const val NEXT_IMMINENT = 7
    }
}
