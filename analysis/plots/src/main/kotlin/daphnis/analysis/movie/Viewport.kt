package daphnis.analysis.movie

import kotlin.math.ceil
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.roundToInt

/** A part of the plane of the picture, in lengths: from and to along the horizontal and the vertical axis. */
internal class Window(val left: Double, val right: Double, val bottom: Double, val top: Double) {
    val across: Double get() = right - left
    val up: Double get() = top - bottom

    fun union(other: Window) = Window(
        minOf(left, other.left),
        maxOf(right, other.right),
        minOf(bottom, other.bottom),
        maxOf(top, other.top),
    )
}

/**
 * Where things in a [window] stand in a picture [width] pixels wide. A window that is much flatter than it is wide has
 * its vertical enlarged by the round factor [enlargedUp], a very narrow one its horizontal by [enlargedAcross]; both
 * are 1 elsewhere. A picture is not higher than wide: a narrow window stands in the middle.
 */
internal class Viewport(val window: Window, val width: Int) {
    val enlargedUp: Int = factor(window.across / window.up)
    val enlargedAcross: Int = factor(window.up / window.across)

    /** Pixels per length, horizontally and vertically. */
    val scaleX: Double
    val scaleY: Double

    /** Of the picture, in pixels. */
    val height: Int

    /** Columns from [firstColumn] until [endColumn] hold the window. */
    val firstColumn: Int
    val endColumn: Int

    init {
        val across = window.across * enlargedAcross
        val up = window.up * enlargedUp
        val scale = width / maxOf(across, up)
        scaleX = scale * enlargedAcross
        scaleY = scale * enlargedUp
        // Round-off may not add a row.
        height = ceil(up * scale - 1e-6).toInt().coerceIn(1, width)
        val columns = (across * scale).roundToInt().coerceIn(1, width)
        firstColumn = (width - columns) / 2
        endColumn = firstColumn + columns
    }

    fun x(across: Double): Double = firstColumn + (across - window.left) * scaleX

    fun y(up: Double): Double = (window.top - up) * scaleY

    /** Area that a pixel shows. */
    val pixelArea: Double get() = 1 / (scaleX * scaleY)

    private companion object {
        const val FLATTEST = 8.0

        /** 1, or the least of 2, 5, 10, 20, … that makes a window [times] as long as it is wide a stout one. */
        fun factor(times: Double): Int {
            val wanted = times / FLATTEST
            if (!(wanted > 1) || wanted > Int.MAX_VALUE / 10) return 1
            val power = 10.0.pow(ceil(log10(wanted)) - 1)
            return (power * listOf(2.0, 5.0, 10.0).first { it * power >= wanted * (1 - 1e-9) || it == 10.0 })
                .roundToInt().coerceAtLeast(2)
        }
    }
}
