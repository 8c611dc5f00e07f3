package daphnis.core.engine.horizon

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import daphnis.core.search.CellAxes
import daphnis.core.search.CellCounting
import daphnis.core.search.CellOrder
import kotlin.math.abs
import kotlin.math.floor

/**
 * The cells of an epoch: a regular grid into which spheres are sorted by where their lines are at the middle of the
 * epoch. **Slot** is the place of a sphere in this order; slots of a cell are consecutive.
 *
 * A sphere which is at the middle of the epoch at g, with a velocity of at most [bound], is never farther than
 * `bound · T / 2` from g. So a search looks as far around a path as the radii and that [reach]; cells sorted by where
 * spheres are at the start would need twice as much. Along rows, velocities are relative to the mean flow of the layer.
 *
 * Spheres in cells are **members**: at each moment from its last change on, the line of a member is within [reach] of
 * its cell ([holds]), which moves with the flow of its layer. A sphere that is too fast, too large, or was thrown out
 * of its place by a collision, is a roamer instead.
 *
 * Arrays are indexed by row axis, middle axis and slow axis.
 */
internal class EpochCells(private val frame: EpochFrame, private val lines: Lines, private val loop: RangeLoop) :
    CellAxes(frame.low, frame.length, frame.isPeriodic) {
    /** Bound on the velocities of members. */
    val bound = DoubleArray(AXES)

    /** How far a member may be from its cell. */
    val reach = DoubleArray(AXES)

    val speeds = Speeds(frame, loop)

    /** Velocity of the mean flow by layer. */
    var flow = DoubleArray(0)
        private set

    /** First slot of each cell; entry c + 1 is one past its last. */
    var start = IntArray(0)
        private set

    /** Cell by slot; that after the last cell for spheres which were no members at the start. */
    var cellOf = IntArray(0)
        private set

    /** Index in the spheres that were sorted, by slot: those of the population, or of the columns of the step. */
    var order = IntArray(0)
        private set

    /** Slot by that index, when [invert] has been called. */
    var slots = IntArray(0)
        private set

    /** Slots below this are those of spheres that were members at the start. */
    var members = 0
        private set
    private val counting = CellCounting()
    private val sorted = CellOrder()
    private var imageOfIndex = IntArray(0)

    /** Sorts [spheres], which are where they say at [time] and whose velocities have been measured, into cells. */
    fun sort(spheres: SphereColumns, tuning: HorizonTuning, time: Double) {
        layOut(spheres.size, tuning)
        if (cellOf.size < spheres.size) {
            imageOfIndex = IntArray(spheres.size)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            cellOf = IntArray(spheres.size)
        }
        // One cell more, for all that are no members.
        val cells = total
        counting.sort(spheres.size, cells + 1, sorted, loop) { from, to ->
            place(spheres, frame.middle - time, from, to)
        }
        start = sorted.start
        order = sorted.order
        members = start[cells]
        loop.run(spheres.size) { _, from, to -> for (slot in from until to) cellOf[slot] = sorted.cellOf[order[slot]] }
    }

    /** The slots [from] until [to] are added, which have no cell. */
    fun admit(from: Int, to: Int) {
        if (cellOf.size < to) {
            imageOfIndex = imageOfIndex.copyOf(to + to / SPARE)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            cellOf = cellOf.copyOf(to + to / SPARE)
        }
        if (from < to) cellOf.fill(total, from, to)
    }

    private fun layOut(spheres: Int, tuning: HorizonTuning) {
        for (k in 0 until AXES) bound[k] = tuning.classBound * speeds.rmsAtLeast(k)
        for (k in 0 until AXES) {
            val range = 2 * (2 * frame.memberRadius + frame.inflation + bound[k] * frame.halfLength)
            val perRange = if (k == 0) tuning.cellsAlong else tuning.cellsAcross
            divide(k, range, perRange, MOST_CELLS_ALONG)
        }
        thin(CELLS_A_SPHERE * spheres + LEAST_CELLS) { (it * SHRINKING).toInt() }
        settle()
        if (flow.size < count[2]) flow = DoubleArray(count[2])
        for (c in 0 until count[2]) flow[c] = frame.flowRate * middleOf(c, 2)
        // Within a layer the flow differs from that of its middle.
        bound[0] += abs(frame.flowRate) * width[2] / 2
        for (k in 0 until AXES) reach[k] = bound[k] * frame.halfLength
    }

    /** Finds the cells of the spheres [from] until [to], which are where they say [wait] before the middle. */
    private fun place(spheres: SphereColumns, wait: Double, from: Int, to: Int) {
        val p0 = spheres.position(frame.axes[0])
        val p1 = spheres.position(frame.axes[1])
        val p2 = spheres.position(frame.axes[2])
        val v0 = spheres.velocity(frame.axes[0])
        val v1 = spheres.velocity(frame.axes[1])
        val v2 = spheres.velocity(frame.axes[2])
        val offset = frame.offset(frame.middle)
        val slide = frame.images.shearVelocity
        for (i in from until to) {
            val m2 = p2[i] + v2[i] * wait
            val m1 = p1[i] + v1[i] * wait
            val slow = boxes(m2, 2)
            val middle = boxes(m1, 1)
            val along = v0[i] - slow * slide
            val m0 = p0[i] + v0[i] * wait - if (frame.slides) slow * offset else 0.0
            val row = boxes(m0, 0)
            val c2 = cellAt(m2 - slow * length[2], 2)
            val isMember = abs(along - flow[c2]) <= bound[0] &&
                abs(v1[i]) <= bound[1] &&
                abs(v2[i]) <= bound[2] &&
                spheres.radius[i] <= frame.memberRadius
            val c1 = cellAt(m1 - middle * length[1], 1)
            val c0 = cellAt(m0 - row * length[0], 0)
            val c = if (isMember) (c2 * count[1] + c1) * count[0] + c0 else total
            sorted.cellOf[i] = c
            imageOfIndex[i] = frame.code(row, middle, slow)
        }
    }

    /** How many boxes away from the box [position] along axis [k] is. */
    private fun boxes(position: Double, k: Int): Int {
        val offset = position - low[k]
        // Nearly always within the box: no division then.
        if (offset >= 0 && offset < length[k] || !isPeriodic[k]) return 0
        return floor(offset / length[k]).toInt()
    }

    /** Makes [slots], the reverse of [order]. */
    fun invert(spheres: Int) {
        if (slots.size < spheres) slots = IntArray(order.size)
        loop.run(spheres) { _, from, to -> for (slot in from until to) slots[order[slot]] = slot }
    }

    /** The boxes by which the line in [slot] has to be moved back at the start of the epoch. */
    fun imageAtStart(slot: Int): Int = imageOfIndex[order[slot]]

    /** Whether [slot] has a cell, so that searches that look at the cell meet it. */
    fun hasCell(slot: Int): Boolean = cellOf[slot] < total

    /** The boxes by which the line in [slot] is to be moved back to be near its cell at the middle of the epoch. */
    fun imageAtCell(slot: Int): Int = coordinates(cellOf[slot]) { c0, c1, c2 ->
        imageOf(lines, slot) { position, k ->
            val c = when (k) {
                0 -> c0
                1 -> c1
                else -> c2
            }
            val offset = position - middleOf(c, k)
            if (abs(offset) <= length[k] / 2) 0 else Math.rint(offset / length[k]).toInt()
        }
    }

    /** Calls [use] with the numbers of [cell] along the axes. */
    private inline fun <T> coordinates(cell: Int, use: (c0: Int, c1: Int, c2: Int) -> T): T {
        val row = cell / count[0]
        val layer = row / count[1]
        return use(cell - row * count[0], row - layer * count[1], layer)
    }

    /** The boxes by which the line in [slot] of [lines] is to be moved back to be in the box at that time. */
    fun imageInBox(lines: Lines, slot: Int): Int = imageOf(lines, slot) { position, k -> boxes(position, k) }

    /** The row of cells, counted through all layers, in which the line in [slot] is at the middle of the epoch. */
    fun rowAtMiddle(slot: Int): Int {
        val c1 = cellAt(lines.at(slot, frame.axes[1], frame.middle), 1)
        return cellAt(lines.at(slot, frame.axes[2], frame.middle), 2) * count[1] + c1
    }

    private inline fun imageOf(lines: Lines, slot: Int, boxes: (position: Double, k: Int) -> Int): Int {
        val t = frame.middle
        val slow = if (isPeriodic[2]) boxes(lines.at(slot, frame.axes[2], t), 2) else 0
        val middle = if (isPeriodic[1]) boxes(lines.at(slot, frame.axes[1], t), 1) else 0
        val shift = if (frame.slides) slow * frame.offset(t) else 0.0
        val along = if (isPeriodic[0]) boxes(lines.at(slot, frame.axes[0], t) - shift, 0) else 0
        return if ((along or middle or slow) == 0) 0 else frame.code(along, middle, slow)
    }

    /** Whether the line in [slot] is within [reach] of its cell from time [from] to the end of the epoch. */
    fun holds(slot: Int, from: Double): Boolean = hasCell(slot) &&
        coordinates(cellOf[slot]) { c0, c1, c2 ->
            holds(slot, 0, c0, flow[c2], from) && holds(slot, 1, c1, 0.0, from) && holds(slot, 2, c2, 0.0, from)
        }

    private fun holds(slot: Int, k: Int, c: Int, drift: Double, from: Double): Boolean {
        val axis = frame.axes[k]
        return isNear(lines.at(slot, axis, from) - drift * (from - frame.middle), c, k) &&
            isNear(lines.at(slot, axis, frame.end) - drift * (frame.end - frame.middle), c, k)
    }

    private fun isNear(position: Double, c: Int, k: Int): Boolean {
        val room = reach[k] + 0.5 * width[k]
        val offset = position - middleOf(c, k)
        // The cells at the ends of an axis without images have all that is beyond.
        val isAbove = offset <= room || !isPeriodic[k] && c == count[k] - 1
        return isAbove && (offset >= -room || !isPeriodic[k] && c == 0)
    }

    private companion object {
        const val MOST_CELLS_ALONG = 1e5
        const val CELLS_A_SPHERE = 4L
        const val LEAST_CELLS = 64L
        const val SHRINKING = 0.8

        /** One part in so many is room for more. */
        const val SPARE = 8
    }
}
