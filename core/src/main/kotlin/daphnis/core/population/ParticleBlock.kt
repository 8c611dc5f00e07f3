package daphnis.core.population

/**
 * The indices of the particles, without bodies, among at most [SPHERES] spheres of a population. The number is such
 * that columns of terms by place in the block stay in the cache.
 *
 * @param firstBody spheres with this id or a higher one are bodies; [Int.MAX_VALUE] for none
 */
internal class ParticleBlock(private val firstBody: Int) {
    /** The indices of the first [size] entries. */
    val index = IntArray(SPHERES)

    /** Number of particles. */
    var size = 0
        private set

    /** Takes over the particles of [population] at the indices [from] until [to]. */
    fun collect(population: Population, from: Int, to: Int) {
        val id = population.id
        var n = 0
        for (k in from until to) {
            index[n] = k
            if (!isBody(id[k])) n++
        }
        size = n
    }

    fun isBody(id: Int): Boolean = id >= firstBody && firstBody != Int.MAX_VALUE

    companion object {
        const val SPHERES = 1024

        /** Calls [block] with the ranges of at most [SPHERES] indices that make up [from] until [to]. */
        inline fun forEach(from: Int, to: Int, block: (from: Int, to: Int) -> Unit) {
            var start = from
            while (start < to) {
                val end = minOf(start + SPHERES.toLong(), to.toLong()).toInt()
                block(start, end)
                start = end
            }
        }
    }
}
