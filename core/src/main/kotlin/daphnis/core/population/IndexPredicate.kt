package daphnis.core.population

/** Accepts or rejects an index of a [Population]. */
public fun interface IndexPredicate {
    public fun accepts(index: Int): Boolean
}
