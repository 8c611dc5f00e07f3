package daphnis.analysis.movie

import daphnis.analysis.plot.ScaleBar
import daphnis.analysis.plot.Ticks
import daphnis.analysis.table.UnitNames
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.image.BufferedImage
import kotlin.math.roundToInt

/**
 * The strip below each frame: the time, a bar that tells lengths, and what the colours stand for; one below the other
 * where the frame is narrow. The whole frame has an even height.
 */
internal class Legend(private val scene: Scene) {
    private val view = scene.view
    private val size = (view.width / 60f).coerceIn(11f, 24f)
    private val font = Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size)
    private val row = (3.6f * size).roundToInt()
    private val isNarrow = view.width < 40 * size
    private val margin = size.roundToInt()

    /** In pixels. */
    val height: Int = (if (isNarrow) 2 * row else row).let { it + (it + view.height) % 2 }

    /** What was done to the shape of the box, if anything. */
    val remark: String? = when {
        view.enlargedUp > 1 -> "vertical × ${view.enlargedUp}"
        view.enlargedAcross > 1 -> "horizontal × ${view.enlargedAcross}"
        else -> null
    }

    fun paint(image: BufferedImage, clock: String, map: ColourMap) {
        val g = image.createGraphics()
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON)
        g.font = font
        g.color = Color(GROUND)
        g.fillRect(0, view.height, view.width, height)
        g.color = Color.WHITE
        val end = if (isNarrow) view.width - margin else view.width / 2
        val words = words(g, end)
        clock(g, clock, words, view.height)
        val texts = maxOf(g.fontMetrics.stringWidth(words), g.fontMetrics.stringWidth(clock))
        val behind = minOf(2 * margin + texts, end - (LEAST_BAR * size).roundToInt())
        scaleBar(g, maxOf(if (isNarrow) view.width / 2 else view.width / 4, behind), end, view.height)
        if (isNarrow) {
            colourBar(g, map, margin, view.width - margin, view.height + row)
        } else {
            colourBar(g, map, view.width / 2 + margin, view.width - margin, view.height)
        }
        g.dispose()
    }

    /** From where the view is, and the [remark]; that alone where both leave no room for a bar before [end]. */
    private fun words(g: Graphics2D, end: Int): String {
        val from = if (scene.options.view == MovieView.TOP) "from above" else "from the side"
        val words = listOfNotNull(from, remark).joinToString(", ")
        val fits = 2 * margin + g.fontMetrics.stringWidth(words) + LEAST_BAR * size <= end
        return if (fits) words else remark ?: from
    }

    private fun clock(g: Graphics2D, clock: String, words: String, top: Int) {
        g.drawString(clock, margin.toFloat(), top + LINE_1 * size)
        g.color = Color(QUIET)
        g.drawString(words, margin.toFloat(), top + LINE_2 * size)
        g.color = Color.WHITE
    }

    /** A bar from [x] on, which ends before [end]. */
    private fun scaleBar(g: Graphics2D, x: Int, end: Int, top: Int) {
        val room = minOf(view.width / 5, end - x) / view.scaleX
        val length = ScaleBar.length(minOf(view.window.across, room * 5))
        val y = top + (LINE_2 * size).roundToInt()
        val text = ScaleBar.text(length, scene.scale.units.length)
        val from = minOf(x, end + margin - g.fontMetrics.stringWidth(text))
        g.drawString(text, from.toFloat(), top + LINE_1 * size)
        g.fillRect(from, y - margin / 2, maxOf(1, (length * view.scaleX).roundToInt()), maxOf(2, margin / 5))
    }

    private fun colourBar(g: Graphics2D, map: ColourMap, left: Int, right: Int, top: Int) {
        val (name, factor) = meaning()
        g.drawString(name, left.toFloat(), top + LINE_1 * size)
        val start = left + g.fontMetrics.stringWidth(name) + margin
        if (scene.options.colour == MovieColour.MATERIAL) return swatches(g, map, start, right, top)
        val range = scene.colours
        val bottom = top + (LINE_1 * size).roundToInt()
        if (!(range.low < range.high)) {
            g.color = Color(map.rgb(range.place(range.low)))
        }
        for (x in start until right) {
            if (range.low < range.high) g.color = Color(map.rgb((x - start) / (right - start - 1.0)))
            g.fillRect(x, bottom - (BAR * size).roundToInt(), 1, (BAR * size).roundToInt())
        }
        g.color = Color.WHITE
        val shown = ColourRange(range.low * factor, range.high * factor, range.isLogarithmic)
        val ticks = if (shown.isLogarithmic) {
            Ticks.logarithmic(shown.low, shown.high)
        } else {
            Ticks.linear(shown.low, shown.high, TICKS)
        }
        val labels = ticks.places.zip(ticks.labels) { value, label ->
            val x = start + (shown.place(value) * (right - start - 1)).roundToInt()
            val width = g.fontMetrics.stringWidth(label)
            val from = (x - width / 2).coerceIn(left, right - width)
            Label(label, x, from, from + width)
        }
        for (label in labels) g.fillRect(label.mark, bottom, 1, margin / 3)
        for (label in evenly(labels)) g.drawString(label.text, label.from.toFloat(), top + LINE_2 * size)
    }

    /** A square of the colour of each material with its name, in two lines; names are cut where there is no room. */
    private fun swatches(g: Graphics2D, map: ColourMap, left: Int, right: Int, top: Int) {
        val names = scene.materials.values
        val side = (BAR * size).roundToInt()
        val places = (names.maxOfOrNull { it.length } ?: 0).downTo(0).asSequence()
            .map { most -> flow(g, names.map { cut(it, most) }, left, right, side) }
            .run { firstOrNull { swatches -> swatches.all { it.line < 2 } } ?: last() }
        for ((place, number) in places.zip(scene.materials.keys)) {
            val base = top + (if (place.line == 0) LINE_1 else LINE_2) * size
            g.color = Color(map.rgb(scene.colours.place(number.toDouble())))
            g.fillRect(place.x, (base - side).roundToInt(), side, side)
            g.color = Color.WHITE
            g.drawString(place.text, (place.x + side + margin / 3).toFloat(), base)
        }
    }

    private class Swatch(val text: String, val x: Int, val line: Int)

    private fun flow(g: Graphics2D, texts: List<String>, left: Int, right: Int, side: Int): List<Swatch> {
        var x = left
        var line = 0
        return texts.map { text ->
            val width = side + margin / 3 + g.fontMetrics.stringWidth(text)
            if (x > left && x + width > right) {
                x = left
                line++
            }
            Swatch(text, x, if (x + width > right) 2 else line).also { x += width + margin }
        }
    }

    private fun cut(name: String, most: Int) = when {
        name.length <= most -> name
        most == 0 -> ""
        else -> name.take(most) + "…"
    }

    private class Label(val text: String, val mark: Int, val from: Int, val to: Int)

    /** Every label, or every second one and so on, with room between them. */
    private fun evenly(labels: List<Label>): List<Label> = generateSequence(1) { it + 1 }
        .map { stride -> labels.filterIndexed { k, _ -> k % stride == 0 } }
        .first { some -> some.zipWithNext().all { (a, b) -> a.to + margin / 2 <= b.from } }

    /** What the colours stand for, and by what its numbers are multiplied to be in that unit. */
    private fun meaning(): Pair<String, Double> {
        val scale = scene.scale
        return when (scene.options.colour) {
            MovieColour.SPEED -> UnitNames.axis("speed", scale.speedName) to 1 / scale.speed
            MovieColour.SPIN -> UnitNames.axis("spin", scale.spinName) to 1 / scale.spin
            MovieColour.SIZE -> UnitNames.axis("radius", scale.units.length) to 1.0
            MovieColour.HEIGHT -> UnitNames.axis("z", scale.units.length) to 1.0
            MovieColour.MATERIAL -> "material" to 1.0
            MovieColour.DENSITY -> UnitNames.axis("surface density", scale.units.surfaceDensity) to 1.0
        }
    }

    companion object {
        /** Behind the strip. */
        const val GROUND = 0x20242c
        private const val QUIET = 0xb8bcc4

        /** Base lines and the height of the colour bar, in sizes of the font. */
        private const val LINE_1 = 1.45f
        private const val LINE_2 = 2.95f
        private const val BAR = 0.8f

        /** Room for the bar that tells lengths and for what stands above it, in sizes of the font. */
        private const val LEAST_BAR = 5
        private const val TICKS = 6
    }
}
