package daphnis.core.engine.horizon

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class TimedHeapTest {
    @Test
    fun `numbers leave in order of time, whatever is added meanwhile`() {
        for (seed in 1L..50L) {
            val random = SeededRandom(seed)
            val heap = TimedHeap()
            val model = ArrayList<Pair<Double, Int>>()
            repeat(400) { number ->
                if (random.nextInt(3) > 0 || model.isEmpty()) {
                    // Some times are alike.
                    val time = random.nextInt(40).toDouble()
                    heap.add(time, number)
                    model.add(time to number)
                } else {
                    val least = model.minOf { it.first }
                    assertEquals(least, heap.least)
                    assertEquals(true, model.remove(least to heap.take()))
                }
                assertEquals(model.size, heap.size)
            }
            heap.clear()
            assertEquals(0, heap.size)
        }
    }
}
