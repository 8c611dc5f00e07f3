package daphnis.core.engine.islands

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class SuspectsTest {
    private fun Suspects.all() = List(size) { listOf(slot(it), other(it), image(it), attempt(it)) }

    @Test
    fun `each is noted once, in the order of its first coming, window after window`() {
        val suspects = Suspects()
        for (seed in 1L..80L) {
            val random = SeededRandom(seed)
            suspects.clear()
            // Few numbers make many repetitions, many make the table grow.
            val range = 1 + random.nextInt(40)
            val expected = LinkedHashSet<List<Int>>()
            repeat(random.nextInt(4000)) {
                val pair = List(4) { random.nextInt(range) }
                expected += pair
                suspects.add(pair[0], pair[1], pair[2], pair[3])
            }
            assertEquals(expected.toList(), suspects.all()) { "seed $seed" }
        }
    }

    @Test
    fun `pairs that differ in one number only are different`() {
        val suspects = Suspects()
        val some =
            listOf(listOf(1, 2, 3, 4), listOf(0, 2, 3, 4), listOf(1, 0, 3, 4), listOf(1, 2, 0, 4), listOf(1, 2, 3, 0))
        repeat(3) { for (pair in some) suspects.add(pair[0], pair[1], pair[2], pair[3]) }
        assertEquals(some, suspects.all())
    }

    @Test
    fun `what was forgotten is not remembered`() {
        val suspects = Suspects()
        repeat(1000) { suspects.add(it, -it, 0, 7) }
        suspects.clear()
        assertEquals(0, suspects.size)
        repeat(3) { suspects.add(5, -5, 0, 7) }
        assertEquals(listOf(listOf(5, -5, 0, 7)), suspects.all())
    }
}
