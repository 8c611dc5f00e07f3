package daphnis.drills

/**
 * How a measured quantity grows, the first sixth left out. Medians of sixths are compared: [whole] is the last less the
 * second; [steady] is what their typical (lower median) increase makes over all of them, which one jump, as of an array
 * that is made larger, does not move. Both are 0 where there are too few [values] to say.
 */
internal class Growth private constructor(val steady: Long, val whole: Long) {
    companion object {
        fun of(values: List<Long>): Growth {
            val size = values.size / PARTS
            if (size == 0) return Growth(0, 0)
            val parts = values.takeLast(size * (PARTS - 1)).chunked(size) { part -> part.sorted()[size / 2] }
            val increases = parts.zipWithNext { before, after -> after - before }
            val typical = increases.sorted()[(increases.size - 1) / 2]
            return Growth(typical * increases.size, parts.last() - parts.first())
        }

        private const val PARTS = 6
    }
}
