package daphnis.core.engine.horizon

import daphnis.core.growth.GrowingTable

/** Looks among [roamers] for those that may come near a line. Each thread has its own. */
internal class RoamerLook(private val frame: EpochFrame, private val roamers: Roamers) : GrowingTable() {
    // The cells that are looked through, which may lie beyond periodic faces, and the lists found there.
    private val least = IntArray(AXES)
    private val most = IntArray(AXES)
    private var radius = 0.0
    private var foundHeads = IntArray(0)
    private var foundImages = IntArray(0)

    override fun resize(room: Int) {
        foundHeads = foundHeads.copyOf(room)
        foundImages = foundImages.copyOf(room)
    }

    /**
     * Calls [use] for each entry, and its image, that may come near the line in [slot] of [lines] from time [from] on;
     * for entries of old lines, too.
     */
    inline fun forEachNear(lines: Lines, slot: Int, from: Double, use: (entry: Int, image: Int) -> Unit) {
        if (isEmpty()) return
        val lists = lists(lines, slot, from)
        for (k in 0 until lists) {
            var e = head(k)
            while (e != Roamers.NONE) {
                use(e, imageOf(k))
                e = after(e)
            }
        }
    }

    fun isEmpty(): Boolean = roamers.size == 0

    fun head(k: Int): Int = foundHeads[k]

    fun imageOf(k: Int): Int = foundImages[k]

    fun after(e: Int): Int = roamers.after(e)

    /** Notes the lists, not empty, of all cells that the line in [slot] can reach from time [from] on. */
    fun lists(lines: Lines, slot: Int, from: Double): Int {
        clear()
        radius = lines.radius(slot)
        val count = roamers.cells.count
        for (k in 1 until AXES) {
            val axis = frame.axes[k]
            span(k, lines.at(slot, axis, from), lines.at(slot, axis, frame.end))
        }
        for (layer in least[2]..most[2]) {
            val slow = roamers.cells.boxes(layer, 2)
            val c2 = layer - slow * count[2]
            spanRow(lines, slot, from, c2, slow)
            for (row in least[1]..most[1]) {
                val middle = roamers.cells.boxes(row, 1)
                val rowStart = (c2 * count[1] + row - middle * count[1]) * count[0]
                for (c in least[0]..most[0]) {
                    val along = roamers.cells.boxes(c, 0)
                    val e = roamers.head(rowStart + c - along * count[0])
                    if (e != Roamers.NONE) note(e, frame.code(along, middle, slow))
                }
            }
        }
        return size
    }

    private fun note(e: Int, code: Int) {
        val k = append()
        foundHeads[k] = e
        foundImages[k] = code
    }

    /** The cells of the rows of layer [c2], at its image [boxes] away. */
    private fun spanRow(lines: Lines, slot: Int, from: Double, c2: Int, boxes: Int) {
        val axis = frame.axes[0]
        val flow = roamers.flow[c2]
        var here = lines.at(slot, axis, from) - flow * (from - frame.middle)
        var there = lines.at(slot, axis, frame.end) - flow * (frame.end - frame.middle)
        if (boxes != 0 && frame.slides) {
            here -= boxes * frame.offset(from)
            there -= boxes * frame.offset(frame.end)
        }
        span(0, here, there)
    }

    private fun span(k: Int, here: Double, there: Double) {
        least[k] = roamers.cells.cellToward(minOf(here, there) - roamers.reach[k] - radius, k)
        most[k] = roamers.cells.cellToward(maxOf(here, there) + roamers.reach[k] + radius, k)
    }

    private companion object {
        const val AXES = 3
    }
}
