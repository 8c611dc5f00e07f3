package daphnis.app.printing

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.io.ByteArrayOutputStream
import java.io.PrintStream

/** Each way of text out of the program shows what a terminal would obey. */
class PrintingTest {
    private val hostile = "a\u001b[2Jb\u009bc"

    private fun printed(print: () -> Unit): String {
        val bytes = ByteArrayOutputStream()
        val streams = System.out to System.err
        PrintStream(bytes, true, Charsets.UTF_8).let {
            System.setOut(it)
            System.setErr(it)
        }
        try {
            print()
        } finally {
            System.setOut(streams.first)
            System.setErr(streams.second)
        }
        return bytes.toString(Charsets.UTF_8)
    }

    @Test
    fun `no way out of the program lets control characters through`() {
        val ways = listOf(
            { printLine(hostile) },
            { printLines("one\n$hostile") },
            { warn(hostile) },
            { showTrace(IllegalStateException(hostile)) },
            { Overwritten.OUTPUT.show(hostile, 10, 80) },
            { Overwritten.ERRORS.show(hostile, 10, 80) },
        )
        for ((k, way) in ways.withIndex()) {
            val text = printed(way)
            assertTrue(text.none { it.isISOControl() && it !in "\r\n\t" }) { "$k: ${text.map { it.code }}" }
            assertTrue("a\\u001b[2Jb\\u009bc" in text) { "$k: $text" }
        }
    }
}
