package daphnis.core.search

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/**
 * Counting sort by cell. In parallel, each worker counts one part of the population; since a population is nearly in
 * cell order from the step before, a part covers only a stretch of the cells. Counting and adding up then cost little
 * more than on one thread. A population in random order (the first step) is sorted on one thread.
 */
internal class CountingSort : CellSort {
    // By part: its counts, for cells low..high.
    private var counts = arrayOf<IntArray>()
    private var low = IntArray(0)
    private var high = IntArray(0)
    private var blockStart = IntArray(0)

    override fun sort(population: SphereColumns, levels: GridLevels, into: CellOrder, loop: RangeLoop) {
        val n = population.size
        val total = levels.cellCount
        into.reserve(n, total)
        val parts = loop.workers
        if (parts == 1 || n < LEAST_IN_PARALLEL) {
            findCells(population, levels, into, 0, n)
            sortAlone(n, total, into)
            return
        }
        if (low.size != parts) {
            low = IntArray(parts)
            high = IntArray(parts)
            counts = Array(parts) { IntArray(0) }
            blockStart = IntArray(parts + 1)
        }
        loop.run(parts, 1) { _, from, to ->
            for (part in from until to) findPart(population, levels, into, part, parts)
        }
        var stretches = 0L
        for (part in 0 until parts) stretches += high[part] - low[part] + 1
        if (stretches > 2L * total + n) {
            sortAlone(n, total, into)
            return
        }
        loop.run(parts, 1) { _, from, to -> for (part in from until to) count(n, into, part, parts) }
        loop.run(parts, 1) { _, from, to ->
            for (block in from until to) {
                blockStart[block + 1] =
                    spheresIn(total, block, parts)
            }
        }
        for (block in 0 until parts) blockStart[block + 1] += blockStart[block]
        loop.run(parts, 1) { _, from, to -> for (block in from until to) addUp(total, into, block, parts) }
        into.start[total] = n
        loop.run(parts, 1) { _, from, to -> for (part in from until to) fill(n, into, part, parts) }
    }

    private fun findPart(population: SphereColumns, levels: GridLevels, into: CellOrder, part: Int, parts: Int) {
        val n = population.size
        findCells(population, levels, into, share(n, part, parts), share(n, part + 1, parts))
        var least = Int.MAX_VALUE
        var most = -1
        for (k in share(n, part, parts) until share(n, part + 1, parts)) {
            least = minOf(least, into.cellOf[k])
            most = maxOf(most, into.cellOf[k])
        }
        low[part] = least
        high[part] = most
    }

    private fun count(n: Int, into: CellOrder, part: Int, parts: Int) {
        val length = high[part] - low[part] + 1
        if (counts[part].size < length) {
            counts[part] = IntArray(length + length / 4)
        } else {
            counts[part].fill(0, 0, length)
        }
        val counts = counts[part]
        val first = low[part]
        for (k in share(n, part, parts) until share(n, part + 1, parts)) counts[into.cellOf[k] - first]++
    }

    private fun spheresIn(total: Int, block: Int, parts: Int): Int {
        var sum = 0
        for (part in 0 until parts) {
            val counts = counts[part]
            for (cell in maxOf(
                low[part],
                share(total, block, parts),
            )..minOf(high[part], share(total, block + 1, parts) - 1)) {
                sum += counts[cell - low[part]]
            }
        }
        return sum
    }

    /** Turns the counts of the cells in [block] into starts, those of part 0 first. */
    private fun addUp(total: Int, into: CellOrder, block: Int, parts: Int) {
        var next = blockStart[block]
        for (cell in share(total, block, parts) until share(total, block + 1, parts)) {
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

    private fun fill(n: Int, into: CellOrder, part: Int, parts: Int) {
        val next = counts[part]
        val first = low[part]
        for (k in share(n, part, parts) until share(n, part + 1, parts)) into.order[next[into.cellOf[k] - first]++] = k
    }

    private fun sortAlone(n: Int, total: Int, into: CellOrder) {
        // Counts go to c + 2, become starts at c + 1, and end as starts at c.
        val start = into.start
        start.fill(0, 0, total + 2)
        for (k in 0 until n) start[into.cellOf[k] + 2]++
        for (cell in 2..total) start[cell] += start[cell - 1]
        for (k in 0 until n) into.order[start[into.cellOf[k] + 1]++] = k
    }

    private fun share(size: Int, part: Int, parts: Int): Int = (size.toLong() * part / parts).toInt()

    private companion object {
        const val LEAST_IN_PARALLEL = 4096
    }
}
