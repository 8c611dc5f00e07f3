package daphnis.core.search

import kotlin.math.floor

/**
 * Cells of equal width along three axes, which are whatever the owner says: the one place that says in which cell a
 * coordinate is. Arrays are indexed by axis.
 *
 * Along an axis that is periodic, cells are counted on beyond the faces. Elsewhere the cells at the two ends have all
 * that is beyond.
 *
 * @property low where the first cell begins
 * @property length of all cells together
 */
internal open class CellAxes(
    val low: DoubleArray = DoubleArray(AXES),
    val length: DoubleArray = DoubleArray(AXES),
    val isPeriodic: BooleanArray = BooleanArray(AXES),
) {
    /** Numbers of cells, at least 1. */
    val count = IntArray(AXES)

    /** How many cells there are in a unit of length, and their widths; after [settle]. */
    val perLength = DoubleArray(AXES)
    val width = DoubleArray(AXES)

    /** Number of cells in all. */
    val total: Int get() = count[0] * count[1] * count[2]

    /** Divides axis [k] into cells of which [perRange] make a [range], but no more than [most]. */
    fun divide(k: Int, range: Double, perRange: Double, most: Double) {
        count[k] = (length[k] / range * perRange).coerceIn(1.0, most).toInt()
    }

    /** Takes fewer cells, by [fewer] along the axis that has most, until there are no more than [most]. */
    inline fun thin(most: Long, fewer: (count: Int) -> Int) {
        while (count[0].toLong() * count[1] * count[2] > most) {
            val k = (0 until AXES).maxBy { count[it] }
            count[k] = maxOf(1, fewer(count[k]))
        }
    }

    /** Computes what follows from the numbers of cells. */
    fun settle() {
        for (k in 0 until AXES) {
            perLength[k] = if (length[k] > 0) count[k] / length[k] else 1.0
            width[k] = 1 / perLength[k]
        }
    }

    /** The cell along axis [k] in which [position] is, which is in the box along a periodic axis. */
    fun cellAt(position: Double, k: Int): Int {
        val c = ((position - low[k]) * perLength[k]).toInt()
        return if (c >= count[k]) {
            count[k] - 1
        } else if (c < 0) {
            0
        } else {
            c
        }
    }

    /** The same, counted on beyond the faces along a periodic axis. */
    fun cellToward(position: Double, k: Int): Int =
        if (isPeriodic[k]) floor((position - low[k]) * perLength[k]).toInt() else cellAt(position, k)

    /** The cell along axis [k] in which [position] or an image of it is. */
    fun cellOfImage(position: Double, k: Int): Int {
        val n = count[k]
        val c = (position - low[k]) * perLength[k]
        val isInside = c >= 0 && c < n || !isPeriodic[k]
        return if (isInside) cellAt(position, k) else (c - floor(c / n) * n).toInt().coerceAtMost(n - 1)
    }

    /** How many boxes away cell [c] along axis [k] is; nearly always none. */
    fun boxes(c: Int, k: Int): Int = if (c >= 0 && c < count[k]) 0 else Math.floorDiv(c, count[k])

    /** The middle of cell [c] along axis [k]. */
    fun middleOf(c: Int, k: Int): Double = low[k] + (c + 0.5) * width[k]

    companion object {
        const val AXES = 3
    }
}
