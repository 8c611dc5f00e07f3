package daphnis.analysis.plot

import java.awt.BasicStroke
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.geom.Line2D
import java.awt.geom.Path2D
import java.awt.image.BufferedImage

/** Where text stands against its point. */
internal enum class Anchor(val svg: String, val before: Double) {
    START("start", 0.0),
    MIDDLE("middle", 0.5),
    END("end", 1.0),
}

/** A white sheet to draw on, in points from its upper left corner. */
internal interface Sheet {
    fun line(x1: Double, y1: Double, x2: Double, y2: Double, colour: String, width: Double)

    /** A line through the points ([x], [y]), of which there are two or more. */
    fun path(x: DoubleArray, y: DoubleArray, colour: String, width: Double)

    /** Text in one line with its base line through ([x], [y]); [upright] text runs upwards. */
    fun text(text: String, x: Double, y: Double, size: Int, anchor: Anchor, upright: Boolean = false)
}

/** A sheet that becomes an SVG document. */
internal class SvgSheet(width: Int, height: Int) : Sheet {
    private val out = StringBuilder(
        """<svg xmlns="http://www.w3.org/2000/svg" width="$width" height="$height" viewBox="0 0 $width $height" """ +
            """font-family="Helvetica, Arial, sans-serif">""",
    ).append("\n<rect width=\"$width\" height=\"$height\" fill=\"#ffffff\"/>\n")

    override fun line(x1: Double, y1: Double, x2: Double, y2: Double, colour: String, width: Double) {
        path(doubleArrayOf(x1, x2), doubleArrayOf(y1, y2), colour, width)
    }

    override fun path(x: DoubleArray, y: DoubleArray, colour: String, width: Double) {
        out.append("<path fill=\"none\" stroke=\"").append(colour)
        out.append("\" stroke-width=\"").append(width).append("\" stroke-linejoin=\"round\" d=\"")
        for (k in x.indices) {
            val command = if (k == 0) 'M' else 'L'
            out.append(command).append(hundredths(x[k])).append(' ').append(hundredths(y[k]))
        }
        out.append("\"/>\n")
    }

    override fun text(text: String, x: Double, y: Double, size: Int, anchor: Anchor, upright: Boolean) {
        val place = "${hundredths(x)} ${hundredths(y)}"
        val turn = if (upright) " rotate(-90)" else ""
        out.append(
            "<text transform=\"translate($place)$turn\" font-size=\"$size\" " +
                "text-anchor=\"${anchor.svg}\" fill=\"${Figures.TEXT}\">",
        )
        for (c in text) {
            when (c) {
                '<' -> out.append("&lt;")
                '>' -> out.append("&gt;")
                '&' -> out.append("&amp;")
                // Control characters and the last two of 16 bits are not allowed in XML at all.
                else -> out.append(if (c < ' ' || c >= '\uFFFE') ' ' else c)
            }
        }
        out.append("</text>\n")
    }

    private fun hundredths(v: Double): Double = Math.rint(v * 100) / 100

    override fun toString(): String = "$out</svg>\n"
}

/** A sheet that becomes a picture of [scale] pixels a point. Needs no display. */
internal class ImageSheet(width: Int, height: Int, scale: Int) : Sheet {
    val image = BufferedImage(width * scale, height * scale, BufferedImage.TYPE_INT_RGB)
    private val graphics: Graphics2D = image.createGraphics()

    init {
        graphics.color = Color.WHITE
        graphics.fillRect(0, 0, image.width, image.height)
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE)
        graphics.scale(scale.toDouble(), scale.toDouble())
    }

    override fun line(x1: Double, y1: Double, x2: Double, y2: Double, colour: String, width: Double) {
        pen(colour, width)
        graphics.draw(Line2D.Double(x1, y1, x2, y2))
    }

    override fun path(x: DoubleArray, y: DoubleArray, colour: String, width: Double) {
        pen(colour, width)
        val path = Path2D.Double()
        path.moveTo(x[0], y[0])
        for (k in 1 until x.size) path.lineTo(x[k], y[k])
        graphics.draw(path)
    }

    private fun pen(colour: String, width: Double) {
        graphics.color = Color.decode(colour)
        graphics.stroke = BasicStroke(width.toFloat(), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND)
    }

    override fun text(text: String, x: Double, y: Double, size: Int, anchor: Anchor, upright: Boolean) {
        graphics.color = Color.decode(Figures.TEXT)
        graphics.font = Font(Font.SANS_SERIF, Font.PLAIN, size)
        val before = graphics.transform
        graphics.translate(x, y)
        if (upright) graphics.rotate(-Math.PI / 2)
        graphics.drawString(text, (-anchor.before * graphics.fontMetrics.stringWidth(text)).toFloat(), 0f)
        graphics.transform = before
    }
}
