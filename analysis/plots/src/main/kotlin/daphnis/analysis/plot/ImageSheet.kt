package daphnis.analysis.plot

import java.awt.BasicStroke
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.geom.Ellipse2D
import java.awt.geom.Line2D
import java.awt.geom.Path2D
import java.awt.image.BufferedImage

/** A sheet that becomes a picture of [scale] pixels a point. Needs no display. */
internal class ImageSheet(width: Int, height: Int, private val scale: Int) : Sheet {
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

    override fun path(x: DoubleArray, y: DoubleArray, colour: String, width: Double, dashes: Dashes?) {
        pen(colour, width, dashes)
        graphics.draw(outline(x, y))
    }

    override fun area(x: DoubleArray, y: DoubleArray, colour: String) {
        graphics.color = Color.decode(colour)
        graphics.fill(outline(x, y))
    }

    private fun outline(x: DoubleArray, y: DoubleArray): Path2D {
        val path = Path2D.Double()
        path.moveTo(x[0], y[0])
        for (k in 1 until x.size) path.lineTo(x[k], y[k])
        return path
    }

    override fun disc(x: Double, y: Double, r: Double, colour: String, width: Double?) {
        val disc = Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r)
        if (width == null) {
            graphics.color = Color.decode(colour)
            graphics.fill(disc)
        } else {
            pen(colour, width)
            graphics.draw(disc)
        }
    }

    override fun tile(x: Double, y: Double, width: Double, height: Double, colour: String) {
        // Whole pixels, so that the background does not shine through between two.
        fun pixel(place: Double) = Math.rint(place * scale).toInt()
        val before = graphics.transform
        graphics.transform = IDENTITY
        graphics.color = Color.decode(colour)
        graphics.fillRect(pixel(x), pixel(y), pixel(x + width) - pixel(x), pixel(y + height) - pixel(y))
        graphics.transform = before
    }

    private fun pen(colour: String, width: Double, dashes: Dashes? = null) {
        graphics.color = Color.decode(colour)
        val lengths = dashes?.lengths?.let { all -> FloatArray(all.size) { (all[it] * width).toFloat() } }
        graphics.stroke =
            BasicStroke(width.toFloat(), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, MITER, lengths, 0f)
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

    private companion object {
        const val MITER = 10f
        val IDENTITY = java.awt.geom.AffineTransform()
    }
}
