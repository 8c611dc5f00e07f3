package daphnis.analysis.streamline

import daphnis.analysis.insitu.State

/** Range of the slabs along y: the box if it is finite, otherwise the particles. */
internal fun strip(state: State): DoubleArray {
    val p = state.population
    val box = state.boundary.box
    if (box.length(1).isFinite()) return doubleArrayOf(box.lower(1), box.lower(1) + box.length(1))
    var least = Double.POSITIVE_INFINITY
    var most = Double.NEGATIVE_INFINITY
    for (k in 0 until p.size) {
        least = minOf(least, p.y[k])
        most = maxOf(most, p.y[k])
    }
    return if (most > least) {
        doubleArrayOf(least, most)
    } else if (p.size == 0) {
        doubleArrayOf(0.0, 1.0)
    } else {
        doubleArrayOf(least, least + 1)
    }
}
