package daphnis.analysis.plot

import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import daphnis.core.format.WholeFile
import java.awt.Color
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.geom.Ellipse2D
import java.awt.image.BufferedImage
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import java.util.Locale

/**
 * Pictures of a patch to scale, from above (x upward, y to the right) and from the side (z upward, y to the right).
 * Spheres that stick out of a periodic face are cut there and go on at the other, images where they are at the time.
 */
internal class PatchPicture(private val state: State, private val lengthName: String) {
    private val p = state.population
    private val box = state.boundary.box

    /** A part of the plane: from and to along the horizontal (y) and the vertical axis (x or z), which is [axis]. */
    private class Window(val left: Double, val right: Double, val bottom: Double, val top: Double, val axis: Int)

    private class Disc(val x: Double, val y: Double, val r: Double, val depth: Double)

    // A patch that is very long is shown in part, as wide as can be seen.
    private val widthAbove = minOf(box.length(1), box.length(0) * LONGEST)

    /** A drum is seen along its axis, along which it may be short. */
    private val widthSide = minOf(box.length(1), maxOf(box.length(0), box.length(2)) * LONGEST)

    /** What the bar in the picture from above is long. */
    val bar: String get() = barText(ScaleBar.length(widthAbove))

    /** The same of that from the side. */
    val barSide: String get() = barText(ScaleBar.length(widthSide))

    /** Whether the picture from above shows a part of the length only. */
    val isPartAbove: Boolean get() = widthAbove < box.length(1)

    /** The same of that from the side. */
    val isPartSide: Boolean get() = widthSide < box.length(1)

    /** Writes `NAME.png` and `NAME.svg` into [directory]; the PNG. */
    fun writeAbove(directory: Path, name: String): ByteArray =
        write(Window(box.lowerY, box.lowerY + widthAbove, box.lowerX, box.upperX, 0), directory, name)

    fun writeSide(directory: Path, name: String): ByteArray {
        var extent = 0.0
        for (k in 0 until p.size) extent = maxOf(extent, Math.abs(p.z[k]) + p.radius[k])
        return write(Window(box.lowerY, box.lowerY + widthSide, -extent, extent, 2), directory, name)
    }

    private fun write(window: Window, directory: Path, name: String): ByteArray {
        val discs = discs(window).sortedBy { it.depth }
        val png = png(discs, window)
        Files.createDirectories(directory)
        WholeFile.write(directory.resolve("$name.png"), png)
        WholeFile.write(directory.resolve("$name.svg"), svg(discs, window, png))
        return png
    }

    /**
     * All discs that touch the window, images included. For the side view spheres of the front half hide those behind.
     */
    private fun discs(window: Window): List<Disc> {
        val result = ArrayList<Disc>()
        val images = PlaneImages(state.boundary, state.time)
        val fromAbove = window.axis == 0
        // Two boxes away along the slide, since images are displaced by up to one.
        val alongX = if (fromAbove && images.repeats(0)) -2..2 else 0..0
        val alongY = if (images.repeats(1)) -2..2 else 0..0
        for (k in 0 until p.size) {
            val r = p.radius[k]
            for (iy in alongY) {
                for (ix in alongX) {
                    val y = p.y[k] + images.shift(ix, iy, 1)
                    val x = p.x[k] + images.shift(ix, iy, 0)
                    val v = if (fromAbove) x else p.z[k]
                    if (y + r < window.left || y - r > window.right || v + r < window.bottom || v - r > window.top) {
                        continue
                    }
                    result += Disc(y, v, r, if (fromAbove) p.z[k] else -withinBox(x, images))
                }
            }
        }
        return result
    }

    /**
     * Seen from the side an image beyond a face in y may have slid along x, out of the box: there the next one stands
     * inside.
     */
    private fun withinBox(x: Double, images: PlaneImages): Double = if (images.repeats(0)) {
        x -
            Math.floor((x - box.lowerX) / box.length(0)) * box.length(0)
    } else {
        x
    }

