package daphnis.core.engine.horizon

/**
 * Chooses the filter of an epoch. The vector unit is quicker, but the JVM takes a second or so to compile for it, so
 * small systems do not use it before they have shown that they go on.
 *
 * @param quick what is quickest in the end
 * @param always whether it is used from the beginning
 */
internal class FilterChoice(private val quick: LineFilter, private val always: Boolean) {
    private var carried = 0L

    /** Told of each step of [spheres] spheres, in an epoch or not. */
    fun passed(spheres: Int) {
        carried += spheres
    }

    /** The filter for an epoch of [spheres] spheres. */
    fun choose(spheres: Int): LineFilter = if (always || spheres >= LARGE || carried >= LONG) quick else ScalarFilter

    private companion object {
        const val LARGE = 20_000
        const val LONG = 2_000_000L
    }
}
