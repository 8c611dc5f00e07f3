package daphnis.core.format

import java.io.IOException
import java.nio.file.Path

/** The list of formats from which a scenario starts, which are analysed, and to which snapshots are exported. */
public object SnapshotFormats {
    @JvmStatic
    public val all: List<SnapshotFormat> = listOf(
        ExtendedXyz,
        Vtp,
        H5md,
        CartAndRad,
        LammpsDump,
        LammpsData,
        ParticleCsv,
    )

    @JvmStatic
    public val readable: List<ReadableFormat> = all.filterIsInstance<ReadableFormat>()

    @JvmStatic
    public val writable: List<WritableFormat> = all.filterIsInstance<WritableFormat>()

    /**
     * The format whose [word][WritableFormat.word] is [word], such as `xyz`.
     *
     * @throws FormatException when none has it
     */
    @JvmStatic
    public fun named(word: String): WritableFormat = writable.find { it.word == word }
        ?: throw FormatException("$word: unknown format; known: ${writable.joinToString { it.word }}")

    /** All formats that are read and their endings, for help and messages. */
    @JvmStatic
    public val known: String = readable.joinToString { format ->
        "${format.extensions.joinToString(" ") { ".$it" }} (${format.title})"
    }

    /**
     * The format of [path] by its name, without `.gz` at its end ([PackedFile]): by its ending, or by a [ReadableFormat.mark] anywhere in it unless the ending
     * is the preferred one of a format; else by a [ReadableFormat.prefix].
     *
     * @throws FormatException when no format has such a name
     */
    @JvmStatic
    public fun of(path: Path): ReadableFormat {
        val name = PackedFile.plainName(path).lowercase()
        val ending = name.substringAfterLast('.', "")
        val byEnding = readable.find { ending in it.extensions }
        if (byEnding != null && ending == byEnding.extensions.first()) return byEnding
        val byMark = readable.find { format -> format.mark?.let { it in name } == true }
        return byMark ?: byEnding ?: readable.find { format -> format.prefix?.let { name.startsWith(it) } == true }
            ?: throw FormatException("$path: unknown format; known by the end of the name: $known")
    }

    /**
     * Reads every state of [path], of any readable format, in the order of the file.
     *
     * @throws FormatException for what is wrong, in one line
     */
    @JvmStatic
    public fun read(path: Path): List<Snapshot> = read(path, ArrayList())

    /**
     * The same.
     *
     * @param notices receives what a user should know of the file although it can be read, a line each
     */
    @JvmStatic
    public fun read(path: Path, notices: MutableList<String>): List<Snapshot> = try {
        of(path).read(path, notices).also { notices += listOfNotNull(remark(path)) }
    } catch (e: IOException) {
        throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
    }

    /**
     * What a user should know of [path] although it can be read: of a text, that its last line has no end, so that its
     * last number may have been cut. Null for nothing.
     *
     * @throws FormatException when it cannot be read
     */
    @JvmStatic
    public fun remark(path: Path): String? = try {
        if (of(path).isText) TextEnd.remark(path) else null
    } catch (e: IOException) {
        throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
    }
}