    private fun png(discs: List<Disc>, window: Window): ByteArray {
        val scale = PIXELS / (window.right - window.left)
        val height = Math.ceil((window.top - window.bottom) * scale).toInt().coerceIn(1, 4 * PIXELS)
        val image = BufferedImage(PIXELS, height, BufferedImage.TYPE_INT_RGB)
        val g = image.createGraphics()
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE)
        g.color = SPACE
        g.fillRect(0, 0, PIXELS, height)
        val low = discs.minOfOrNull { it.depth } ?: 0.0
        val high = discs.maxOfOrNull { it.depth } ?: 1.0
        for (disc in discs) {
            val x = (disc.x - window.left) * scale
            val y = (window.top - disc.y) * scale
            // What is smaller than a pixel would not be seen at all.
            val r = maxOf(disc.r * scale, LEAST_PIXELS)
            g.color = shade(if (high > low) (disc.depth - low) / (high - low) else 0.5)
            g.fill(Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r))
            if (r > OUTLINED) {
                g.color = EDGE
                g.draw(Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r))
            }
        }
        scaleBar(g, window, scale, height)
        g.dispose()
        return Png.encode(image)
    }

    private fun shade(t: Double): Color {
        val f = (0.45 + 0.55 * t).toFloat()
        return Color(0.93f * f, 0.89f * f, 0.80f * f)
    }

    private fun scaleBar(g: Graphics2D, window: Window, scale: Double, height: Int) {
        if (height < LEAST_HEIGHT_OF_BAR) return
        val length = ScaleBar.length(window.right - window.left)
        val pixels = (length * scale).toInt()
        val text = barText(length)
        val width = maxOf(pixels, widthOf(text, g) ?: 0)
        g.color = Color(0, 0, 0, 190)
        g.fillRoundRect(14, height - 68, width + 28, 58, 10, 10)
        g.color = Color.WHITE
        g.fillRect(28, height - 22, pixels, 4)
        if (widthOf(text, g) != null) g.drawString(text, 28, height - 32)
    }

    /** How wide [text] will be at the bar; null where this Java has no fonts: the caption says the length too. */
    private fun widthOf(text: String, g: Graphics2D): Int? = try {
        drawing {
            g.font = g.font.deriveFont(BAR_TEXT)
            g.fontMetrics.stringWidth(text)
        }
    } catch (e: IllegalStateException) {
        null
    }

    private fun barText(length: Double) = ScaleBar.text(length, lengthName)

    /** Circles while they are few enough to be read and edited, else the picture in an SVG. */
    private fun svg(discs: List<Disc>, window: Window, png: ByteArray): String {
        val scale = PIXELS / (window.right - window.left)
        val height = (window.top - window.bottom) * scale
        fun f(v: Double) = String.format(Locale.ROOT, "%.2f", v)
        val size = "width=\"$PIXELS\" height=\"${f(height)}\""
        val head = "<svg xmlns=\"http://www.w3.org/2000/svg\" $size viewBox=\"0 0 $PIXELS ${f(height)}\">"
        if (discs.size > MOST_CIRCLES) {
            val data = Base64.getEncoder().encodeToString(png)
            return "$head<image $size href=\"data:image/png;base64,$data\"/></svg>\n"
        }
        val low = discs.minOfOrNull { it.depth } ?: 0.0
        val high = discs.maxOfOrNull { it.depth } ?: 1.0
        val circles = discs.joinToString("\n") { d ->
            val c = shade(if (high > low) (d.depth - low) / (high - low) else 0.5)
            val fill = String.format("#%02x%02x%02x", c.red, c.green, c.blue)
            val centre = "cx=\"${f((d.x - window.left) * scale)}\" cy=\"${f((window.top - d.y) * scale)}\""
            "<circle $centre r=\"${f(maxOf(d.r * scale, LEAST_PIXELS))}\" fill=\"$fill\"/>"
        }
        val ground = "<rect width=\"100%\" height=\"100%\" fill=\"#10141c\"/>"
        return "$head$ground\n$circles\n${svgBar(window, scale, height)}</svg>\n"
    }

    private fun svgBar(window: Window, scale: Double, height: Double): String {
        if (height < LEAST_HEIGHT_OF_BAR) return ""
        val length = ScaleBar.length(window.right - window.left)
        fun f(v: Double) = String.format(Locale.ROOT, "%.2f", v)
        val place = "x=\"28\" y=\"${f(height - 32)}\""
        val text = "<text $place font-family=\"sans-serif\" font-size=\"$BAR_TEXT\">${barText(length)}</text>"
        val bar = "<rect x=\"28\" y=\"${f(height - 22)}\" width=\"${f(length * scale)}\" height=\"4\"/>"
        return "<g fill=\"#ffffff\">$bar$text</g>\n"
    }

    private companion object {
        const val PIXELS = 1400
        const val LONGEST = 4.0
        const val LEAST_PIXELS = 0.7
        const val OUTLINED = 3.0
        const val MOST_CIRCLES = 6000

        /** Legible where the picture is half as wide as it has pixels, and still on a narrow screen. */
        const val BAR_TEXT = 28f
        const val LEAST_HEIGHT_OF_BAR = 140
        val SPACE = Color(0x10, 0x14, 0x1c)
        val EDGE = Color(0, 0, 0, 90)
    }
}
