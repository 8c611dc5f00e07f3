package daphnis.app.sweep

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class SeedsTest {
    @Test
    fun `seeds are numbers and ranges in the order given`() {
        assertEquals((1L..8).toList(), Seeds.parse("1..8"))
        assertEquals(listOf(5L, 1, 2, 3, -7), Seeds.parse("5, 1..3,-7"))
        assertEquals(listOf(4L), Seeds.parse("4..4"))
        assertEquals(Seeds.MOST, Seeds.parse("1..${Seeds.MOST}").size)
        assertEquals(listOf(Long.MAX_VALUE), Seeds.parse("${Long.MAX_VALUE}"))
    }

    @Test
    fun `everything else is refused`() {
        val many = "1..${Seeds.MOST + 1}|1..9000,9001..20000"
        val wrong = "$many||8..1|1..2..3|a|1.5|1..|..2|1,,2|1,1|1..3,2|99999999999999999999"
        for (text in wrong.split('|') + "${Long.MIN_VALUE}..${Long.MAX_VALUE}") {
            assertThrows(IllegalArgumentException::class.java, { Seeds.parse(text) }, text)
        }
    }
}
