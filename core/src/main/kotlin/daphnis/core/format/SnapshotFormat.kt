package daphnis.core.format

import daphnis.core.boundary.Open
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.name

/**
 * The formats that states of particles are read from: one list for what a scenario starts from and for what is
 * analysed.
 *
 * @property title what the format is called
 * @property extensions endings of file names, without the dot, lower case; the first is the one we would give
 */
public enum class SnapshotFormat(public val title: String, public val extensions: List<String>) {
    H5MD("H5MD", listOf("h5", "h5md")),
    EXTENDED_XYZ("extended XYZ", listOf("xyz", "extxyz")),
    CART_AND_RAD("CartAndRad", listOf("bin", "cartandrad")),
    CSV("table with a header", listOf("csv", "txt", "dat")),
    ;

    /**
     * Reads every frame of [path], in the order of the file. Where it has no masses ([Snapshot.hasMass]) they stand in
     * for density 1, or are 1 each in extended XYZ.
     *
     * @throws FormatException for what is wrong, in one line
     */
    public fun read(path: Path): List<Snapshot> = try {
        when (this) {
            H5MD -> H5md.read(path)
            EXTENDED_XYZ -> ExtendedXyz.read(path)
            CART_AND_RAD -> {
                val frame = Snapshot.of(CartAndRad.read(path), Open, 0, 0.0, hasMass = false)
                SnapshotCheck.check(frame, "$path")
                listOf(frame)
            }
            CSV -> listOf(ParticleCsv.frame(path))
        }
    } catch (e: IOException) {
        throw FormatException("$path: cannot be read: ${e.message}")
    }

    public companion object {
        /** All formats and their endings, for help and messages. */
        public val known: String = entries.joinToString { format ->
            "${format.extensions.joinToString(" ") { ".$it" }} (${format.title})"
        }

        /**
         * The format of [path] by its name: its ending, or `CartAndRad` anywhere in it, as SwiftVis names its files.
         *
         * @throws FormatException when no format has such names
         */
        public fun of(path: Path): SnapshotFormat {
            val name = path.name.lowercase()
            val ending = name.substringAfterLast('.', "")
            val found = entries.find { ending in it.extensions }
            if ("cartandrad" in name && ending != found?.extensions?.first()) return CART_AND_RAD
            return found ?: throw FormatException("$path: unknown format; known by the end of the name: $known")
        }
    }
}
