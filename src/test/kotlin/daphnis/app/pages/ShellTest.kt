package daphnis.app.pages

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

/** What a shell would start. */
@Tag("jdk-neutral")
class ShellTest {
    private fun words(block: String) = shellCommands(block).map { it.words }

    @Test
    fun `lines, lists and pipes are commands, comments and prompts are not`() {
        val block = "# first\n./a one && ./b  two; c # why\n\nd | e\na$ f g#h &\n"
        val seen = listOf(listOf("./a", "one"), listOf("./b", "two"), listOf("c"), listOf("d"), listOf("e"))
        assertEquals(seen + listOf(listOf("f", "g#h")), words(block))
    }

    @Test
    fun `a line goes on behind a backslash, and quotation marks hold a word together`() {
        val block = "run 'a[0]={\"b\":\"c d\"}' \\\n    --set \"e f\"'g'h\\ i ''"
        assertEquals(listOf(listOf("run", "a[0]={\"b\":\"c d\"}", "--set", "e fgh i", "")), words(block))
        assertThrows<IllegalArgumentException> { words("run 'a\n./b") }
    }

    @Test
    fun `a variable has the value that it got`() {
        val block = "N=3\nM=4; run --steps \$N \"\$M of \$N\" '\$N' \$HOME/\$ \$(count x)"
        val seen = listOf("run", "--steps", "3", "4 of 3", "\$N", "\$HOME/\$", "\$")
        assertEquals(listOf(seen, listOf("count", "x")), words(block))
    }

    @Test
    fun `files that take the output are no words`() {
        val commands = shellCommands("a b > c.json 2>&1\nd 2>>e f\nsource <(g h)\ni < j k")
        assertEquals(listOf("a b", "d f", "source", "g h", "i k"), commands.map { "$it" })
        assertEquals(listOf("c.json", "e", null, null, "j"), commands.map { it.output })
    }
}
