package daphnis.core.scenario

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

class RepeatedKeyTest {
    @TempDir
    lateinit var home: Path

    private val gas = """
        { // one way
          "box": { "lengths": [20, 20, 20] },
          "boundary": { "type": "periodic" },
          "particles": { "count": 10, "sizes": { "type": "equal", "radius": 0.5 } },
          "restitution": { "type": "constant", "coefficient": 0.9 },
          "forces": [],
          "until": 1,
        }
    """.trimIndent()

    @Test
    fun `a key twice is named by its path, whole objects, nested ones, in lists, and as an escape`() {
        fun path(text: String) = RepeatedKey.find(text)?.path
        assertEquals("box", path("""{"box": {"a": 1}, "b": 2, "box": {"a": 1}}"""))
        assertEquals("a.b", path("""{"a": {"b": 1, "b": 1}}"""))
        assertEquals("forces[1].x", path("""{"forces": [{"x": 1}, {"x": 1, "y": [], "x": 2}]}"""))
        assertEquals("a[0][1].b", path("""{"a": [[1, {"b": 1, "b": 2}]]}"""))
        assertEquals("box", path("""{"box": 1, "\u0062ox": 2}"""))
        assertEquals("", path("""{"": 1, "": 2}"""))
    }

    @Test
    fun `keys of others, values, comments and words with quotes are no repetition`() {
        for (text in listOf(
            gas,
            """{"a": "b", "b": "a", "c": {"a": 1}}""",
            """{"a": 1, // "a": 2
                "b": 1 /* "a": 3, */ }""",
            """{"a\"": 1, "a": "\"a\": 1", "A": 2}""",
            """[{"a": 1}, {"a": 1}, "a", "a"]""",
            """{"a": [{"a": 1,}, {"a": 1},], }""",
            "3",
        )) {
            assertNull(RepeatedKey.find(text)) { text }
        }
    }

    @Test
    fun `a scenario with one is refused by its line and column, and so is a setting`() {
        val twice = gas.replace("\"until\": 1,", "\"until\": 1,\n  \"box\": { \"lengths\": [30, 30, 30] }")
        val e = assertThrows(InputException::class.java) { ScenarioJson.parse(twice, "gas.json") }
        assertTrue("gas.json:8:3: box: is given twice, first in line 2" in e.message!!) { e.message!! }
        val setting = listOf("boundary={\"type\":\"open\",\"type\":\"periodic\"}")
        val other = assertThrows(InputException::class.java) { ScenarioJson.parse(gas, "gas.json", setting) }
        assertTrue("boundary" in other.message!! && "type twice" in other.message!!) { other.message!! }
    }

    @Test
    fun `a mark of UTF-8 and gzip are no part of a scenario`() {
        val marked = Files.writeString(home.resolve("a.json"), "\uFEFF$gas")
        assertEquals(1.0, ScenarioJson.read(marked).until)
        assertEquals(1.0, ScenarioJson.parse("\uFEFF$gas", "text").until)
        val packed = home.resolve("a.json.gz")
        GZIPOutputStream(Files.newOutputStream(packed)).use { Files.copy(marked, it) }
        assertEquals(1.0, ScenarioJson.read(packed).until)
        Files.write(packed, Files.readAllBytes(packed).let { it.copyOf(it.size / 2) })
        val e = assertThrows(InputException::class.java) { ScenarioJson.read(packed) }
        assertTrue("cannot be read" in e.message!!) { e.message!! }
    }
}
