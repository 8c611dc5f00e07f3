package daphnis.core.engine.horizon

import daphnis.core.search.SlotRuns

/**
 * Finds the pairs of lines that come so near, from some time to the end of the epoch, that their spheres may touch.
 * Most candidates are dismissed by a [LineFilter], in floats.
 *
 * @param giants roamers that are larger than any member
 * @param newRoamers spheres which a group has made roamers in the present step, of which nobody else knows yet
 * @param found is told of the pairs that are left, some of which are not near after all
 */
internal class LineSearch(
    private val frame: EpochFrame,
    private val cells: EpochCells,
    private val roamers: Roamers,
    private val giants: Roamers,
    private val newRoamers: Roamers,
    private val sight: Sight,
    private val found: Found,
) : SlotRuns() {
    /** Takes the pairs that a search finds. */
    fun interface Found {
        /** The line in slot [other], at its image [code], may come near that in [slot] from time [from] on. */
        fun pair(slot: Int, other: Int, code: Int, from: Double)
    }

    /** Lines that were tested since [begin]. */
    var tested = 0L
        private set

    /** Entries of roamers looked at since [begin]. */
    var listed = 0L
        private set

    /** Rows of cells looked at, and pairs found, since [begin]. */
    private var rowsSeen = 0L
    private var told = 0L

    /** All of this since [begin], in the nanoseconds of [EpochCost]. */
    val work: Double
        get() = filter.perRun * rowsSeen + filter.perLine * tested + EpochCost.ROAMER * listed + EpochCost.PAIR * told

    // Where the line is now and at the end along row axis, middle axis and slow axis, and how far beside it to look.
    private var here0 = 0.0
    private var here1 = 0.0
    private var here2 = 0.0
    private var there0 = 0.0
    private var there1 = 0.0
    private var there2 = 0.0
    private val margin = DoubleArray(AXES)
    private var radius = 0.0
    private var filter: LineFilter = ScalarFilter
    private var spannedLayer = -1
    private var spannedBoxes = 0
    private val least = IntArray(AXES)
    private val most = IntArray(AXES)
    private var time = 0.0
    private val lines = sight.now
    private val look = RoamerLook(frame, roamers)
    private val lookAtGiants = RoamerLook(frame, giants)
    private val lookAtNew = RoamerLook(frame, newRoamers)
    private val query = LineQuery(frame)
    private val kept = KeptLines()

    /** Begins an epoch, whose cells are laid out, in which [filter] dismisses lines. */
    fun begin(filter: LineFilter) {
        this.filter = filter
        tested = 0
        listed = 0
        rowsSeen = 0
        told = 0
        for (k in 0 until AXES) margin[k] = frame.memberRadius + frame.inflation + cells.reach[k]
    }

    /** Rows of cells, for [aheadOfRows]. */
    val rows: Int get() = cells.count[1] * cells.count[2]

    /**
     * Finds, at the start of the epoch, the pairs of each member in the rows of cells [first] until [end] with members
     * in later slots of its cell and in cells ahead, so that each pair of members, and each image, is found from one of
     * the two. Ends early when it is more [work] than [most].
     */
    fun aheadOfRows(first: Int, end: Int, most: Double) {
        val start = cells.start
        var cell = first * cells.count[0]
        for (r in first until end) {
            val rowStart = cell
            for (c in 0 until cells.count[0]) {
                for (slot in start[cell] until start[cell + 1]) {
                    // Not for each: where there are few a row, the caller looks as well.
                    if (slot % SLOTS_A_LOOK == 0 && work > most) return
                    ahead(slot, rowStart, c, r % cells.count[1], r / cells.count[1])
                }
                cell++
            }
        }
    }

    private fun ahead(slot: Int, rowStart: Int, c: Int, row: Int, layer: Int) {
        cover(slot, frame.start)
        spanRow(layer, 0)
        val last = maxOf(most[0], c)
        val cellsAlong = cells.count[0]
        addRun(slot + 1, cells.start[rowStart + minOf(last, cellsAlong - 1) + 1], 0)
        if (frame.isPeriodic[0] && last >= cellsAlong) addCells(rowStart, cellsAlong, last, 0, 0)
        for (r in row + 1..most[1]) addRow(r, layer)
        for (l in layer + 1..most[2]) {
            for (r in least[1]..most[1]) addRow(r, l)
        }
        scan(slot, NOBODY)
    }

    /** Finds, at the start of the epoch, the pairs of the roamer in [slot] with all members, and roamers before it. */
    fun aheadOfRoamer(slot: Int) {
        aroundMembers(slot, frame.start, NOBODY)
        look.forEachNear(lines, slot, frame.start) { e, image ->
            countListed()
            val other = roamers.slotOf(e)
            if (other < slot) pair(slot, other, image)
        }
        lookAtGiants.forEachNear(lines, slot, frame.start) { e, image ->
            countListed()
            val other = giants.slotOf(e)
            if (other < slot) pair(slot, other, image)
        }
    }

    private fun aroundMembers(slot: Int, from: Double, except: Int) {
        cover(slot, from)
        for (layer in least[2]..most[2]) {
            for (row in least[1]..most[1]) addRow(row, layer)
        }
        scan(slot, except)
    }

    /** Finds the pairs of the line in [slot] from time [from] on with all others, except that in slot [except]. */
    fun around(slot: Int, from: Double, except: Int) {
        aroundMembers(slot, from, except)
        look.forEachNear(lines, slot, from) { e, image ->
            countListed()
            val other = roamers.slotOf(e)
            if (other != slot && other != except && roamers.isPresent(e, sight.of(other))) {
                pair(slot, other, image)
            }
        }
        lookAtGiants.forEachNear(lines, slot, from) { e, image ->
            countListed()
            val other = giants.slotOf(e)
            if (other != slot && other != except && giants.isPresent(e, sight.of(other))) {
                pair(slot, other, image)
            }
        }
        lookAtNew.forEachNear(lines, slot, from) { e, image ->
            countListed()
            val other = newRoamers.slotOf(e)
            if (other != slot && other != except && newRoamers.isPresent(e, lines)) {
                pair(slot, other, image)
            }
        }
    }

    private fun countListed() {
        listed++
    }

    private fun cover(slot: Int, from: Double) {
        clear()
        spannedLayer = -1
        time = from
        radius = lines.radius(slot)
        val axes = frame.axes
        val end = frame.end
        here0 = lines.at(slot, axes[0], from)
        here1 = lines.at(slot, axes[1], from)
        here2 = lines.at(slot, axes[2], from)
        there0 = lines.at(slot, axes[0], end)
        there1 = lines.at(slot, axes[1], end)
        there2 = lines.at(slot, axes[2], end)
        span(1, here1, there1)
        span(2, here2, there2)
        rowsSeen += (most[1] - least[1] + 1L) * (most[2] - least[2] + 1)
    }

    private fun span(k: Int, here: Double, there: Double) {
        least[k] = cells.cellToward(Math.min(here, there) - margin[k] - radius, k)
        most[k] = cells.cellToward(Math.max(here, there) + margin[k] + radius, k)
    }

    /** The cells to be searched in the rows of [layer], as many [boxes] away as the layer that is looked for. */
    private fun spanRow(layer: Int, boxes: Int) {
        if (layer == spannedLayer && boxes == spannedBoxes) return
        spannedLayer = layer
        spannedBoxes = boxes
        val drift = cells.flow[layer]
        var now = here0 - drift * (time - frame.middle)
        var later = there0 - drift * (frame.end - frame.middle)
        if (boxes != 0 && frame.slides) {
            now -= boxes * frame.offset(time)
            later -= boxes * frame.offset(frame.end)
        }
        span(0, now, later)
    }

    /** Adds the cells in the row ([row], [layer]), which may lie beyond a face. */
    private fun addRow(row: Int, layer: Int) {
        val rows = cells.count[1]
        val middle = cells.boxes(row, 1)
        val slow = cells.boxes(layer, 2)
        val c1 = row - middle * rows
        val c2 = layer - slow * cells.count[2]
        spanRow(c2, slow)
        val rowStart = (c2 * rows + c1) * cells.count[0]
        val first = least[0]
        val last = most[0]
        if (first >= 0 && last < cells.count[0]) {
            val code = if ((middle or slow) == 0) 0 else frame.code(0, middle, slow)
            addRun(cells.start[rowStart + first], cells.start[rowStart + last + 1], code)
        } else {
            addCells(rowStart, first, last, middle, slow)
        }
    }

    /** Adds the cells [first]..[last] of a periodic row, split where an image begins. */
    private fun addCells(rowStart: Int, first: Int, last: Int, middle: Int, slow: Int) {
        val count0 = cells.count[0]
        var c = first
        while (c <= last) {
            val along = Math.floorDiv(c, count0)
            val end = minOf(last, (along + 1) * count0 - 1)
            val base = rowStart - along * count0
            addRun(cells.start[base + c], cells.start[base + end + 1], frame.code(along, middle, slow))
            c = end + 1
        }
    }

    /** Tests the runs. */
    private fun scan(slot: Int, except: Int) {
        query.begin(lines, slot, time)
        kept.clear()
        var code = 0
        for (r in 0 until size) {
            if (image[r] != code) {
                tell(slot, except, code)
                code = image[r]
                query.toward(code)
            }
            val first = from[r]
            val end = to[r]
            tested += end - first
            sight.forEachPart(first, end) { lines, a, b -> filter.near(lines.state, query, a, b, kept) }
        }
        tell(slot, except, code)
    }

    /** Tells of the lines that were kept, which are at the image [code], and forgets them. */
    private fun tell(slot: Int, except: Int, code: Int) {
        kept.forEach { other -> if (other != slot && other != except) pair(slot, other, code) }
        kept.clear()
    }

    private fun pair(slot: Int, other: Int, code: Int) {
        told++
        found.pair(slot, other, code, time)
    }

    private companion object {
        const val AXES = 3
        const val NOBODY = -1

        /** Of how many slots one looks at the work. */
        const val SLOTS_A_LOOK = 16
    }
}
