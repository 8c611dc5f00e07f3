package daphnis.analysis.movie

import java.awt.image.BufferedImage
import java.io.Closeable
import java.io.IOException
import java.nio.file.Path

/** A file that takes the frames of a movie, one after the other. */
internal interface MovieFile : Closeable {
    /** The program or library that writes it. */
    val writer: String

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

    /** H.264 in MP4, for every browser: by the program `ffmpeg` where it is on the `PATH` and has libx264. */
    MP4("mp4"),

    /** VP9 in WebM: the smallest. By the program `ffmpeg` only, with libvpx-vp9. */
    WEBM("webm"),
    ;

    /** Whether this format can be written here. */
    public val isAvailable: Boolean get() = this != WEBM || ffmpeg("libvpx-vp9") != null

    /** @throws IOException when it cannot be written */
    internal fun open(path: Path, width: Int, height: Int, framesPerSecond: Double): MovieFile {
        fun by(program: Ffmpeg, vararg options: String) =
            FfmpegFile(program, path, width, height, framesPerSecond, options.asList())
        return when (this) {
            GIF -> GifFile(path, width, height, framesPerSecond)
            MP4 -> ffmpeg("libx264")?.let {
                by(it, "-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4")
            } ?: Mp4File.open(path, width, height, framesPerSecond)
            WEBM -> {
                val program = ffmpeg("libvpx-vp9")
                    ?: throw IOException("WebM needs the program ffmpeg with libvpx-vp9 on the PATH")
                val quality = arrayOf("-crf", "24", "-b:v", "0", "-cpu-used", "4", "-row-mt", "1")
                by(program, "-c:v", "libvpx-vp9", *quality, "-f", "webm")
            }
        }
    }

    private fun ffmpeg(encoder: String) = Ffmpeg.onPath?.takeIf { encoder in it.encoders }

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
