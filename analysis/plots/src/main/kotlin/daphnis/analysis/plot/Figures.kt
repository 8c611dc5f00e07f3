package daphnis.analysis.plot

import daphnis.core.format.WholeFile
import org.apache.batik.transcoder.SVGAbstractTranscoder
import org.apache.batik.transcoder.TranscoderInput
import org.apache.batik.transcoder.TranscoderOutput
import org.apache.batik.transcoder.image.PNGTranscoder
import org.jetbrains.letsPlot.Figure
import org.jetbrains.letsPlot.awt.plot.PlotSvgExport
import org.jetbrains.letsPlot.intern.toSpec
import java.io.StringReader
import java.nio.file.Files
import java.nio.file.Path

/** Figures as files; needs no display. */
internal object Figures {
    const val INK = "#1f4e79"
    const val ACCENT = "#b3541e"
    const val QUIET = "#7a7a7a"
    const val TEXT = "#333333"
    const val LINE = 0.9

    /**
     * Colours of curves, first to last: told apart by the colour-blind (after Okabe & Ito) and, since each of the first
     * four is lighter than the one before, in grey too; none so light that it is lost on white. Curves differ in
     * [LINES] and [SHAPES] as well.
     */
    val COLOURS = listOf("#00355f", "#9c2f6b", "#c8571b", "#3a96d0", "#000000", "#5f7a00", "#7a5cc2", "#8a6d3b")

    /**
     * Solid, dashed, dots and dashes, long dashes, long and short ones, dotted, which is faint; then the first two
     * again. Numbers are lets-plot's.
     */
    val LINES = listOf(1, 2, 4, 5, 6, 3, 1, 2)

    /** Disc, triangle, square, rhombus, ring, cross, open square and triangle. */
    val SHAPES = listOf(16, 17, 15, 18, 1, 4, 0, 2)

    fun svg(figure: Figure): String = PlotSvgExport.buildSvgImageFromRawSpecs(figure.toSpec())

    fun png(svg: String, width: Int, height: Int): ByteArray {
        val transcoder = PNGTranscoder()
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_WIDTH, (width * PNG_SCALE).toFloat())
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_HEIGHT, (height * PNG_SCALE).toFloat())
        val bytes = java.io.ByteArrayOutputStream()
        transcoder.transcode(TranscoderInput(StringReader(svg)), TranscoderOutput(bytes))
        return bytes.toByteArray()
    }

    /** Writes `name.svg` and `name.png` into [directory], which is made; the SVG. */
    fun write(figure: Figure, directory: Path, name: String, width: Int, height: Int): String {
        val svg = svg(figure)
        Files.createDirectories(directory)
        WholeFile.write(directory.resolve("$name.svg"), svg)
        WholeFile.write(directory.resolve("$name.png"), png(svg, width, height))
        return svg
    }

    private const val PNG_SCALE = 2
}
