package daphnis.core.input

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import java.nio.file.InvalidPathException

class InputPathTest {
    @Test
    fun `what Windows forbids in a name is named, and is not taken for a letter of another encoding`() {
        assertEquals("it holds a ?", reasonOf(InvalidPathException("a?b:", "Illegal char <?>", 1), "Cp1252"))
        val letters =
            reasonOf(InvalidPathException("é", "Malformed input or input contains unmappable characters"), "X")
        assertTrue("not in X" in letters) { letters }
    }

    @Test
    fun `a NUL is in no name`() {
        val said = assertThrows<InputException> { inputPath("a\u0000b", "--out") }.message.orEmpty()
        assertTrue(said.startsWith("--out: ") && said.endsWith("it holds a NUL character")) { said }
    }
}
