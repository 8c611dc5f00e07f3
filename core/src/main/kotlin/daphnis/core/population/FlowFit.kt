package daphnis.core.population

/**
 * The measured mean flow of a population, and the second moments of the velocities minus this flow, which are the
 * *peculiar velocities* c.
 *
 * Along the flow's axis the mean flow is the straight line across the flow that fits best, plus the mean of the
 * remainder in slabs of equal width across it (one per [SPHERES_A_SLAB] spheres, at most [MOST_SLABS]), since a driven
 * flow need not be straight. Along the other axes, and where no flow is driven, it is the mean. A line needs three
 * spheres and a distance between them; with less it is the boundary's line.
 *
 * The fit takes degrees of freedom away: 1 from each component, and 1 + S − R² from the one along the flow, with S
 * slabs, where R² is the part of Σ m y² that is between them (the trace of the product of both projections). ⟨c_a c_b⟩
 * is multiplied by N over the remaining number, so that it has no bias at any number of spheres. This is exact where
 * masses are equal, or where energy is shared equally among unequal ones. When no degrees of freedom remain, it is 0.
 *
 * The fit uses sums weighted by mass. w is the velocity without the boundary's straight flow and without the mean; y is
 * the position across the flow minus its mean.
 */
internal class FlowFit(private val flowAxis: Int) {
    /** Σ m w_a w_b: xx, yy, zz, xy, xz, yz. */
    val squares = DoubleArray(6)

    /** Σ m y². */
    var across = 0.0

    /** Σ m y w_a. */
    val slopes = DoubleArray(3)

    /** [SLAB_WIDTH] numbers per slab: Σ m at [MASS], Σ m y at [OFFSET], and Σ m w along x, y, z from [MOMENTUM] on. */
    val slabs = DoubleArray(MOST_SLABS * SLAB_WIDTH)

    /** ⟨c_a c_b⟩: xx, yy, zz, xy, xz, yz. */
    val moments = DoubleArray(6)

    /** Fills [moments] from the sums over [count] spheres of [mass] together, in [slabCount] slabs. */
    fun solve(count: Int, mass: Double, slabCount: Int) {
        squares.copyInto(moments)
        val isFitted = flowAxis >= 0 && count > 2 && across > 0
        val taken = if (isFitted) takeOutFlow(slabCount) else 1.0
        for (e in 0 until 6) {
            val left = count - if (FIRST[e] == flowAxis || SECOND[e] == flowAxis) taken else 1.0
            moments[e] = if (left < LEAST_LEFT) 0.0 else moments[e] / mass * (count / left)
            if (e < 3) moments[e] = maxOf(0.0, moments[e])
        }
    }

    /**
     * Takes the line s y and then the means of the slabs out of the velocity along the flow.
     *
     * @return degrees of freedom that the fit has taken from the component along the flow
     */
    private fun takeOutFlow(slabCount: Int): Double {
        val slope = slopes[flowAxis] / across
        // Σ m (w_a − s y) w_b = Σ m w_a w_b − s Σ m y w_b, and as much for the square, since s Σ m y² = Σ m y w_a.
        reduce { slope * slopes[it] }
        var filled = 0
        var between = 0.0
        for (slab in 0 until slabCount) {
            val s = slab * SLAB_WIDTH
            val mass = slabs[s + MASS]
            if (mass == 0.0) continue
            filled++
            between += slabs[s + OFFSET] * slabs[s + OFFSET] / mass
            val rest = slabs[s + MOMENTUM + flowAxis] - slope * slabs[s + OFFSET]
            reduce { rest / mass * (if (it == flowAxis) rest else slabs[s + MOMENTUM + it]) }
        }
        return 1.0 + filled - between / across
    }

    /**
     * Takes from each moment that has the flow's component what [amount] gives for its other component, which in the
     * square is the flow's own.
     */
    private inline fun reduce(amount: (other: Int) -> Double) {
        for (e in 0 until 6) {
            if (FIRST[e] == flowAxis) {
                moments[e] -= amount(SECOND[e])
            } else if (SECOND[e] == flowAxis) {
                moments[e] -= amount(FIRST[e])
            }
        }
    }

    companion object {
        const val SPHERES_A_SLAB = 100
        const val MOST_SLABS = 20
        const val SLAB_WIDTH = 5
        const val MASS = 0
        const val OFFSET = 1
        const val MOMENTUM = 2

        /** Axes of xx, yy, zz, xy, xz, yz. */
        val FIRST = intArrayOf(0, 1, 2, 0, 0, 1)
        val SECOND = intArrayOf(0, 1, 2, 1, 2, 2)

        /** Degrees of freedom are whole numbers except for the part between slabs; less than this counts as none. */
        private const val LEAST_LEFT = 0.5
    }
}
