package daphnis.analysis.movie

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Test

class ColourRangeTest {
    @Test
    fun `sizes that are far apart are told apart by their logarithm`() {
        val range = ColourRange(0.1, 10.0, mayBeLogarithmic = true)
        assertEquals(0.5, range.place(1.0), 1e-12)
        assertEquals(1.0, range.place(10.0), 1e-12)
        assertFalse(ColourRange(1.0, 3.0, mayBeLogarithmic = true).isLogarithmic)
        assertFalse(ColourRange(0.1, 10.0).isLogarithmic)
    }

    @Test
    fun `one value is in the middle, and a range widens with another`() {
        assertEquals(0.5, ColourRange(2.0, 2.0).place(2.0))
        val both = ColourRange(0.0, 1.0).union(ColourRange(-3.0, 0.5))
        assertEquals(-3.0 to 1.0, both.low to both.high)
        assertEquals(0.75, both.place(0.0))
    }
}
