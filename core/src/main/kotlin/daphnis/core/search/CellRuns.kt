package daphnis.core.search

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import kotlin.math.ceil
import kotlin.math.floor

/**
 * The runs of slots of a [Grid] that have to be searched for a sphere. Holds the runs of one query at a time, so each
 * thread has its own. Rows are those of [StepRows.state].
 *
 * @param closer bounds on other spheres which are closer than the reach for which the grid was built; null for none
 */
public class CellRuns @JvmOverloads constructor(private val grid: Grid, private val closer: RowBounds? = null) :
    SlotRuns() {
    private val levels = grid.levels

    // The present class of sizes.
    private var layout = GridLayout()
    private var cells = layout.cells
    private var periodic = layout.isPeriodic
    private var starts = grid.cellStart

    // The present box of cells along row axis, middle and slow axis; may reach beyond the faces of periodic axes.
    private val least = IntArray(3)
    private val most = IntArray(3)

    // Where the sphere is and where it will be at the end of the step, along these axes, its radius, and the time now.
    private val here = DoubleArray(3)
    private val there = DoubleArray(3)
    private var radius = 0.0
    private var time = 0.0
    private var bounds: RowBounds? = null

    // Whether the sphere is so large compared with the cells that searching its outline pays instead of its whole cube.
    private var isRound = false
    private var closeFrom = 0
    private var closeTo = 0

    /**
     * Sets the runs that hold, once for each pair and image, the partners which the sphere in [slot] can touch on its
     * way in the time [rest]. Its row is at [p] of [state]. Only at the start of a step, before any sphere has
     * collided.
     *
     * @return number of runs
     */
    public fun ahead(slot: Int, state: DoubleArray, p: Int, rest: Double): Int {
        val wayX = state[p + VX] * rest
        val wayY = state[p + VX + 1] * rest
        val wayZ = state[p + VX + 2] * rest
        return ahead(slot, state[p], state[p + 1], state[p + 2], wayX, wayY, wayZ, state[p + RADIUS] * grid.swelling)
    }

    /** The same for a sphere of [radius] that stays at ([x], [y], [z]). */
    public fun aheadAt(slot: Int, x: Double, y: Double, z: Double, radius: Double): Int =
        ahead(slot, x, y, z, 0.0, 0.0, 0.0, radius)

    // From here on numbers by themselves: read from arrays, they make the search 3 % slower.
    private fun ahead(
        slot: Int,
        x: Double,
        y: Double,
        z: Double,
        wayX: Double,
        wayY: Double,
        wayZ: Double,
        radius: Double,
    ): Int {
        clear()
        time = 0.0
        starts = grid.cellStart
        val own = if (levels.count == 1) 0 else levels.of(radius)
        cover(own, x, y, z, wayX, wayY, wayZ, radius)
        addAhead(slot)
        // Smaller spheres find this one from their side.
        for (level in own + 1 until levels.count) {
            cover(level, x, y, z, wayX, wayY, wayZ, radius)
            addAll()
        }
        return size
    }

    private fun addAhead(slot: Int) {
        val c1 = layout.cellAt(here[1], 1)
        val c2 = layout.cellAt(here[2], 2)
        // The rest of the own row, which is later slots and then cells ahead; then the rows ahead, of the own layer and
        // of the layers above.
        val row = layout.inMemory(c2, 2) * cells[1] + layout.inMemory(c1, 1)
        val rowStart = layout.firstCell + row * cells[0]
        var last = most[0]
        val bounds = bounds
        if (bounds != null) {
            last = if (isWithin(bounds, row, c1, c2, 0, radius + layout.ownMargin[0])) closeTo else -1
        }
        if (cells[0] == layout.count[0]) {
            if (last >= 0) addRun(slot + 1, starts[rowStart + minOf(last, cells[0] - 1) + 1], 0)
            if (periodic[0]) addCells(rowStart, cells[0], last, 0, 0)
        } else {
            val c0 = layout.cellAt(here[0], 0)
            if (last >= c0) addRun(slot + 1, starts[rowStart + layout.inMemory(c0, 0) + 1], 0)
            addCells(rowStart, c0 + 1, last, 0, 0)
        }
        for (row in c1 + 1..most[1]) addRow(row, c2)
        for (layer in c2 + 1..most[2]) {
            for (row in least[1]..most[1]) addRow(row, layer)
        }
    }

    /**
     * Sets the runs that hold every sphere and image that the sphere in the row at [p] of [state] can touch on its way
     * from its local time on, for the time [rest]. They hold the sphere itself too.
     *
     * @return number of runs
     */
    public fun around(state: DoubleArray, p: Int, rest: Double): Int {
        val wayX = state[p + VX] * rest
        val wayY = state[p + VX + 1] * rest
        val wayZ = state[p + VX + 2] * rest
        clear()
        time = state[p + TIME]
        starts = grid.cellStart
        for (level in 0 until levels.count) {
            cover(level, state[p], state[p + 1], state[p + 2], wayX, wayY, wayZ, state[p + RADIUS] * grid.outlook)
            addAll()
        }
        return size
    }

    private fun addAll() {
        for (layer in least[2]..most[2]) {
            for (row in least[1]..most[1]) addRow(row, layer)
        }
    }

    /** Makes the cells of [level] in which the sphere can meet another one the present box. */
    private fun cover(
        level: Int,
        x: Double,
        y: Double,
        z: Double,
        wayX: Double,
        wayY: Double,
        wayZ: Double,
        radius: Double,
    ) {
        layout = levels[level]
        cells = layout.cells
        periodic = layout.isPeriodic
        this.radius = radius
        isRound = radius > ROUND_FROM * Math.max(layout.width[1], layout.width[2])
        bounds = if (closer != null && closer.isInUse) closer else null
        for (k in 0..2) {
            val from = layout.pick(k, x, y, z)
            val to = from + layout.pick(k, wayX, wayY, wayZ)
            here[k] = from
            there[k] = to
            val margin = radius + layout.margin[k]
            least[k] = layout.cellToward(Math.min(from, to) - margin, k)
            most[k] = layout.cellToward(Math.max(from, to) + margin, k)
        }
    }

    /** Adds the present cells in the row ([r1], [r2]), which may lie beyond a face. */
    private fun addRow(r1: Int, r2: Int) {
        val image1 = layout.boxes(r1, 1)
        val image2 = layout.boxes(r2, 2)
        val c1 = layout.inMemory(r1, 1)
        val c2 = layout.inMemory(r2, 2)
        if (c1 >= cells[1] || c2 >= cells[2]) return
        val rowStart = layout.firstCell + (c2 * cells[1] + c1) * cells[0]
        var from = least[0]
        var to = most[0]
        var slack = radius + layout.ownMargin[0]
        if (isRound) {
            slack = halfChord(r1, r2)
            if (slack < 0) return
            val reach = layout.margin[0] - layout.ownMargin[0]
            from = layout.cellToward(Math.min(here[0], there[0]) - slack - reach, 0)
            to = layout.cellToward(Math.max(here[0], there[0]) + slack + reach, 0)
        }
        val bounds = bounds
        if (bounds != null) {
            if (!isWithin(bounds, c2 * cells[1] + c1, r1, r2, image2, slack)) return
            from = closeFrom
            to = closeTo
        } else if (image2 != 0 && layout.slides) {
            // The image row is displaced by s, so its spheres are searched s earlier in the row.
            from -= ceil(maxOf(image2 * layout.slideLow, image2 * layout.slideHigh)).toInt()
            to -= floor(minOf(image2 * layout.slideLow, image2 * layout.slideHigh)).toInt()
        }
        // Most runs are within one image, and all of their row is in memory.
        if (from >= 0 && to < cells[0] && layout.first[0] == 0) {
            val image = if (image1 or image2 == 0) 0 else code(0, image1, image2)
            addRun(starts[rowStart + from], starts[rowStart + to + 1], image)
        } else {
            addCells(rowStart, from, to, image1, image2)
        }
    }

    /**
     * How far along the row numbered ([r1], [r2]) the sphere, on its path, can touch one that started there, if it does
     * not move along the row; −1 when it cannot. Other spheres may have come nearer by their reach along the other two
     * axes.
     */
    private fun halfChord(r1: Int, r2: Int): Double {
        val s = radius + Math.max(layout.ownMargin[0], Math.max(layout.ownMargin[1], layout.ownMargin[2]))
        val a = gap(1, r1)
        val b = gap(2, r2)
        val rest = s * s * (1 + ROUNDING) - a * a - b * b
        return if (rest < 0) -1.0 else Math.sqrt(rest)
    }

    /**
     * Least distance along axis [k] of the three between the path of the sphere and any sphere that started in row [r].
     */
    private fun gap(k: Int, r: Int): Double {
        val reach = layout.margin[k] - layout.ownMargin[k]
        val bottom = layout.low[k] + r * layout.width[k] - reach
        val top = layout.low[k] + (r + 1) * layout.width[k] + reach
        val least = Math.min(here[k], there[k])
        val most = Math.max(here[k], there[k])
        return Math.max(0.0, Math.max(bottom - most, least - top))
    }

    /**
     * Whether a sphere that started in [row], which is numbered ([r1], [r2]) here, can be met, and in which of its
     * cells: [closeFrom] to [closeTo]. A sphere which was at s at the start is somewhere in s + [least, greatest
     * velocity] · t at time t. The searching sphere moves straight from [here] to [there]. So the places where they can
     * meet are bounded by the bounds now and at the end.
     */
    private fun isWithin(bounds: RowBounds, row: Int, r1: Int, r2: Int, image2: Int, slack: Double): Boolean {
        val v = bounds.values
        val p = (layout.firstRow + row) * RowBounds.WIDTH
        if (v[p] > v[p + 1]) return false
        val t = time
        val end = bounds.duration
        if (!isAxisWithin(1, r1, v[p + 2], v[p + 3], end) || !isAxisWithin(2, r2, v[p + 4], v[p + 5], end)) return false
        var low = v[p]
        var high = v[p + 1]
        var offset = 0.0
        if (image2 != 0 && layout.slides) {
            low += image2 * grid.images.shearVelocity
            high += image2 * grid.images.shearVelocity
            offset = image2 * grid.images.shearOffset
        }
        val now = here[0] - offset
        val later = there[0] - offset
        val a = now - high * t
        val b = later - high * end
        val c = now - low * t
        val d = later - low * end
        closeFrom = layout.cellToward((if (a < b) a else b) - slack, 0)
        closeTo = layout.cellToward((if (c > d) c else d) + slack, 0)
        return true
    }

    private fun isAxisWithin(k: Int, r: Int, low: Double, high: Double, end: Double): Boolean {
        val now = here[k]
        val later = there[k]
        val width = layout.width[k]
        val slack = radius + layout.ownMargin[k]
        val top = layout.low[k] + (r + 1) * width + slack
        if (now - high * time > top && later - high * end > top) return false
        val bottom = layout.low[k] + r * width - slack
        return now - low * time >= bottom || later - low * end >= bottom
    }

    /** Adds those of the cells [from]..[to] of a periodic row that are in memory, split where an image begins. */
    private fun addCells(rowStart: Int, from: Int, to: Int, image1: Int, image2: Int) {
        val period = layout.count[0]
        var c = from
        while (c <= to) {
            val place = layout.inMemory(c, 0)
            if (place >= cells[0]) {
                c += period - place
                continue
            }
            val image0 = Math.floorDiv(c, period)
            val end = minOf(to, (image0 + 1) * period - 1, c + cells[0] - 1 - place)
            val base = rowStart + place
            addRun(starts[base], starts[base + end - c + 1], code(image0, image1, image2))
            c = end + 1
        }
    }

    private fun code(image0: Int, image1: Int, image2: Int): Int =
        ((image0 and 0xff) shl (8 * layout.axes[0])) or ((image1 and 0xff) shl (8 * layout.axes[1])) or
            ((image2 and 0xff) shl (8 * layout.axes[2]))

    private companion object {
        const val ROUND_FROM = 4.0
        const val ROUNDING = 1e-9
    }
}
