package daphnis.core.search

/**
 * How a [Grid] sorts spheres into cells. The result is the same: by cell, within a cell by the order that the
 * population came in.
 */
public enum class GridSort {
    /** Counting sort; in parallel each worker counts a part of the population and the counts are put together. */
    COUNTING,

    /**
     * The paper's: every worker hangs spheres into the lists of their cells and holds the lock of the row meanwhile.
     */
    ROW_LOCKS,
}
