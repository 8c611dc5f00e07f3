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

        /** Of more, rows and lists no longer fit the cache; the thinner the gas, the less is gained. */
        private const val FEW = 6000
        private const val MANY = 12_000
        private const val DENSE = 0.38
        private const val VERY_DENSE = 0.45

        /** Nowhere. */
        val NEVER = ListTuning(SHELL) { _, _ -> false }

        /** Wherever there can be lists. */
        val ALWAYS = ListTuning(SHELL) { _, _ -> true }

        /** Where they were found to pay on so many [threads]: others share work among two, from some thousand on. */
        fun best(threads: Int): ListTuning = when (threads) {
            1 -> ListTuning(SHELL) { n, filling ->
                n in FEWEST..FEW && filling >= DENSE || n in FEW..MANY && filling >= VERY_DENSE
            }
            2 -> ListTuning(SHELL) { n, filling -> n in FEWEST..FEW && filling >= DENSE }
            else -> NEVER
        }
    }
}
