package daphnis.drills

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Random

class GrowthTest {
    private val random = Random(1)

    @Test
    fun `a leak is growth that goes on`() {
        val growth = Growth.of(List(60) { look -> 1000L * look + random.nextInt(5000) })
        assertEquals(40_000.0, growth.steady.toDouble(), 15_000.0)
        assertEquals(40_000.0, growth.whole.toDouble(), 8_000.0)
    }

    @Test
    fun `an array that is made larger once is none, whenever that is`() {
        for (jump in 0..60) {
            val growth = Growth.of(List(60) { look -> if (look < jump) 0L else 1_000_000 })
            assertEquals(0, growth.steady, "at look $jump")
            assertTrue(growth.whole <= 1_000_000)
        }
        assertEquals(1_000_000, Growth.of(List(60) { look -> if (look < 40) 0L else 1_000_000 }).whole)
    }

    @Test
    fun `what is made and thrown away at the start is none`() {
        val growth = Growth.of(List(60) { look -> if (look < 10) 1_000_000L * look else 0 })
        assertEquals(0, growth.steady)
        assertEquals(0, growth.whole)
    }

    @Test
    fun `too few values say nothing`() {
        for (n in 0..5) assertEquals(0, Growth.of(List(n) { 1_000_000L * it }).whole)
    }
}
