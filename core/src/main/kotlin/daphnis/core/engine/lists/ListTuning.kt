package daphnis.core.engine.lists

/**
 * Where lists are used, and how far they reach. It affects only the time that steps take.
 *
 * @param regions among how many regions so many spheres are divided
 * @param suits whether lists are asked for that number of spheres at this filling factor
 */
internal class ListTuning(
    val regions: (spheres: Int) -> Int,
    private val suits: (spheres: Int, fillingFactor: Double) -> Boolean,
) {
    /** Whether so many [spheres] may suit, however dense they are. */
    fun suits(spheres: Int): Boolean = spheres > 0 && suits(spheres, MOST_FILLING)

    fun suits(spheres: Int, fillingFactor: Double): Boolean = suits.invoke(spheres, fillingFactor)

    companion object {
        /** Radius of a shell, in units of the largest radius of a sphere, and see [ListSpace.skin]. */
        const val SHELL = 0.6
        const val SKIN = 0.1

        private const val MOST_FILLING = 1.0
        private const val FEWEST = 100

        private const val DENSE = 0.38
        private const val VERY_DENSE = 0.45

        /** Where regions of several threads pay: filling factor, and number of spheres. */
        private const val DENSE_FOR_REGIONS = 0.43
        private const val MANY = 40_000

        /** Spheres of a region: more do not fit the cache, and of fewer more are at borders. */
        private const val OF_A_REGION = 8000

        /** Nowhere. */
        val NEVER = ListTuning({ 1 }) { _, _ -> false }

        /** Wherever there can be lists. */
        val ALWAYS = ListTuning({ 1 }) { _, _ -> true }

        /** The same in regions of so few spheres. */
        fun always(ofARegion: Int) = ListTuning({ maxOf(1, it / ofARegion) }) { _, _ -> true }

        /**
         * Where they were found to pay on so many [threads]. On one thread, of more spheres rows and lists no longer
         * fit the cache; the thinner the gas, the less is gained. Several threads share many spheres in regions.
         */
        fun best(threads: Int): ListTuning = when (threads) {
            1 -> upTo(12_000, 24_000)
            2 -> upTo(10_000, 16_000, threads)
            else -> upTo(6000, 6000, threads)
        }

        /** Up to so many spheres where they are [dense] or [veryDense], and again where there are many for [threads]. */
        private fun upTo(dense: Int, veryDense: Int, threads: Int = 1) =
            ListTuning({ regions(it, threads) }) { n, filling ->
                n in FEWEST..dense &&
                    filling >= DENSE ||
                    n in FEWEST..veryDense &&
                    filling >= VERY_DENSE ||
                    threads > 1 &&
                    n >= MANY &&
                    filling >= DENSE_FOR_REGIONS
            }

        /** As many for each thread. */
        private fun regions(spheres: Int, threads: Int): Int =
            if (threads == 1 || spheres < MANY) 1 else threads * maxOf(1, spheres / OF_A_REGION / threads)
    }
}
