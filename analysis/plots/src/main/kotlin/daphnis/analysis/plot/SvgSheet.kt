package daphnis.analysis.plot

import daphnis.core.input.oneLine

/** A sheet that becomes an SVG document. The same drawing gives the same bytes. */
internal class SvgSheet(width: Int, height: Int) : Sheet {
    private val out = StringBuilder(
        """<svg xmlns="http://www.w3.org/2000/svg" width="$width" height="$height" viewBox="0 0 $width $height" """ +
            """font-family="Helvetica, Arial, sans-serif">""",
    ).append("\n<rect width=\"$width\" height=\"$height\" fill=\"#ffffff\"/>\n")

    override fun line(x1: Double, y1: Double, x2: Double, y2: Double, colour: String, width: Double) {
        path(doubleArrayOf(x1, x2), doubleArrayOf(y1, y2), colour, width)
    }

    override fun path(x: DoubleArray, y: DoubleArray, colour: String, width: Double, dashes: Dashes?) {
        out.append("<path fill=\"none\" stroke=\"").append(colour)
        out.append("\" stroke-width=\"").append(width).append("\" stroke-linejoin=\"round\"")
        if (dashes != null) {
            val lengths = dashes.lengths.joinToString(" ") { "${hundredths(it * width)}" }
            out.append(" stroke-dasharray=\"").append(lengths).append('"')
        }
        points(x, y)
        out.append("\"/>\n")
    }

    override fun area(x: DoubleArray, y: DoubleArray, colour: String) {
        out.append("<path fill=\"").append(colour).append('"')
        points(x, y)
        out.append("Z\"/>\n")
    }

    private fun points(x: DoubleArray, y: DoubleArray) {
        out.append(" d=\"")
        for (k in x.indices) {
            val command = if (k == 0) 'M' else 'L'
            out.append(command).append(hundredths(x[k])).append(' ').append(hundredths(y[k]))
        }
    }

    override fun disc(x: Double, y: Double, r: Double, colour: String, width: Double?) {
        out.append("<circle cx=\"").append(hundredths(x)).append("\" cy=\"").append(hundredths(y))
        out.append("\" r=\"").append(hundredths(r)).append("\" fill=\"").append(if (width == null) colour else "none")
        if (width != null) out.append("\" stroke=\"").append(colour).append("\" stroke-width=\"").append(width)
        out.append("\"/>\n")
    }

    override fun tile(x: Double, y: Double, width: Double, height: Double, colour: String) {
        out.append("<rect x=\"").append(hundredths(x)).append("\" y=\"").append(hundredths(y))
        out.append("\" width=\"").append(hundredths(width)).append("\" height=\"").append(hundredths(height))
        out.append("\" fill=\"").append(colour).append("\" shape-rendering=\"crispEdges\"/>\n")
    }

    override fun text(text: String, x: Double, y: Double, size: Int, anchor: Anchor, upright: Boolean) {
        val place = "${hundredths(x)} ${hundredths(y)}"
        val turn = if (upright) " rotate(-90)" else ""
        out.append(
            "<text transform=\"translate($place)$turn\" font-size=\"$size\" " +
                "text-anchor=\"${anchor.svg}\" fill=\"${Figures.TEXT}\">",
        )
        for (c in oneLine(text)) {
            when (c) {
                '<' -> out.append("&lt;")
                '>' -> out.append("&gt;")
                '&' -> out.append("&amp;")
                // The last two of 16 bits are not allowed in XML at all, as control characters are not.
                else -> out.append(if (c >= '\uFFFE') ' ' else c)
            }
        }
        out.append("</text>\n")
    }

    private fun hundredths(v: Double): Double = Math.rint(v * 100) / 100

    override fun toString(): String = "$out</svg>\n"
}
