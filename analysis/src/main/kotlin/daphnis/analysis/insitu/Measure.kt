package daphnis.analysis.insitu

/**
 * Something that turns a state into numbers, always equally many. Everything in this module that can be averaged is
 * one.
 */
public fun interface Measure {
    /** The numbers of [state], which stays as it is. */
    public fun of(state: State): DoubleArray
}

/**
 * A measure whose numbers follow from sums over the particles of all states together, not from numbers of each state:
 * the mean over the particles of a bin that is empty in some states, or their variance. What is averaged are the
 * [sums]; [finish] comes after.
 */
public interface PooledMeasure : Measure {
    /** The sums of [state], to be added to those of other states. */
    public fun sums(state: State): DoubleArray

    /**
     * The numbers that follow from [sums] over [states] states; NaN where these tell nothing. A new array; [sums] stays
     * as it is.
     */
    public fun finish(sums: DoubleArray, states: Int): DoubleArray

    override fun of(state: State): DoubleArray = finish(sums(state), 1)
}
