package daphnis.core.engine.horizon

import kotlin.math.abs
import kotlin.math.floor

/**
 * The roamers of an epoch: spheres that no cell holds, because they are too fast or because a collision threw them far
 * from their cell. They are few, so they have a coarse grid of lists of their own, by where their lines are at the
 * middle of the epoch. A search looks as far as the fastest of them may go.
 *
 * A roamer whose line changes is added anew; the old entry shows by its version.
 *
 * Arrays are indexed by row axis, middle axis and slow axis.
 */
internal class Roamers(private val frame: EpochFrame, private val lines: Lines) {
    /** Entries, those of old lines included. */
    var size = 0
        private set

    /** Numbers of cells, and how far a roamer may be from where it is at the middle of the epoch. */
    private val count = IntArray(AXES)
    private val reach = DoubleArray(AXES)
    private val perLength = DoubleArray(AXES)
    private val fastest = DoubleArray(AXES)
    private var flow = DoubleArray(0)
    private var heads = IntArray(0)
    private var slots = IntArray(INITIAL)
    private var versions = IntArray(INITIAL)
    private var next = IntArray(INITIAL)

    // The cells that are looked through, which may lie beyond periodic faces, and the lists found there.
    private val least = IntArray(AXES)
    private val most = IntArray(AXES)
    private var found = 0
    private var foundHeads = IntArray(INITIAL)
    private var foundImages = IntArray(INITIAL)

    /** Forgets all, for an epoch of [spheres] spheres that are about as fast as [speeds]. */
    fun begin(spheres: Int, speeds: DoubleArray) {
        size = 0
        fastest.fill(0.0)
        for (k in 0 until AXES) {
            val range = 2 * (2 * frame.largestRadius + frame.inflation + speeds[k] * frame.middle)
            count[k] = (frame.length[k] / range).coerceIn(1.0, MOST_CELLS_ALONG).toInt()
        }
        while (count[0] * count[1] * count[2] > spheres / SPHERES_A_CELL + 1) {
            val k = (0 until AXES).maxBy { count[it] }
            count[k] = maxOf(1, count[k] * 3 / 4)
        }
        for (k in 0 until AXES) perLength[k] = if (frame.length[k] > 0) count[k] / frame.length[k] else 1.0
        if (flow.size < count[2]) flow = DoubleArray(count[2])
        for (c in 0 until count[2]) flow[c] = frame.flowRate * (frame.low[2] + (c + 0.5) / perLength[2])
        val cells = count[0] * count[1] * count[2]
        if (heads.size < cells) heads = IntArray(cells)
        heads.fill(NONE, 0, cells)
        measure()
    }

    private fun measure() {
        for (k in 0 until AXES) {
            reach[k] = 2 * frame.largestRadius + frame.inflation + fastest[k] * frame.middle
        }
    }

    /** Adds [slot] with its present line, which is in the box at the middle of the epoch. */
    fun add(slot: Int) {
        val middle = frame.middle
        val c2 = cellAt(lines.at(slot, frame.axes[2], middle), 2)
        val c1 = cellAt(lines.at(slot, frame.axes[1], middle), 1)
        val c0 = cellAt(lines.at(slot, frame.axes[0], middle), 0)
        var isFaster = false
        for (k in 0 until AXES) {
            val speed = abs(lines.velocity(slot, frame.axes[k]) - if (k == 0) flow[c2] else 0.0)
            if (speed > fastest[k]) {
                fastest[k] = speed * ROOM
                isFaster = true
            }
        }
        if (isFaster) measure()
        if (size == slots.size) grow()
        val cell = (c2 * count[1] + c1) * count[0] + c0
        slots[size] = slot
        versions[size] = lines.version[slot]
        next[size] = heads[cell]
        heads[cell] = size++
    }

    private fun cellAt(position: Double, k: Int): Int =
        ((position - frame.low[k]) * perLength[k]).toInt().coerceIn(0, count[k] - 1)

    /** Calls [use] for each roamer, and its image, that may come near the line in [slot] from time [from] on. */
    inline fun forEachNear(slot: Int, from: Double, use: (other: Int, image: Int) -> Unit) {
        if (size == 0) return
        val lists = lists(slot, from)
        for (k in 0 until lists) {
            var e = head(k)
            while (e != NONE) {
                if (isPresent(e)) use(slotOf(e), imageOf(k))
                e = after(e)
            }
        }
    }

    /** Notes the lists, not empty, of all cells that the line in [slot] can reach from time [from] on. */
    fun lists(slot: Int, from: Double): Int {
        found = 0
        for (k in 1 until AXES) {
            val axis = frame.axes[k]
            span(k, lines.at(slot, axis, from), lines.at(slot, axis, frame.end))
        }
        for (layer in least[2]..most[2]) {
            val slow = boxes(layer, 2)
            val c2 = layer - slow * count[2]
            spanRow(slot, from, c2, slow)
            for (row in least[1]..most[1]) {
                val middle = boxes(row, 1)
                val rowStart = (c2 * count[1] + row - middle * count[1]) * count[0]
                for (c in least[0]..most[0]) {
                    val along = boxes(c, 0)
                    val e = heads[rowStart + c - along * count[0]]
                    if (e != NONE) note(e, frame.code(along, middle, slow))
                }
            }
        }
        return found
    }

    /** How many boxes away cell [c] along axis [k] is; nearly always none. */
    private fun boxes(c: Int, k: Int): Int = if (c >= 0 && c < count[k]) 0 else Math.floorDiv(c, count[k])

    private fun note(e: Int, code: Int) {
        if (found == foundHeads.size) {
            foundImages = foundImages.copyOf(found * 2)
            // Last, since its length says how many there is room for.
            foundHeads = foundHeads.copyOf(found * 2)
        }
        foundHeads[found] = e
        foundImages[found++] = code
    }

    /** The cells of the rows of layer [c2], at its image [boxes] away. */
    private fun spanRow(slot: Int, from: Double, c2: Int, boxes: Int) {
        val axis = frame.axes[0]
        var here = lines.at(slot, axis, from) - flow[c2] * (from - frame.middle)
        var there = lines.at(slot, axis, frame.end) - flow[c2] * (frame.end - frame.middle)
        if (boxes != 0 && frame.slides) {
            here -= boxes * frame.offset(from)
            there -= boxes * frame.offset(frame.end)
        }
        span(0, here, there)
    }

    private fun span(k: Int, here: Double, there: Double) {
        least[k] = cellToward(minOf(here, there) - reach[k], k)
        most[k] = cellToward(maxOf(here, there) + reach[k], k)
    }

    private fun cellToward(position: Double, k: Int): Int {
        val c = floor((position - frame.low[k]) * perLength[k])
        return if (frame.isPeriodic[k]) c.toInt() else c.coerceIn(0.0, count[k] - 1.0).toInt()
    }

    fun head(k: Int): Int = foundHeads[k]

    fun imageOf(k: Int): Int = foundImages[k]

    fun isPresent(e: Int): Boolean = versions[e] == lines.version[slots[e]]

    fun slotOf(e: Int): Int = slots[e]

    fun after(e: Int): Int = next[e]

    private fun grow() {
        versions = versions.copyOf(size * 2)
        next = next.copyOf(size * 2)
        // Last, since its length says how many there is room for.
        slots = slots.copyOf(size * 2)
    }

    companion object {
        const val NONE = -1
        private const val AXES = 3
        private const val INITIAL = 256
        private const val MOST_CELLS_ALONG = 1e3
        private const val SPHERES_A_CELL = 4
        private const val ROOM = 1.05
    }
}
