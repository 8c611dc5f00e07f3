package daphnis.analysis.movie

import java.awt.image.BufferedImage
import java.io.Closeable
import java.nio.file.Path

/** A file that takes the frames of a movie, one after the other. */
internal interface MovieFile : Closeable {
    /** Adds [image], which may be painted over afterwards. @throws IOException when it cannot be written */
    fun add(image: BufferedImage)

    /** Writes what comes after the last frame. @throws IOException when it cannot be written */
    fun finish()
}

/**
 * A format of movies.
 *
 * @property extension of the names of its files
 */
public enum class MovieFormat(public val extension: String) {
    /** Animated GIF: everywhere, in 256 colours, repeated for ever. */
    GIF("gif"),

    /** H.264 in MP4: a fraction of the size. */
    MP4("mp4"),
    ;

    internal fun open(path: Path, width: Int, height: Int, framesPerSecond: Double): MovieFile = when (this) {
        GIF -> GifFile(path, width, height, framesPerSecond)
        MP4 -> Mp4File(path, width, height, framesPerSecond)
    }

    /**
     * The rate at which a file of this format shows frames which are wanted at [framesPerSecond]: that of a GIF is at
     * most 50, since programs show faster ones at 10.
     */
    public val mostFramesPerSecond: Double get() = if (this == GIF) MOST_OF_GIF else MovieOptions.MOST_RATE

    public companion object {
        private const val MOST_OF_GIF = 50.0

        /** The format of [path] by the ending of its name; null when it is none. */
        @JvmStatic
        public fun of(path: Path): MovieFormat? {
            val name = "${path.fileName}".lowercase()
            return entries.find { name.endsWith(".${it.extension}") }
        }
    }
}
