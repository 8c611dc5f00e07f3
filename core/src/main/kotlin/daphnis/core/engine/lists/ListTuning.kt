package daphnis.core.engine.lists

/**
 * Where lists are used, and how far they reach. It affects only the time that steps take.
 *
 * @param fewest the least number of spheres, [most] the greatest
 * @param leastFilling the least filling factor
 * @param shell radius of a shell, in units of the largest radius of a sphere
 */
internal class ListTuning(val fewest: Int, val most: Int, val leastFilling: Double, val shell: Double) {
    companion object {
        /** Where they have been found to pay. */
        val BEST = ListTuning(fewest = 100, most = 20_000, leastFilling = 0.3, shell = 0.5)

        /** Nowhere. */
        val NEVER = ListTuning(fewest = Int.MAX_VALUE, most = 0, leastFilling = 1.0, shell = 0.5)

        /** Wherever there can be lists. */
        val ALWAYS = ListTuning(fewest = 1, most = Int.MAX_VALUE, leastFilling = 0.0, shell = 0.5)
    }
}
