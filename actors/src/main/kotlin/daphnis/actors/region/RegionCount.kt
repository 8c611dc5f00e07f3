package daphnis.actors.region

/** How many regions an engine has. Any number gives the same bits. */
internal object RegionCount {
    /** Most regions that may be asked for. */
    const val MOST = 4096

    /** Spheres of a region at least, where the engine chooses. */
    private const val SPHERES = 2000

    /** Most regions that are made where threads are fewer: each has a group of spheres, which takes memory. */
    private const val MOST_GROUPS = 32

    /** @throws IllegalArgumentException when so many must not be [asked] for; 0 leaves it to the engine */
    fun requireValid(asked: Int) {
        require(asked in 0..MOST) { "number of regions is $asked; it must be in 1..$MOST, or 0 for what suits" }
    }

    /**
     * How many are made for [spheres] and [threads] when so many are [asked] for: by default one for each thread, but
     * none too small.
     */
    fun of(asked: Int, spheres: Int, threads: Int): Int = if (asked ==
        0
    ) {
        minOf(threads, spheres / SPHERES).coerceIn(1, MOST)
    } else {
        minOf(asked, maxOf(threads, MOST_GROUPS))
    }
}
