package daphnis.analysis.plot

import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import daphnis.core.boundary.ContactFaces
import daphnis.core.format.WholeFile
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import kotlin.math.floor

/**
 * Pictures of a state to scale, from above and from the side, with a bar that tells lengths below. The longer of x and
 * y lies to the right where it is much longer, else y. Spheres that stick out of a periodic face are cut there and go
 * on at the other, images where they are at the time.
 */
internal class PatchPicture(private val state: State, private val lengthName: String) {
    private val p = state.population
    private val box = state.boundary.box
    private val kinds = SphereKinds(state)

    /** The axis to the right: 1, or 0 of a patch that is thin along y. */
    val across: Int = if (box.length(0) > LONGEST * box.length(1)) 0 else 1
    private val other = 1 - across

    /** A part of the plane: from and to along [across] and along the axis [up]. */
    class Window(val left: Double, val right: Double, val bottom: Double, val top: Double, val up: Int)

    /** A circle of the picture: its middle, its radius, how near it is, and its kind. */
    class Disc(val x: Double, val y: Double, val r: Double, val depth: Double, val kind: Int)

    private val above = window(other, box.lower(other), box.upper(other))
    private val side by lazy { heights().let { (low, high) -> window(2, low, high) } }

    /** What the bar in the picture from above is long. */
    val bar: String get() = barText(above)

    /** The same of that from the side. */
    val barSide: String get() = barText(side)

    /** How much of its length the picture from above shows, in words; null where that is all. */
    val partAbove: String? get() = part(above)

    /** The same of that from the side. */
    val partSide: String? get() = part(side)

    /** A very long patch, whose width would not be seen, is shown in part. */
    private fun window(up: Int, bottom: Double, top: Double): Window {
        val length = box.length(across)
        // Some of a layer is seen beside its thickness, a box as a whole.
        val width = if (up == 2) maxOf(top - bottom, box.length(other)) else top - bottom
        val shown = if (length > WHOLE * width) LONGEST * width else length
        return Window(box.lower(across), box.lower(across) + shown, bottom, top, up)
    }

    private val isLayer: Boolean
        get() = state.boundary.contactFaces(2) == ContactFaces.OPEN && state.boundary.walls.surfaces.isEmpty()

    /** Heights of the spheres of a layer, ascending. */
    private val outs: DoubleArray by lazy {
        DoubleArray(p.size) { Math.abs(p.z[it]) + p.radius[it] }.also { it.sort() }
    }

    /** Where a few spheres of a layer are thrown so far out that it would be a line: without these. */
    private fun layer(): Double {
        val out = outs.lastOrNull() ?: return 1.0
        return minOf(out, FAR * outs[(NEARLY_ALL * (outs.size - 1)).toInt()])
    }

    /** What the picture from the side leaves out above and below, in words; null where that is nothing. */
    val leftOutSide: String? by lazy {
        val beyond = if (isLayer) outs.count { it > side.top } else 0
        if (beyond == 0) null else "$beyond of ${p.size} spheres are farther up or down"
    }

    /** Of a layer with open faces those of its spheres, as far below z = 0 as above; else the box, and what sticks out. */
    private fun heights(): Pair<Double, Double> {
        if (isLayer) return layer().let { -it to it }
        if (state.boundary.repeats(2)) return box.lowerZ to box.upperZ
        val low = (0 until p.size).minOfOrNull { p.z[it] - p.radius[it] } ?: box.lowerZ
        val high = (0 until p.size).maxOfOrNull { p.z[it] + p.radius[it] } ?: box.upperZ
        return minOf(box.lowerZ, low) to maxOf(box.upperZ, high)
    }

    private fun part(window: Window): String? {
        val shown = window.right - window.left
        val all = box.length(across)
        if (shown >= all) return null
        fun text(length: Double) = ScaleBar.text(length, lengthName)
        return "The first ${text(shown)} of ${text(all)}"
    }

    private fun barText(window: Window) = ScaleBar.text(ScaleBar.length(window.right - window.left), lengthName)

    /** Writes `NAME.png` and `NAME.svg` into [directory]; the PNG. */
    fun writeAbove(directory: Path, name: String): ByteArray = write(above, directory, name)

    fun writeSide(directory: Path, name: String): ByteArray = write(side, directory, name)

    private fun write(window: Window, directory: Path, name: String): ByteArray {
        val discs = discs(window).sortedBy { it.depth }
        val sheet = StateSheet(state, kinds, window, across, discs, barText(window))
        val png = sheet.png()
        Files.createDirectories(directory)
        WholeFile.write(directory.resolve("$name.png"), png)
        WholeFile.write(directory.resolve("$name.svg"), svg(sheet, png))
        return png
    }

    /** Circles while they are few enough to be read and edited, else the picture in an SVG. */
    private fun svg(sheet: StateSheet, png: ByteArray): String {
        if (sheet.discs.size <= MOST_CIRCLES) return sheet.svg()
        val size = "width=\"${sheet.width}\" height=\"${sheet.height}\""
        val head = "<svg xmlns=\"http://www.w3.org/2000/svg\" $size viewBox=\"0 0 ${sheet.width} ${sheet.height}\">"
        val data = Base64.getEncoder().encodeToString(png)
        return "$head<image $size href=\"data:image/png;base64,$data\"/></svg>\n"
    }

    /** All discs that touch the window, images included. From the side spheres of the front half hide those behind. */
    private fun discs(window: Window): List<Disc> {
        val result = ArrayList<Disc>()
        val images = PlaneImages(state.boundary, state.time)
        val fromAbove = window.up != 2
        // Two boxes away along the slide, since images are displaced by up to one.
        val along = (0..1).map { axis -> if ((fromAbove || axis == across) && images.repeats(axis)) -2..2 else 0..0 }
        for (k in 0 until p.size) {
            val r = p.radius[k]
            for (iy in along[1]) {
                for (ix in along[0]) {
                    val u = p.position(across)[k] + images.shift(ix, iy, across)
                    val w = p.position(other)[k] + images.shift(ix, iy, other)
                    val v = if (fromAbove) w else p.z[k]
                    if (u + r < window.left || u - r > window.right || v + r < window.bottom || v - r > window.top) {
                        continue
                    }
                    // Seen along y from below it, along x from above.
                    val depth = if (fromAbove) p.z[k] else -withinBox(w, images)
                    result += Disc(u, v, r, depth, kinds.of(k))
                }
            }
        }
        return result
    }

    /**
     * Seen from the side an image beyond a face may have slid out of the box along the line of sight: there the next
     * one stands inside.
     */
    private fun withinBox(w: Double, images: PlaneImages): Double {
        if (!images.repeats(other)) return w
        return w - floor((w - box.lower(other)) / box.length(other)) * box.length(other)
    }

    private companion object {
        /** Length over width from which a patch lies along its length, and of what is shown of a very long one. */
        const val LONGEST = 4.0

        /** Length over width up to which all of a patch is shown. */
        const val WHOLE = 50.0
        const val MOST_CIRCLES = 6000

        /** Times the height that nearly all spheres of a layer keep within, up to which the others are shown. */
        const val FAR = 3.0
        const val NEARLY_ALL = 0.99
    }
}
