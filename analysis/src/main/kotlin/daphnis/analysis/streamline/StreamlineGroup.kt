package daphnis.analysis.streamline

/** Statistics over a run of the indices [members]: the particles of one group. */
internal class StreamlineGroup(private val members: IntArray) {
    private var first = 0
    private var end = 0

    val size: Int get() = end - first

    /** Selects the members from place [first] until [end]. */
    fun span(first: Int, end: Int) {
        this.first = first
        this.end = end
    }

    inline fun sum(value: (Int) -> Double): Double {
        var sum = 0.0
        for (m in first until end) sum += value(members[m])
        return sum
    }

    inline fun mean(value: (Int) -> Double): Double = sum(value) / size

    inline fun least(value: (Int) -> Double): Double {
        var least = Double.POSITIVE_INFINITY
        for (m in first until end) least = Math.min(least, value(members[m]))
        return least
    }

    /** Sum of squares around the mean over the number less one; NaN for fewer than two. */
    inline fun variance(value: (Int) -> Double): Double {
        if (size < 2) return Double.NaN
        val mean = mean(value)
        var square = 0.0
        for (m in first until end) {
            val d = value(members[m]) - mean
            square += d * d
        }
        return square / (size - 1)
    }
}
