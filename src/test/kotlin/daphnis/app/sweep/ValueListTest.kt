package daphnis.app.sweep

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ValueListTest {
    @Test
    fun `commas divide values, but not within brackets, braces or quotation marks`() {
        for ((text, values) in mapOf(
            "0.1" to listOf("0.1"),
            "0.1, 0.5 ,1" to listOf("0.1", "0.5", "1"),
            "[1,2],[3,[4,5]]" to listOf("[1,2]", "[3,[4,5]]"),
            """{"type":"constant","coefficient":0.5},{"type":"bridges"}""" to
                listOf("""{"type":"constant","coefficient":0.5}""", """{"type":"bridges"}"""),
            """"a,b",c""" to listOf("\"a,b\"", "c"),
            """"a\",[b",c""" to listOf("\"a\\\",[b\"", "c"),
            """["]",1],2""" to listOf("[\"]\",1]", "2"),
            "" to listOf(""),
        )) {
            assertEquals(values, ValueList.split(text)) { text }
        }
    }

    @Test
    fun `what cannot be a list is refused with the reason`() {
        for ((text, why) in mapOf(
            "1,,2" to "empty value",
            "1," to "empty value",
            "[1,2" to "'[' that is not closed",
            "1]" to "']' that closes nothing",
            "[1}" to "'}' that closes nothing",
            "\"a" to "quotation mark that is not closed",
            "\"a\\\"" to "quotation mark that is not closed",
            "1,2,1" to "the value 1 twice",
            "0.5,5e-1" to "the value 5e-1 twice",
        )) {
            val e = assertThrows(IllegalArgumentException::class.java) { ValueList.split(text) }
            assertTrue(why in e.message!!) { "$text: ${e.message}" }
        }
    }
}
