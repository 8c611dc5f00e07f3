package daphnis.actors.region

/** How space is divided into regions. Any division gives the same bits. */
public sealed class RegionLayout {
    /** Number of regions. */
    public abstract val count: Int

    /**
     * [count] stretches of the order of cells with equally many spheres each: slabs across the slow axis of the grid,
     * however the spheres are distributed in space.
     */
    public data class Stretches(override val count: Int) : RegionLayout() {
        init {
            requireCount(count)
        }
    }

    /** Equal boxes: [x] · [y] · [z] of them fill the space that the spheres occupy. */
    public data class Blocks(val x: Int, val y: Int, val z: Int) : RegionLayout() {
        override val count: Int get() = x * y * z

        init {
            require(x > 0 && y > 0 && z > 0) { "blocks along x, y, z are $x, $y, $z; each must be > 0" }
            requireCount(count)
        }
    }

    public companion object {
        /** Most regions. */
        public const val MOST: Int = 4096

        private const val SPHERES_A_REGION = 2000

        private fun requireCount(count: Int) {
            require(count in 1..MOST) { "number of regions is $count; it must be in 1..$MOST" }
        }

        /**
         * A layout that suits [spheres] and [threads]: a region for each thread, since borders cost more than uneven
         * regions, but none too small.
         */
        @JvmStatic
        public fun of(spheres: Int, threads: Int): RegionLayout = Stretches(
            minOf(
                threads,
                spheres / SPHERES_A_REGION,
            ).coerceIn(1, MOST),
        )
    }
}
