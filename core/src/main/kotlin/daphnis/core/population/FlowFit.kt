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

    /** By slab: Σ m, Σ m y, Σ m w_x, Σ m w_y, Σ m w_z. */
    val slabs = DoubleArray(MOST_SLABS * SLAB_WIDTH)

    /** ⟨c_a c_b⟩: xx, yy, zz, xy, xz, yz. */
    val moments = DoubleArray(6)

    /** Fills [moments] from the sums over [count] spheres of [mass] together, in [slabCount] slabs. */
    fun solve(count: Int, mass: Double, slabCount: Int) {
        squares.copyInto(moments)
        var taken = 1.0
        if (flowAxis >= 0 && count > 2 && across > 0) taken = takeOutFlow(slabCount)
        for (e in 0 until 6) {
            val left = count - if (FIRST[e] == flowAxis || SECOND[e] == flowAxis) taken else 1.0
            moments[e] = if (left < LEAST_LEFT) 0.0 else moments[e] / mass * (count / left)
            if (e < 3) moments[e] = maxOf(0.0, moments[e])
        }
    }

    /** @return degrees of freedom that the fit has taken from the component along the flow */
    private fun takeOutFlow(slabCount: Int): Double {
        val slope = slopes[flowAxis] / across
        for (e in 0 until 6) {
            // Twice in the square of the component itself, of which one half comes back: Σ m (w − s y)² = Σ m w² − s Σ
            // m y w.
            val other = otherThanFlow(e)
            if (other >= 0) moments[e] -= slope * slopes[other]
        }
        var filled = 0
        var between = 0.0
        for (slab in 0 until slabCount) {
            val s = slab * SLAB_WIDTH
            val mass = slabs[s]
            if (mass == 0.0) continue
            filled++
            between += slabs[s + 1] * slabs[s + 1] / mass
            val rest = slabs[s + 2 + flowAxis] - slope * slabs[s + 1]
            for (e in 0 until 6) {
                val other = otherThanFlow(e)
                if (other >= 0) moments[e] -= rest / mass * (if (other == flowAxis) rest else slabs[s + 2 + other])
            }
        }
        return 1.0 + filled - between / across
    }

    /**
     * The component that moment [e] has beside that of the flow, which is the flow's own in its square; −1 when the
     * flow's component is not in it.
     */
    private fun otherThanFlow(e: Int): Int = if (FIRST[e] == flowAxis) {
        SECOND[e]
    } else if (SECOND[e] == flowAxis) {
        FIRST[e]
    } else {
        -1
    }

    companion object {
        const val SPHERES_A_SLAB = 100
        const val MOST_SLABS = 20
        const val SLAB_WIDTH = 5

        /** Axes of xx, yy, zz, xy, xz, yz. */
        val FIRST = intArrayOf(0, 1, 2, 0, 0, 1)
        val SECOND = intArrayOf(0, 1, 2, 1, 2, 2)

        /** Degrees of freedom are whole numbers except for the part between slabs; less than this counts as none. */
        private const val LEAST_LEFT = 0.5
    }
}
