package daphnis.analysis.movie

import kotlin.math.floor

/**
 * Mass per area as seen in a picture, and the mean of a quantity, on cells of [cell] × [cell] pixels. A sphere is
 * shared out among the four cells around it; at the border nothing is lost.
 */
internal class SurfaceGrid(private val view: Viewport, private val cell: Int) {
    val columns: Int = (view.endColumn - view.firstColumn + cell - 1) / cell
    val rows: Int = (view.height + cell - 1) / cell
    private val mass = DoubleArray(columns * rows)
    private val weighted = DoubleArray(columns * rows)
    private val spare = DoubleArray(maxOf(columns, rows))
    private val area = cell * cell * view.pixelArea

    fun clear() {
        mass.fill(0.0)
        weighted.fill(0.0)
    }

    /** Adds a sphere at the pixel ([x], [y]). */
    fun add(x: Double, y: Double, mass: Double, value: Double) {
        val u = (x - view.firstColumn) / cell - 0.5
        val v = y / cell - 0.5
        val i = floor(u)
        val j = floor(v)
        share(i.toInt(), j.toInt(), mass * (1 - (u - i)) * (1 - (v - j)), value)
        share(i.toInt() + 1, j.toInt(), mass * (u - i) * (1 - (v - j)), value)
        share(i.toInt(), j.toInt() + 1, mass * (1 - (u - i)) * (v - j), value)
        share(i.toInt() + 1, j.toInt() + 1, mass * (u - i) * (v - j), value)
    }

    private fun share(i: Int, j: Int, part: Double, value: Double) {
        val k = j.coerceIn(0, rows - 1) * columns + i.coerceIn(0, columns - 1)
        mass[k] += part
        weighted[k] += part * value
    }

    /** Spreads what a cell has over its neighbours, one part in two each way, [passes] times. */
    fun smooth(passes: Int) {
        repeat(passes) {
            for (a in arrayOf(mass, weighted)) {
                for (j in 0 until rows) smooth(a, j * columns, 1, columns)
                for (i in 0 until columns) smooth(a, i, columns, rows)
            }
        }
    }

    private fun smooth(a: DoubleArray, first: Int, stride: Int, count: Int) {
        for (n in 0 until count) spare[n] = a[first + n * stride]
        for (n in 0 until count) {
            val before = spare[maxOf(n - 1, 0)]
            val after = spare[minOf(n + 1, count - 1)]
            a[first + n * stride] = (before + 2 * spare[n] + after) / 4
        }
    }

    /** The cell of the pixel in [column] and [row] of the picture; those beyond the border count as the last. */
    fun cellAt(column: Int, row: Int): Int = (row / cell).coerceIn(0, rows - 1) * columns +
        ((column - view.firstColumn) / cell).coerceIn(0, columns - 1)

    /** Mass per area in cell [k]. */
    fun density(k: Int): Double = mass[k] / area

    /** Mean of the quantity in cell [k], weighted by mass; NaN in an empty one. */
    fun mean(k: Int): Double = weighted[k] / mass[k]

    /** Densities of the cells that are not empty. */
    fun densities(): DoubleArray = mass.filter { it > 0 }.map { it / area }.toDoubleArray()
}
