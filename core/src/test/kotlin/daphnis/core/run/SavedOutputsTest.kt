package daphnis.core.run

import daphnis.core.OutputState
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SavedOutputsTest {
    private val numbers = doubleArrayOf(0.1, -0.0, Double.NaN, Double.NEGATIVE_INFINITY, Double.MIN_VALUE)
    private val saved = mapOf(
        "first" to OutputState("first").also {
            it.put("numbers", numbers)
            it.put("none", LongArray(0))
        },
        "zweite Ausgabe ε" to OutputState("second").also { it.put("counts", longArrayOf(Long.MIN_VALUE, 3)) },
    )

    @Test
    fun `arrays come back to the bit, by name`() {
        val back = SavedOutputs.of(SavedOutputs.bytes(saved))
        assertEquals(saved.keys, back.keys)
        val first = back.getValue("first")
        assertEquals(setOf("numbers", "none"), first.names)
        assertEquals(numbers.map { it.toRawBits() }, first.doubles("numbers").map { it.toRawBits() })
        assertEquals(0, first.longs("none").size)
        assertArrayEquals(longArrayOf(Long.MIN_VALUE, 3), back.getValue("zweite Ausgabe ε").longs("counts"))
    }

    @Test
    fun `what is kept is a copy, and what is asked for wrongly is named`() {
        val state = OutputState("mine")
        val array = doubleArrayOf(1.0)
        state.put("a", array)
        array[0] = 2.0
        state.doubles("a")[0] = 3.0
        assertEquals(1.0, state.doubles("a").single())
        for (wrong in listOf({ state.longs("a") }, { state.doubles("b") })) {
            val message = assertThrows(IllegalStateException::class.java) { wrong() }.message.orEmpty()
            assertTrue("output 'mine'" in message) { message }
        }
    }

    @Test
    fun `bytes that are damaged are refused and never ask for much memory`() {
        val good = SavedOutputs.bytes(saved)
        for (n in good.indices) {
            assertThrows(IllegalArgumentException::class.java) { SavedOutputs.of(good.copyOf(n)) }
        }
        for (at in good.indices) {
            for (bit in 0..7) {
                val bad = good.copyOf().also { it[at] = (it[at].toInt() xor (1 shl bit)).toByte() }
                // Another number or name may come of it; anything else is refused.
                try {
                    SavedOutputs.of(bad)
                } catch (e: IllegalArgumentException) {
                    continue
                }
            }
        }
    }
}
