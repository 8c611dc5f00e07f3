package daphnis.analysis.plot

import daphnis.core.format.WholeFile
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Figures as files in [directory], each an SVG and a PNG of the same name. Where this Java cannot draw, as one without
 * fonts, there are no PNGs, and [missing] says why: an SVG needs neither.
 */
internal class PictureFiles(private val directory: Path) {
    /** Why there are no PNGs; null while there are. */
    var missing: String? = null
        private set

    /** Writes `NAME.svg` and `NAME.png`; the directory is made. @return the SVG */
    @Throws(IOException::class)
    fun write(figure: Figure, name: String, width: Int = Chart.WIDTH, height: Int = Chart.HEIGHT): String {
        Files.createDirectories(directory)
        val svg = Figures.svg(figure, width, height)
        WholeFile.write(directory.resolve("$name.svg"), svg)
        if (missing != null) return svg
        try {
            WholeFile.write(directory.resolve("$name.png"), Figures.png(figure, width, height))
        } catch (e: IllegalStateException) {
            missing = e.message
        }
        return svg
    }
}
