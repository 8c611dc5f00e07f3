package daphnis.analysis.plot

import daphnis.analysis.insitu.State
import kotlin.math.ceil

/**
 * The [discs] of a window on a sheet, nearer ones brighter, with walls that are no faces of the box, and below them a
 * strip with a bar of the length [bar] and the names of the [kinds]. The longer side of the picture has [PIXELS].
 */
internal class StateSheet(
    private val state: State,
    private val kinds: SphereKinds,
    private val window: PatchPicture.Window,
    private val across: Int,
    val discs: List<PatchPicture.Disc>,
    private val bar: String,
) {
    private val long = window.right - window.left
    private val high = window.top - window.bottom
    private val scale = PIXELS / maxOf(long, high)
    private val drawn = ceil(high * scale - ROUNDING).toInt().coerceAtLeast(1)
    val width: Int = ceil(long * scale - ROUNDING).toInt().coerceAtLeast(LEAST_WIDTH)
    private val left = (width - long * scale) / 2
    private val entries = entries()
    val height: Int = drawn + (entries.maxOf { it.line } + 1) * ROW

    /** A name in the strip, and where it stands. */
    private class Entry(val kind: Int, val x: Double, val line: Int)

    /** The bar, then a colour for each kind, in as many lines as it takes. */
    private fun entries(): List<Entry> {
        val all = arrayListOf(Entry(-1, MARGIN, 0))
        var x = 2 * MARGIN + barLength() + GAP + TEXT * TextWidth.of(bar)
        var line = 0
        for ((kind, name) in kinds.names.withIndex()) {
            val room = 2 * SWATCH + GAP + TEXT * TextWidth.of(name)
            if (x + room > width) {
                x = MARGIN
                line++
            }
            all += Entry(kind, x, line)
            x += room + MARGIN
        }
        return all
    }

    private fun barLength() = ScaleBar.length(long) * scale

    /** Without words where this Java has no fonts: the caption says the length too. */
    fun png(): ByteArray {
        fun drawn(isNamed: Boolean) = drawing {
            Png.encode(ImageSheet(width, height, 1).also { draw(it, isNamed) }.image)
        }
        return try {
            drawn(true)
        } catch (_: IllegalStateException) {
            drawn(false)
        }
    }

    fun svg(): String = SvgSheet(width, height).also { draw(it, true) }.toString()

    private fun draw(sheet: Sheet, isNamed: Boolean) {
        sheet.tile(0.0, 0.0, width.toDouble(), drawn.toDouble(), SPACE)
        walls(sheet)
        spheres(sheet)
        sheet.tile(0.0, drawn.toDouble(), width.toDouble(), height.toDouble() - drawn, STRIP)
        for (entry in entries) {
            val y = drawn + (entry.line + 0.5) * ROW
            if (entry.kind < 0) {
                sheet.tile(entry.x, y - BAR / 2, barLength(), BAR, Figures.TEXT)
                if (isNamed) sheet.text(bar, entry.x + barLength() + GAP, y + TEXT / 3.0, TEXT, Anchor.START)
            } else {
                val middle = entry.x + SWATCH
                sheet.disc(middle, y, SWATCH, kinds.colour(entry.kind))
                sheet.disc(middle, y, SWATCH, Figures.QUIET, EDGE)
                val name = kinds.names[entry.kind]
                if (isNamed) sheet.text(name, middle + SWATCH + GAP, y + TEXT / 3.0, TEXT, Anchor.START)
            }
        }
    }

    private fun spheres(sheet: Sheet) {
        val low = discs.minOfOrNull { it.depth } ?: 0.0
        val depth = (discs.maxOfOrNull { it.depth } ?: 1.0) - low
        val shades = List(maxOf(1, kinds.names.size)) { kind ->
            List(SHADES + 1) { Colours.mixed("#000000", kinds.colour(kind), DARKEST + (1 - DARKEST) * it / SHADES) }
        }
        for (disc in discs) {
            val near = if (depth > 0) (disc.depth - low) / depth else 0.5
            val colour = shades[disc.kind][(near * SHADES).toInt()]
            val (x, y) = left + (disc.x - window.left) * scale to (window.top - disc.y) * scale
            // What is smaller than a pixel would not be seen at all.
            val r = maxOf(disc.r * scale, LEAST_PIXELS)
            sheet.disc(x, y, r, colour)
            if (r > OUTLINED) sheet.disc(x, y, r, Colours.mixed(colour, SPACE, OUTLINE), EDGE)
        }
        // What sticks out of the window at the sides of a narrow one.
        if (left <= 0) return
        sheet.tile(0.0, 0.0, left, drawn.toDouble(), STRIP)
        sheet.tile(width - left, 0.0, left, drawn.toDouble(), STRIP)
    }

    private fun walls(sheet: Sheet) {
        val cut = WallCut(state, across, window.up)
        if (cut.isEmpty) return
        fun isBehind(column: Int, row: Int) =
            cut.isBehind(window.left + (column + 0.5) * STEP / scale, window.top - (row + 0.5) * STEP / scale)
        val columns = ceil(long * scale / STEP).toInt()
        for (row in 0 until ceil(drawn / STEP).toInt()) {
            var from = 0
            while (from < columns) {
                if (!isBehind(from, row)) {
                    from++
                    continue
                }
                var to = from + 1
                while (to < columns && isBehind(to, row)) to++
                sheet.tile(left + from * STEP, row * STEP, (to - from) * STEP, STEP, WALL)
                from = to
            }
        }
    }

    private companion object {
        const val PIXELS = 1400

        /** Room for the bar and its words. */
        const val LEAST_WIDTH = 420
        const val ROUNDING = 1e-6
        const val LEAST_PIXELS = 0.7
        const val OUTLINED = 3.0
        const val OUTLINE = 0.35
        const val EDGE = 1.0
        const val DARKEST = 0.45
        const val SHADES = 63

        /** Of the walls, in pixels. */
        const val STEP = 2.0

        /** Legible where the picture is half as wide as it has pixels, and still on a narrow screen. */
        const val TEXT = 28
        const val ROW = 56
        const val MARGIN = 28.0
        const val GAP = 12.0
        const val BAR = 6.0
        const val SWATCH = 12.0
        const val SPACE = "#10141c"
        const val WALL = "#4a5262"
        const val STRIP = "#eceff3"
    }
}
