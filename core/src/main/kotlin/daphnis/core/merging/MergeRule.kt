package daphnis.core.merging

import kotlin.math.sqrt

/**
 * Which impacts merge two spheres into one. The sphere that is left has the mass, momentum, centre of mass and volume
 * of both, and with spins their angular momentum. It keeps the id and the material of the larger one, of two as large
 * those of the heavier, and of equals those of the lower id.
 *
 * Immutable, and a pure function of what it is asked: engines may ask several times, from several threads. It must not
 * depend on which sphere is first.
 */
public fun interface MergeRule {
    /**
     * Whether two spheres merge that meet with the relative speed [speed] of their centres, all of it and not only along
     * the normal.
     *
     * @param mass of both together
     * @param distance of their centres, the sum of the radii
     */
    public fun merges(speed: Double, mass: Double, distance: Double): Boolean

    public companion object {
        /** Every impact. */
        @JvmStatic
        public fun always(): MergeRule = MergeRule { _, _, _ -> true }

        /**
         * Impacts slower than [most].
         *
         * @throws IllegalArgumentException unless it is > 0
         */
        @JvmStatic
        public fun below(most: Double): MergeRule {
            require(most > 0 && most.isFinite()) { "spheres merge below the speed $most; it must be > 0" }
            return MergeRule { speed, _, _ -> speed < most }
        }

        /**
         * Impacts slower than [factor] times the speed of escape √(2 G m/d) of the two from each other.
         *
         * @param gravitationalConstant G
         * @throws IllegalArgumentException unless both are > 0
         */
        @JvmStatic
        public fun belowEscape(gravitationalConstant: Double, factor: Double): MergeRule {
            require(gravitationalConstant > 0 && gravitationalConstant.isFinite()) {
                "the gravitational constant is $gravitationalConstant; it must be > 0"
            }
            require(factor > 0 && factor.isFinite()) { "spheres merge below $factor speeds of escape; it must be > 0" }
            return MergeRule { speed, mass, distance ->
                speed < factor * sqrt(2 * gravitationalConstant * mass / distance)
            }
        }
    }
}
