package daphnis.core.engine.horizon

import daphnis.core.search.SlotRuns

/**
 * Finds the pairs of lines that come so near, from some time to the end of the epoch, that their spheres may touch.
 *
 * Most candidates are dismissed by [scan], in floats. For spheres a distance **d** apart with relative velocity **u**,
 * s the sum of the inflated radii, b = **d**·**u** and c = d² − s², two lines can come as near as s within a time τ
 * only if c ≤ 0, or if b² ≥ u²c and c ≤ −2bτ. Both are tested with room for the rounding of floats.
 *
 * @param found is told of the pairs that are left, some of which are not near after all
 */
internal class LineSearch(
    private val frame: EpochFrame,
    private val lines: Lines,
    private val cells: EpochCells,
    private val roamers: Roamers,
    private val found: Found,
) : SlotRuns() {
    /** Takes the pairs that a search finds. */
    fun interface Found {
        /** The line in slot [other], at its image [code], may come near that in [slot] from time [from] on. */
        fun pair(slot: Int, other: Int, code: Int, from: Double)
    }

    /** Lines that were tested, and searches, since [begin]. */
    var tested = 0L
        private set
    var searches = 0L
        private set

    // Where the line is now and at the end along row axis, middle axis and slow axis, and how far beside it to look.
    private var here0 = 0.0
    private var here1 = 0.0
    private var here2 = 0.0
    private var there0 = 0.0
    private var there1 = 0.0
    private var there2 = 0.0
    private val margin = DoubleArray(AXES)
    private val least = IntArray(AXES)
    private val most = IntArray(AXES)
    private var time = 0.0

    /** Begins an epoch, whose cells are laid out. */
    fun begin() {
        tested = 0
        searches = 0
        for (k in 0 until AXES) margin[k] = 2 * frame.largestRadius + frame.inflation + cells.reach[k]
    }

    /**
     * Finds, at the start of the epoch, the pairs of each member with members in later slots of its cell and in cells
     * ahead, so that each pair of members, and each image, is found from one of the two.
     */
    fun aheadOfAll() {
        val start = cells.start
        var cell = 0
        for (layer in 0 until cells.count[2]) {
            for (row in 0 until cells.count[1]) {
                val rowStart = cell
                for (c in 0 until cells.count[0]) {
                    for (slot in start[cell] until start[cell + 1]) ahead(slot, rowStart, c, row, layer)
                    cell++
                }
            }
        }
    }

    private fun ahead(slot: Int, rowStart: Int, c: Int, row: Int, layer: Int) {
        cover(slot, 0.0)
        spanRow(layer, 0)
        val last = maxOf(most[0], c)
        val cellsAlong = cells.count[0]
        addRun(slot + 1, cells.start[rowStart + minOf(last, cellsAlong - 1) + 1], 0)
        if (frame.isPeriodic[0] && last >= cellsAlong) addCells(rowStart, cellsAlong, last, 0, 0)
        for (r in row + 1..most[1]) addRow(r, layer)
        for (l in layer + 1..most[2]) {
            for (r in least[1]..most[1]) addRow(r, l)
        }
        scan(slot, NOBODY, hasMoved = false)
    }

    /** Finds the pairs of the line in [slot] from time [from] on with all others, except that in slot [except]. */
    fun around(slot: Int, from: Double, except: Int) {
        cover(slot, from)
        for (layer in least[2]..most[2]) {
            for (row in least[1]..most[1]) addRow(row, layer)
        }
        scan(slot, except, hasMoved = true)
        roamers.forEachNear(slot, from) { other, image ->
            if (other != slot && other != except) found.pair(slot, other, image, from)
        }
    }

    private fun cover(slot: Int, from: Double) {
        count = 0
        searches++
        time = from
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
    }

    private fun span(k: Int, here: Double, there: Double) {
        least[k] = cells.cellToward(Math.min(here, there) - margin[k], k)
        most[k] = cells.cellToward(Math.max(here, there) + margin[k], k)
    }

    /** The cells to be searched in the rows of [layer], as many [boxes] away as the layer that is looked for. */
    private fun spanRow(layer: Int, boxes: Int) {
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
        val layers = cells.count[2]
        var c1 = row
        var c2 = layer
        var middle = 0
        var slow = 0
        if (c1 < 0 || c1 >= rows) {
            middle = Math.floorDiv(c1, rows)
            c1 -= middle * rows
        }
        if (c2 < 0 || c2 >= layers) {
            slow = Math.floorDiv(c2, layers)
            c2 -= slow * layers
        }
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

    /**
     * Tests the runs. At the start of the epoch, when no line [hasMoved], lines are where they begin. Inlined twice
     * with a constant for [hasMoved], of which the compiler keeps one branch.
     */
    @Suppress("NOTHING_TO_INLINE")
    private inline fun scan(slot: Int, except: Int, hasMoved: Boolean) {
        val state = lines.state
        val images = frame.images
        val start = time
        val t = start.toFloat()
        val closing = (CLOSING * (frame.end - start)).toFloat()
        val own = slot * Lines.STRIDE
        val radius = (state[own + Lines.RADIUS] + frame.inflation).toFloat()
        val ownW = state[own + Lines.U + 2]
        val ownZ = if (hasMoved) state[own + 2] + ownW * t else state[own + 2]
        for (r in 0 until count) {
            val code = image[r]
            var ownU = state[own + Lines.U]
            var ownV = state[own + Lines.U + 1]
            var ownX = if (hasMoved) state[own] + ownU * t else state[own]
            var ownY = if (hasMoved) state[own + 1] + ownV * t else state[own + 1]
            var z = ownZ
            if (code != 0) {
                val slideX = images.slide(code, 0)
                val slideY = images.slide(code, 1)
                ownX -= (images.shift(code, 0) + slideX * start).toFloat()
                ownY -= (images.shift(code, 1) + slideY * start).toFloat()
                z -= images.shift(code, 2).toFloat()
                ownU -= slideX.toFloat()
                ownV -= slideY.toFloat()
            }
            var q = from[r] * Lines.STRIDE
            val end = to[r] * Lines.STRIDE
            tested += (end - q) / Lines.STRIDE
            while (q < end) {
                val u = state[q + Lines.U]
                val v = state[q + Lines.U + 1]
                val w = state[q + Lines.U + 2]
                val a = u - ownU
                val b = v - ownV
                val c = w - ownW
                val dx = (if (hasMoved) state[q] + u * t else state[q]) - ownX
                val dy = (if (hasMoved) state[q + 1] + v * t else state[q + 1]) - ownY
                val dz = (if (hasMoved) state[q + 2] + w * t else state[q + 2]) - z
                val s = radius + state[q + Lines.RADIUS]
                val gap = dx * dx + dy * dy + dz * dz - s * s
                val approach = dx * a + dy * b + dz * c
                val late = approach * closing - gap
                val miss = approach * approach * ROUNDING - (a * a + b * b + c * c) * gap
                // Sign bits instead of comparisons: one branch, which nearly always goes the same way.
                val isNear = (late.toRawBits() or miss.toRawBits()) >= 0
                if (isNear || gap <= 0f) {
                    val other = q / Lines.STRIDE
                    if (other != slot && other != except) found.pair(slot, other, code, start)
                }
                q += Lines.STRIDE
            }
        }
    }

    private companion object {
        const val AXES = 3
        const val NOBODY = -1

        /** −2, and 1, with room for the rounding of floats. */
        const val CLOSING = -2 * (1 + 1e-4)
        const val ROUNDING = 1.00001f
    }
}
