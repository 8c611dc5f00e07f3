package daphnis.core.format

import java.io.IOException
import java.io.Reader
import java.nio.charset.CharacterCodingException
import java.nio.file.Path

/**
 * The lines of a text file with any content. A line longer than [longest] characters is refused before it is held in
 * memory, and so are bytes that are not UTF-8 text. Lines end as those of [java.io.BufferedReader] do. A mark of UTF-8 at
 * the beginning is no part of the first; what gzip packed is unpacked.
 */
internal class TextLines(private val path: Path, private val longest: Int = LONGEST) : AutoCloseable {
    private val input: Reader = PackedFile.reader(path)
    private val text = StringBuilder()

    /** Size of the file in bytes; of a packed one, the most it can be unpacked. */
    val bytes: Long = PackedFile.mostBytes(path)

    /** Number of the line that [next] returned last, from 1. */
    var number = 0
        private set

    private var afterReturn = false

    /**
     * The next line without its end, null at the end of the file.
     *
     * @throws FormatException for a line that is too long or not text
     */
    fun next(): String? {
        text.setLength(0)
        number++
        try {
            while (true) {
                val c = input.read()
                if (c == MARK && number == 1 && text.isEmpty()) continue
                if (c < 0) return if (text.isEmpty()) null else text.toString()
                val isSecondOfPair = afterReturn && c == '\n'.code
                afterReturn = c == '\r'.code
                if (isSecondOfPair) continue
                if (c == '\n'.code || afterReturn) return text.toString()
                if (text.length == longest) fail("the line is longer than $longest characters")
                text.append(c.toChar())
            }
        } catch (e: CharacterCodingException) {
            throw FormatException("$path: is not UTF-8 text")
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        }
    }

    fun fail(problem: String): Nothing = throw FormatException("$path:$number: $problem")

    override fun close() {
        input.close()
    }

    companion object {
        const val LONGEST = 1 shl 20

        /** [word], shortened for a message. */
        fun shown(word: String): String = word.take(MOST_SHOWN)

        private const val MOST_SHOWN = 40

        /** With which some programs begin UTF-8. */
        private const val MARK = 0xFEFF
    }
}
