package daphnis.analysis.report

import daphnis.analysis.streamline.Streamlines

/**
 * The parts of some [lines] where they do not cross: in each slab the mean places of the [drawn] groups, which are
 * sorted by guiding centre, must be in the same order.
 */
internal class StreamlineRuns(private val lines: Streamlines, private val drawn: List<Int>) {
    /** Groups with consecutive slabs, two or more, in which they are to be drawn. */
    val list: List<Pair<Int, List<Int>>>

    /** How much of the length of all lines these are. */
    val part: Double

    init {
        val runs = ArrayList<Pair<Int, List<Int>>>()
        var known = 0
        for ((k, g) in drawn.withIndex()) {
            var run = ArrayList<Int>()
            for (slab in 0 until lines.slabs) {
                if (x(slab, k).isNaN()) continue
                known++
                if (crosses(slab, k)) {
                    runs += g to run
                    run = ArrayList()
                } else {
                    run += slab
                }
            }
            runs += g to run
        }
        list = runs.filter { it.second.size > 1 }
        part = if (known == 0) 0.0 else list.sumOf { it.second.size } / known.toDouble()
    }

    private fun x(slab: Int, k: Int): Double = lines.meanX[lines.at(slab, drawn[k])]

    /** Whether line [k] of the drawn is out of order with the one before it or the one behind it. */
    private fun crosses(slab: Int, k: Int): Boolean =
        k > 0 && x(slab, k - 1) > x(slab, k) || k < drawn.lastIndex && x(slab, k + 1) < x(slab, k)
}
