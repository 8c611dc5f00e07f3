package daphnis.core.engine.lists

/**
 * Where lists are used, and how far they reach. It affects only the time that steps take.
 *
 * @param shell radius of a shell, in units of the largest radius of a sphere
 * @param suits whether lists are asked for that number of spheres at this filling factor
 */
internal class ListTuning(val shell: Double, private val suits: (spheres: Int, fillingFactor: Double) -> Boolean) {
    /** Whether so many [spheres] may suit, however dense they are. */
    fun suits(spheres: Int): Boolean = spheres > 0 && suits(spheres, MOST_FILLING)

    fun suits(spheres: Int, fillingFactor: Double): Boolean = suits.invoke(spheres, fillingFactor)

    companion object {
        /** In units of the largest radius. */
        private const val SHELL = 0.6
        private const val MOST_FILLING = 1.0
        private const val FEWEST = 100

        private const val DENSE = 0.38
        private const val VERY_DENSE = 0.45

        /** Nowhere. */
        val NEVER = ListTuning(SHELL) { _, _ -> false }

        /** Wherever there can be lists. */
        val ALWAYS = ListTuning(SHELL) { _, _ -> true }

        /**
         * Where they were found to pay on so many [threads]. Of more spheres, rows and lists no longer fit the cache;
         * the thinner the gas, the less is gained. Others share work among threads, from 10,000 spheres on. With three
         * and more threads they were compared with one thread only.
         */
        fun best(threads: Int): ListTuning = when (threads) {
            1 -> upTo(12_000, 24_000)
            2 -> upTo(10_000, 16_000)
            else -> upTo(6000, 6000)
        }

        /** Up to so many spheres where they are [dense] or [veryDense]. */
        private fun upTo(dense: Int, veryDense: Int) = ListTuning(SHELL) { n, filling ->
            n in FEWEST..dense && filling >= DENSE || n in FEWEST..veryDense && filling >= VERY_DENSE
        }
    }
}
