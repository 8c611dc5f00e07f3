package daphnis.core.format

import java.io.IOException
import java.io.InputStream
import java.io.InputStreamReader
import java.io.Reader
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import kotlin.io.path.name

/**
 * Reads files as they are, or as they were before gzip packed them: two bytes at the beginning tell. Their names end
 * with `.gz`, behind the ending of their format.
 */
public object PackedFile {
    /** The end of the names of such files. */
    public const val ENDING: String = ".gz"

    /** How much longer a file can be than its packed form: the bound of deflate, with a margin. */
    private const val DENSEST = 1100L
    private const val BUFFER = 1 shl 16

    /** The name of [path] without [ENDING]. */
    @JvmStatic
    public fun plainName(path: Path): String = path.name.let {
        if (it.endsWith(ENDING, ignoreCase = true)) it.dropLast(ENDING.length) else it
    }

    /** Whether gzip packed [path]. */
    @JvmStatic
    @Throws(IOException::class)
    public fun isPacked(path: Path): Boolean {
        val head = Files.newInputStream(path).use { it.readNBytes(2) }
        return head.size == 2 && head[0] == 0x1f.toByte() && head[1] == 0x8b.toByte()
    }

    /** The bytes of [path], unpacked. */
    @JvmStatic
    @Throws(IOException::class)
    public fun open(path: Path): InputStream {
        val isPacked = isPacked(path)
        val file = Files.newInputStream(path)
        return try {
            if (isPacked) GZIPInputStream(file, BUFFER) else file
        } catch (e: IOException) {
            file.close()
            throw e
        }
    }

    /** [path], unpacked, as UTF-8; bytes that are none are an [IOException]. */
    internal fun reader(path: Path): Reader = InputStreamReader(open(path), Charsets.UTF_8.newDecoder()).buffered()

    /**
     * The text of [path], unpacked, in UTF-8 with or without a mark at its beginning.
     *
     * @throws IOException when it cannot be read, is not UTF-8, or is longer than [longest] bytes
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun text(path: Path, longest: Int = Int.MAX_VALUE - 8): String {
        val bytes = bytes(path, longest)
        return Charsets.UTF_8.newDecoder().decode(java.nio.ByteBuffer.wrap(bytes)).toString().removePrefix(MARK)
    }

    /** The bytes of [path], unpacked. @throws IOException when they are more than [longest] */
    internal fun bytes(path: Path, longest: Int): ByteArray = open(path).use { input ->
        input.readNBytes(longest).also { if (input.read() >= 0) throw IOException("it is longer than $longest bytes") }
    }

    /** The most bytes that [path] can have, unpacked. */
    internal fun mostBytes(path: Path): Long = Files.size(path).let { if (isPacked(path)) it * DENSEST else it }

    /** Some programs mark UTF-8 with this letter at the beginning. */
    private const val MARK = "\uFEFF"
}
