package daphnis.app.sweep

/** Seeds as they are given: numbers and ranges with commas between, `1..8` or `1,5,100..103`. */
internal object Seeds {
    /** The most seeds of a sweep. */
    const val MOST = 10_000

    /** @throws IllegalArgumentException with what is wrong, as the end of a sentence that begins with the option */
    fun parse(text: String): List<Long> {
        val seeds = LinkedHashSet<Long>()
        for (part in text.split(',')) {
            val ends = part.split("..").map { it.trim().toLongOrNull() }
            val first = ends.first()
            val last = ends.last()
            require(ends.size <= 2 && first != null && last != null) {
                "is '$text'; whole numbers and ranges are needed, such as 1..8 or 1,5,100..103"
            }
            require(first <= last) { "is '$text'; the range '${part.trim()}' runs backward" }
            require(last - first in 0 until MOST) { "is '$text'; at most $MOST seeds are possible" }
            for (seed in first..last) require(seeds.add(seed)) { "is '$text', which has the seed $seed twice" }
        }
        require(seeds.size <= MOST) { "is '$text'; at most $MOST seeds are possible" }
        return seeds.toList()
    }
}
