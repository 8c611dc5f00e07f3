package daphnis.core.search

import daphnis.core.population.SphereColumns

/**
 * Divides the spheres of a population into classes of size, so that a search among small spheres need not reach as far
 * as the largest one requires. The paper proposes a tree that knows the largest radius below each node. This is that
 * tree flattened: one level per class, each with its own regular grid.
 *
 * Classes are made of octaves of radius. Adjacent ones are merged as long as that leaves fewer pairs to check: a sphere
 * searches its own class and those of larger spheres, and searching a class costs something even where it is empty.
 */
internal class SizeClasses {
    /** Number of classes. */
    var count = 1
        private set

    /** Largest radius by class, ascending. */
    val largest = DoubleArray(MOST)

    /** Spheres by class. */
    val spheres = IntArray(MOST)

    private val octaveSpheres = IntArray(OCTAVES)
    private val octaveLargest = DoubleArray(OCTAVES)

    /**
     * @param reach how far spheres may go along x, y, z
     * @param size extent of all spheres along x, y, z
     */
    fun divide(
        population: SphereColumns,
        smallestRadius: Double,
        largestRadius: Double,
        structure: SearchStructure,
        reach: DoubleArray,
        size: DoubleArray,
    ) {
        count = 1
        largest[0] = largestRadius
        spheres[0] = population.size
        if (structure == SearchStructure.GRID ||
            population.size == 0 ||
            Math.getExponent(largestRadius) == Math.getExponent(smallestRadius)
        ) {
            return
        }
        countOctaves(population, Math.getExponent(largestRadius))
        putTogether(if (structure == SearchStructure.LEVELS) 2 else 1, reach, size)
    }

    /** The class of a sphere of [radius]. */
    fun of(radius: Double): Int {
        var c = 0
        while (c < count - 1 && radius > largest[c]) c++
        return c
    }

    private fun countOctaves(population: SphereColumns, top: Int) {
        octaveSpheres.fill(0)
        octaveLargest.fill(0.0)
        val radius = population.radius
        for (k in 0 until population.size) {
            // The lowest octave also takes all smaller spheres.
            val octave = maxOf(0, Math.getExponent(radius[k]) - top + OCTAVES - 1)
            octaveSpheres[octave]++
            if (radius[k] > octaveLargest[octave]) octaveLargest[octave] = radius[k]
        }
        count = 0
        for (octave in 0 until OCTAVES) {
            if (octaveSpheres[octave] == 0) continue
            largest[count] = octaveLargest[octave]
            spheres[count++] = octaveSpheres[octave]
        }
    }

    private fun putTogether(least: Int, reach: DoubleArray, size: DoubleArray) {
        var cost = cost(-1, reach, size)
        while (count > least) {
            var best = -1
            var bestCost = Double.POSITIVE_INFINITY
            for (c in 0 until count - 1) {
                val merged = cost(c, reach, size)
                if (merged < bestCost) {
                    bestCost = merged
                    best = c
                }
            }
            if (bestCost > cost) return
            spheres[best + 1] += spheres[best]
            for (c in best until count - 1) {
                spheres[c] = spheres[c + 1]
                largest[c] = largest[c + 1]
            }
            count--
            cost = bestCost
        }
    }

    /** Number of spheres that all searches together check, if [merged] and the class above it were one. */
    private fun cost(merged: Int, reach: DoubleArray, size: DoubleArray): Double {
        var sum = 0.0
        for (a in 0 until count) {
            if (a == merged) continue
            val lookers = spheres[a] + if (a == merged + 1 && merged >= 0) spheres[merged] else 0
            for (b in a until count) {
                if (b == merged) continue
                val others = spheres[b] + if (b == merged + 1 && merged >= 0) spheres[merged] else 0
                var share = 1.0
                for (axis in 0..2) {
                    // Both radii, both paths, and about a cell.
                    val range = 2 * (largest[a] + largest[b] + 2 * reach[axis])
                    if (size[axis] > 0) share *= minOf(1.0, range / size[axis])
                }
                sum += lookers * (LOOKING + others * share * if (a == b) 0.5 else 1.0)
            }
        }
        return sum
    }

    private companion object {
        const val MOST = 24
        const val OCTAVES = MOST

        /** Cost of searching the cells of a class, in spheres checked. */
        const val LOOKING = 12.0
    }
}
