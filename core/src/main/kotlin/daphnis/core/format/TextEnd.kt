package daphnis.core.format

import java.nio.file.Files
import java.nio.file.Path

/**
 * Tells of a text file that it may have been cut short within its last number, which then still is a number: programs
 * end every line, so the last one has no end. Nor has it where an editor by hand left it away, so it is no error. A last
 * line that is empty or a comment has no number.
 */
internal object TextEnd {
    /** One line about [path]; null when nothing is to be said. */
    fun remark(path: Path): String? {
        // What gzip packed says itself whether it is whole.
        if (PackedFile.isPacked(path)) return null
        val last = lastLine(path) ?: return null
        if (last.isBlank() || last.trimStart().startsWith('#')) return null
        return "$path: the last line has no end, so if the file was cut short, its last number may be wrong; " +
            "a file that is whole can be given a line end there"
    }

    /** What stands behind the last line end, or its last part if it is long; null when the file ends with a line end. */
    private fun lastLine(path: Path): String? = Files.newInputStream(path).use { file ->
        val length = Files.size(path)
        file.skipNBytes(length - minOf(length, MOST_READ))
        val tail = file.readNBytes(MOST_READ.toInt())
        if (tail.isEmpty() || tail.last().isLineEnd()) return null
        // Line ends are single bytes in UTF-8; letters that are cut or misread here do not matter.
        String(tail, tail.indexOfLast { it.isLineEnd() } + 1, tail.size - tail.indexOfLast { it.isLineEnd() } - 1)
    }

    private fun Byte.isLineEnd() = this == '\n'.code.toByte() || this == '\r'.code.toByte()

    private const val MOST_READ = 1L shl 16
}
