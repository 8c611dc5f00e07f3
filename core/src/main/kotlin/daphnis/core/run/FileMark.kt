package daphnis.core.run

import daphnis.core.format.reasonOf
import kotlinx.serialization.Serializable
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32C

/**
 * What a checkpoint knows of a file or of its beginning: [length] in bytes, and [checksum], the CRC-32C of these bytes,
 * which is null in checkpoints of format 2.
 */
@Serializable
internal class FileMark(val length: Long, val checksum: Long? = null) {
    /**
     * Why the beginning of [path] does not agree with this mark, or null when it does; [whole] when the file must end
     * there.
     *
     * @param taken called with the beginning when it is right
     */
    fun problem(path: Path, whole: Boolean = false, taken: (Beginning) -> Unit = {}): String? = try {
        val size = if (Files.exists(path)) Files.size(path) else -1
        if (size < 0) {
            "is missing"
        } else if (size < length || whole && size != length) {
            "has $size bytes where the run wrote $length"
        } else {
            val beginning = Beginning.of(path, length)
            if (checksum == null || beginning.checksum.value == checksum) {
                taken(beginning)
                null
            } else {
                "is not what the run wrote: its checksum is wrong"
            }
        }
    } catch (e: IOException) {
        "cannot be read: ${reasonOf(e, path)}"
    }

    companion object {
        /** The mark of a file that consists of [bytes]. */
        fun of(bytes: ByteArray) = FileMark(bytes.size.toLong(), CRC32C().apply { update(bytes) }.value)
    }
}

/** The first [length] bytes of a file, and their CRC-32C, to continue from. */
internal class Beginning(val length: Long, val checksum: CRC32C) {
    companion object {
        /** Reads [length] bytes of [path], or as many as there are. */
        fun of(path: Path, length: Long): Beginning {
            val checksum = CRC32C()
            var left = length
            Files.newInputStream(path).use { input ->
                val block = ByteArray(BLOCK)
                while (left > 0) {
                    val n = input.read(block, 0, minOf(left, block.size.toLong()).toInt())
                    if (n < 0) break
                    checksum.update(block, 0, n)
                    left -= n
                }
            }
            return Beginning(length - left, checksum)
        }

        private const val BLOCK = 1 shl 16
    }
}
