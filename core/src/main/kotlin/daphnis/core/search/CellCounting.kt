package daphnis.core.search

import daphnis.core.parallel.RangeLoop

/**
 * Counting sort of spheres by the numbers of their cells; those of one cell keep their order. In parallel, each worker
 * counts one part of the spheres; since these are nearly in cell order from the step before, a part covers only a
 * stretch of the cells. Counting and adding up then cost little more than on one thread. Spheres in random order (the
 * first step) are sorted on one thread.
 *
 * The last cell is no part of a stretch. In an epoch it has the spheres that are in no other, which come from all over.
 */
internal class CellCounting {
    // By part: its counts, for cells low..high, and that of the last cell.
    private var counts = arrayOf<IntArray>()
    private var low = IntArray(0)
    private var high = IntArray(0)
    private var lastCount = IntArray(0)
    private var blockStart = IntArray(0)

    /** Finds the cells of the spheres `from` until `to`, and writes them into [CellOrder.cellOf]. */
    fun interface Find {
        fun cells(from: Int, to: Int)
    }

    /** Sorts so many [spheres] into so many [cells], which [find] finds. */
    fun sort(spheres: Int, cells: Int, into: CellOrder, loop: RangeLoop, find: Find) {
        into.reserve(spheres, cells)
        val parts = loop.workers
        if (parts == 1 || spheres < LEAST_IN_PARALLEL) {
            find.cells(0, spheres)
            sortAlone(spheres, cells, into)
            return
        }
        if (low.size != parts) {
            counts = Array(parts) { IntArray(0) }
            high = IntArray(parts)
            lastCount = IntArray(parts)
            blockStart = IntArray(parts + 1)
            // Last, since its length says how many parts there is room for: an allocation before it may have failed.
            low = IntArray(parts)
        }
        val last = cells - 1
        each(parts, loop) { part ->
            find.cells(share(spheres, part, parts), share(spheres, part + 1, parts))
            measure(spheres, last, into, part, parts)
        }
        var stretches = 0L
        for (part in 0 until parts) stretches += high[part] - low[part] + 1
        if (stretches > 2L * cells + spheres) {
            sortAlone(spheres, cells, into)
            return
        }
        each(parts, loop) { count(spheres, last, into, it, parts) }
        each(parts, loop) { block -> blockStart[block + 1] = spheresIn(last, block, parts) }
        for (block in 0 until parts) blockStart[block + 1] += blockStart[block]
        each(parts, loop) { addUp(last, into, it, parts) }
        var next = blockStart[parts]
        into.start[last] = next
        into.start[cells] = spheres
        for (part in 0 until parts) {
            val count = lastCount[part]
            lastCount[part] = next
            next += count
        }
        each(parts, loop) { fill(spheres, last, into, it, parts) }
    }

    private fun each(parts: Int, loop: RangeLoop, phase: (part: Int) -> Unit) {
        loop.run(parts, 1) { _, from, to -> for (part in from until to) phase(part) }
    }

    /** Finds the stretch of cells of [part]. */
    private fun measure(n: Int, last: Int, into: CellOrder, part: Int, parts: Int) {
        var least = last
        var most = -1
        for (k in share(n, part, parts) until share(n, part + 1, parts)) {
            val cell = into.cellOf[k]
            if (cell == last) continue
            least = minOf(least, cell)
            most = maxOf(most, cell)
        }
        low[part] = if (most < 0) 0 else least
        high[part] = most
    }

    private fun count(n: Int, last: Int, into: CellOrder, part: Int, parts: Int) {
        val length = high[part] - low[part] + 1
        if (counts[part].size < length) {
            counts[part] = IntArray(length + length / 4)
        } else {
            counts[part].fill(0, 0, length)
        }
        val counts = counts[part]
        val first = low[part]
        var inLast = 0
        for (k in share(n, part, parts) until share(n, part + 1, parts)) {
            val cell = into.cellOf[k]
            if (cell == last) inLast++ else counts[cell - first]++
        }
        lastCount[part] = inLast
    }

    private fun spheresIn(last: Int, block: Int, parts: Int): Int {
        var sum = 0
        for (part in 0 until parts) {
            val counts = counts[part]
            val from = maxOf(low[part], share(last, block, parts))
            val to = minOf(high[part], share(last, block + 1, parts) - 1)
            for (cell in from..to) sum += counts[cell - low[part]]
        }
        return sum
    }

    /** Turns the counts of the cells in [block] into starts, those of part 0 first. */
    private fun addUp(last: Int, into: CellOrder, block: Int, parts: Int) {
        var next = blockStart[block]
        for (cell in share(last, block, parts) until share(last, block + 1, parts)) {
            into.start[cell] = next
            for (part in 0 until parts) {
                if (cell < low[part] || cell > high[part]) continue
                val counts = counts[part]
                val c = counts[cell - low[part]]
                counts[cell - low[part]] = next
                next += c
            }
        }
    }

    private fun fill(n: Int, last: Int, into: CellOrder, part: Int, parts: Int) {
        val next = counts[part]
        val first = low[part]
        var nextInLast = lastCount[part]
        for (k in share(n, part, parts) until share(n, part + 1, parts)) {
            val cell = into.cellOf[k]
            into.order[if (cell == last) nextInLast++ else next[cell - first]++] = k
        }
    }

    private fun sortAlone(n: Int, cells: Int, into: CellOrder) {
        // Counts go to c + 2, become starts at c + 1, and end as starts at c.
        val start = into.start
        start.fill(0, 0, cells + 2)
        for (k in 0 until n) start[into.cellOf[k] + 2]++
        for (cell in 2..cells) start[cell] += start[cell - 1]
        for (k in 0 until n) into.order[start[into.cellOf[k] + 1]++] = k
    }

    private fun share(size: Int, part: Int, parts: Int): Int = (size.toLong() * part / parts).toInt()

    private companion object {
        const val LEAST_IN_PARALLEL = 4096
    }
}
