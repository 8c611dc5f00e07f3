package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

@Tag("jdk-neutral")
class PathWordsTest {
    private fun of(words: String) = daphnisCommand().pathsLast(words.split(' ').toTypedArray()).joinToString(" ")

    @Test
    fun `a path that looks like an option stands behind the options, which keep their values`() {
        assertEquals("resume --until 9 --quiet -- /a/seed=1", of("resume /a/seed=1 --until 9 --quiet"))
        assertEquals("resume --until=9 -- ./seed=1", of("resume ./seed=1 --until=9"))
        assertEquals("compare -- ../a=1 b", of("compare ../a=1 b"))
        assertEquals("compare -- -a b=1 ~/c=1", of("compare -- -a b=1 ~/c=1"))
        assertEquals("run --out /a/seed=1 --set a.b=1 -- ./x=1.json", of("run --out /a/seed=1 --set a.b=1 ./x=1.json"))
        assertEquals("export --format xyz -- /a=b", of("export --format xyz /a=b"))
        assertEquals("analyze --untl=9 -- /a=1", of("analyze --untl=9 /a=1"))
    }

    @Test
    fun `all other words stay as they are`() {
        for (same in listOf(
            "resume a/seed=1 --until 9",
            "run",
            "--version",
            "rnu /a=b",
            "analyze /a -- b",
            "run --set x=1",
        )) {
            assertEquals(same, of(same))
        }
    }
}
