package daphnis.core.engine.horizon

import daphnis.core.growth.GrowingTable
import daphnis.core.search.CellAxes
import kotlin.math.abs

/**
 * The roamers of an epoch: spheres that no cell holds, because they are too fast or too large, or because a collision
 * threw them far from their cell. They are few, so they have a coarse grid of lists of their own, by where their lines
 * are at the middle of the epoch. A search looks as far as the fastest of them may go.
 *
 * A roamer whose line changes is added anew; the old entry shows by its version.
 *
 * Arrays are indexed by row axis, middle axis and slow axis.
 */
internal class Roamers(private val frame: EpochFrame, private val lines: Lines) : GrowingTable() {
    val cells = CellAxes(frame.low, frame.length, frame.isPeriodic)

    /** How far the surface of a roamer may be from where its centre is at the middle of the epoch. */
    val reach = DoubleArray(AXES)
    private val fastest = DoubleArray(AXES)
    private var largest = 0.0

    /** Velocity of the mean flow by layer. */
    var flow = DoubleArray(0)
        private set
    private var heads = IntArray(0)
    private var slots = IntArray(0)
    private var versions = IntArray(0)
    private var next = IntArray(0)

    override fun resize(room: Int) {
        slots = slots.copyOf(room)
        versions = versions.copyOf(room)
        next = next.copyOf(room)
    }

    /** Forgets all, for an epoch of [spheres] spheres that are about as fast as [speeds] and as large as [radius]. */
    fun begin(spheres: Int, speeds: DoubleArray, radius: Double) {
        clear()
        largest = 0.0
        fastest.fill(0.0)
        for (k in 0 until AXES) {
            val range = 2 * (2 * radius + frame.inflation + speeds[k] * frame.halfLength)
            cells.divide(k, range, 1.0, MOST_CELLS_ALONG)
        }
        cells.thin(spheres / SPHERES_A_CELL + 1L) { it * 3 / 4 }
        cells.settle()
        val layers = cells.count[2]
        if (flow.size < layers) flow = DoubleArray(layers)
        for (c in 0 until layers) flow[c] = frame.flowRate * cells.middleOf(c, 2)
        if (heads.size < cells.total) heads = IntArray(cells.total)
        heads.fill(NONE, 0, cells.total)
        measure()
    }

    private fun measure() {
        for (k in 0 until AXES) {
            reach[k] = largest + frame.inflation + fastest[k] * frame.halfLength
        }
    }

    /**
     * Adds [slot] with its present line, which is in the box at the middle of the epoch.
     *
     * @param isFinal whether it will never get back the line that it had before; then the old entry may go
     */
    fun add(slot: Int, isFinal: Boolean = false) {
        val middle = frame.middle
        val c2 = cells.cellAt(lines.at(slot, frame.axes[2], middle), 2)
        val c1 = cells.cellAt(lines.at(slot, frame.axes[1], middle), 1)
        val c0 = cells.cellAt(lines.at(slot, frame.axes[0], middle), 0)
        var isMore = lines.radius(slot) > largest
        if (isMore) largest = lines.radius(slot)
        for (k in 0 until AXES) {
            val speed = abs(lines.velocity(slot, frame.axes[k]) - if (k == 0) flow[c2] else 0.0)
            if (speed > fastest[k]) {
                fastest[k] = speed * ROOM
                isMore = true
            }
        }
        if (isMore) measure()
        val cell = (c2 * cells.count[1] + c1) * cells.count[0] + c0
        // Giants collide often, and would fill the list.
        if (isFinal && heads[cell] != NONE && slots[heads[cell]] == slot) {
            versions[heads[cell]] = lines.version[slot]
            return
        }
        val e = append()
        slots[e] = slot
        versions[e] = lines.version[slot]
        next[e] = heads[cell]
        heads[cell] = e
    }

    /** The last entry of [cell], and the one before entry [e]; [NONE] when there is none. */
    fun head(cell: Int): Int = heads[cell]

    fun after(e: Int): Int = next[e]

    /** Whether entry [e] is that of the line which its slot has in [lines]. */
    fun isPresent(e: Int, lines: Lines): Boolean = versions[e] == lines.version[slots[e]]

    fun slotOf(e: Int): Int = slots[e]

    /** Calls [use] for each roamer that [isPresent] in [lines]. */
    inline fun forEachPresent(lines: Lines, use: (slot: Int) -> Unit) {
        for (e in 0 until size) if (isPresent(e, lines)) use(slotOf(e))
    }

    companion object {
        const val NONE = -1
        private const val AXES = 3
        private const val MOST_CELLS_ALONG = 1e3
        private const val SPHERES_A_CELL = 4
        private const val ROOM = 1.05
    }
}
