package daphnis.actors.region

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class RegionCountTest {
    @Test
    fun `the number of regions suits spheres and threads, unless somebody wants another`() {
        assertEquals(4, RegionCount.of(0, 100_000, 4))
        assertEquals(3, RegionCount.of(0, 7_999, 4))
        assertEquals(1, RegionCount.of(0, 10, 64))
        assertEquals(64, RegionCount.of(0, Int.MAX_VALUE, 64))
        assertEquals(7, RegionCount.of(7, 10, 2))
        assertEquals(32, RegionCount.of(33, 10, 2))
        assertEquals(33, RegionCount.of(33, 10, 40))
    }

    @Test
    fun `a number that is negative or too large is refused by name`() {
        for (count in listOf(-1, RegionCount.MOST + 1)) {
            for (make in listOf({ RegionActorEngine(2, count) }, { PekkoEngine(2, count) })) {
                val message = assertThrows(IllegalArgumentException::class.java) { make() }.message
                assertEquals("number of regions is $count; it must be in 1..4096, or 0 for what suits", message)
            }
        }
    }
}
