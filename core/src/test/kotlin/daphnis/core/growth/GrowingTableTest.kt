package daphnis.core.growth

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class GrowingTableTest {
    /** Two columns; while [failing], the allocation for the second one fails. */
    private class Pairs : GrowingTable() {
        var first = IntArray(0)
        var second = LongArray(0)
        var failing = false
        val rooms = ArrayList<Int>()

        override fun resize(room: Int) {
            first = first.copyOf(room)
            if (failing) throw OutOfMemoryError("as asked")
            second = second.copyOf(room)
            rooms += room
        }

        fun add(value: Int) {
            val k = append()
            first[k] = value
            second[k] = -value.toLong()
        }

        fun exactly(rows: Int) = reserve(rows)

        fun atLeast(rows: Int) = ensure(rows)
    }

    @Test
    fun `rows stay while arrays double, and nothing is allocated for as many again`() {
        val pairs = Pairs()
        assertEquals(0, pairs.first.size)
        repeat(2) {
            for (k in 0 until 300) pairs.add(k)
            assertEquals(300, pairs.size)
            assertArrayEquals(IntArray(300) { it }, pairs.first.copyOf(300))
            assertArrayEquals(LongArray(300) { -it.toLong() }, pairs.second.copyOf(300))
            assertEquals(listOf(64, 128, 256, 512), pairs.rooms)
            pairs.clear()
            assertEquals(0, pairs.size)
        }
    }

    @Test
    fun `a table that could not grow has the room and the rows that it had, and grows later`() {
        val pairs = Pairs()
        for (k in 0 until 64) pairs.add(k)
        pairs.failing = true
        repeat(3) { assertThrows(OutOfMemoryError::class.java) { pairs.add(64) } }
        assertEquals(listOf(64, 64), listOf(pairs.size, pairs.room))
        pairs.failing = false
        for (k in 64 until 100) pairs.add(k)
        assertArrayEquals(IntArray(100) { it }, pairs.first.copyOf(100))
        assertArrayEquals(LongArray(100) { -it.toLong() }, pairs.second.copyOf(100))
    }

    @Test
    fun `room for a number that is known is no more than that, and never shrinks`() {
        val pairs = Pairs()
        pairs.exactly(10)
        pairs.exactly(5)
        assertEquals(listOf(10), pairs.rooms)
        pairs.atLeast(11)
        pairs.atLeast(1000)
        assertEquals(listOf(10, 64, 1000), pairs.rooms)
        assertTrue(pairs.second.size == 1000 && pairs.size == 0)
    }

    @Test
    fun `a list takes over another and sorts only its own numbers`() {
        val list = IntList()
        val other = IntList()
        for (k in 0 until 100) other.add(100 - k)
        list.add(200)
        list.addAll(other)
        list.sort()
        assertEquals((1..100).toList() + 200, list.toArray().toList())
        list.clear()
        list.addAll(list)
        assertEquals(0, list.size)
        assertEquals(100, other.size)
        assertEquals(100, other[0])
    }
}
