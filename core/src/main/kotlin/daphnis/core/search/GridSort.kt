package daphnis.core.search

/**
 * How a [Grid] sorts spheres into cells. The result is the same: by cell, and within a cell by the previous order of
 * the population.
 */
public enum class GridSort {
    /** Counting sort; in parallel each worker counts a part of the population, and the counts are combined. */
    COUNTING,

    /**
     * The paper's method: every worker hangs spheres into the lists of their cells while it holds the lock of the row.
     */
    ROW_LOCKS,
}
