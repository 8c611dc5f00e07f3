package daphnis.analysis.plot

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

    /** Distinct and readable on white, also for the colour-blind (Okabe & Ito). */
    val COLOURS = listOf("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000")

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
        Files.writeString(directory.resolve("$name.svg"), svg)
        Files.write(directory.resolve("$name.png"), png(svg, width, height))
        return svg
    }

    private const val PNG_SCALE = 2
}
