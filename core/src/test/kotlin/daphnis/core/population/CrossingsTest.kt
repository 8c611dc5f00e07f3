package daphnis.core.population

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.concurrent.thread

class CrossingsTest : CrossingsCases(areFew = false)

/** The same where few spheres cross, as on a node. */
class FewCrossingsTest : CrossingsCases(areFew = true)

abstract class CrossingsCases(areFew: Boolean) {
    private val ids = IntArray(1000) { 7 * it }
    private val crossings = Crossings(IdPlaces(ids), areFew)

    private fun all() = List(3) { axis -> ids.map { crossings.of(it, axis) } }

    /** More crossings than there is room for at first, some of them of one sphere through several faces. */
    private fun cross(sign: Int) {
        for (k in ids.indices) crossings.add(ids[k / 2], k % 3, sign * (1 + k % 5))
    }

    @Test
    fun `what crossed in a step is taken back with it, and stays when the step stands`() {
        val none = all()
        crossings.begin()
        cross(1)
        crossings.takeBack()
        assertEquals(none, all())
        crossings.begin()
        cross(-1)
        crossings.commit()
        // The first sphere has gone −1, the second −2 boxes along x and y.
        assertEquals(listOf(-1, -2), List(2) { axis -> crossings.of(0, axis) })
        val once = all()
        crossings.begin()
        cross(3)
        cross(-1)
        crossings.takeBack()
        assertEquals(once, all())
        crossings.begin()
        crossings.takeBack()
        assertEquals(once, all())
    }

    @Test
    fun `a crossing outside a step is of no step`() {
        crossings.begin()
        crossings.commit()
        crossings.add(14, 2, 5)
        crossings.begin()
        crossings.add(14, 2, 1)
        crossings.takeBack()
        assertEquals(5, crossings.of(14, 2))
        crossings.takeBack()
        assertEquals(5, crossings.of(14, 2))
    }

    @Test
    fun `threads count different spheres at the same time`() {
        crossings.begin()
        val threads = List(4) { t ->
            thread { repeat(50) { for (k in t until ids.size step 4) crossings.add(ids[k], k % 3, k) } }
        }
        for (t in threads) t.join()
        for (k in ids.indices) assertEquals(50 * k, crossings.of(ids[k], k % 3))
        crossings.takeBack()
        for (axis in 0..2) assertEquals(0, ids.count { crossings.of(it, axis) != 0 })
    }

    @Test
    fun `what is handed over is counted from 0 again, by axis and id`() {
        cross(1)
        val before = all()
        val drained = ArrayList<List<Int>>()
        crossings.drain { id, axis, boxes -> drained += listOf(axis, id, boxes) }
        assertEquals(drained.sortedWith(compareBy({ it[0] }, { it[1] })), drained)
        for ((axis, id, boxes) in drained) assertEquals(before[axis][id / 7], boxes)
        assertEquals(before.sumOf { axis -> axis.count { it != 0 } }, drained.size)
        assertEquals(0, all().sumOf { axis -> axis.count { it != 0 } })
        assertEquals(0, crossings.of(-3, 1))
        crossings.add(14, 2, 5)
        assertEquals(5, crossings.of(14, 2))
    }
}
