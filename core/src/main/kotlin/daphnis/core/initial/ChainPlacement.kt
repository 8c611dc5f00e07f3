package daphnis.core.initial

import daphnis.core.boundary.Box
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * Random places for chains of equal spheres: the first sphere of a chain goes to a uniform random place, and each further
 * one to a random direction from the one before. A chain that has no room is begun again elsewhere.
 *
 * @param length number of spheres in a chain
 * @param ratio distance of neighbours over the sum of their radii
 * @param mostTries tries for one chain before giving up
 */
internal class ChainPlacement(
    private val length: Int,
    private val ratio: Double,
    private val mostTries: Int = MOST_TRIES,
) : Placement {
    /** @throws PlacementException also when radii differ, or spheres are no multiple of [length] */
    override fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions {
        if (radii.any { it != radii[0] }) throw PlacementException("spheres of chains must have one radius")
        if (radii.size % length != 0) {
            throw PlacementException("${radii.size} spheres make no whole number of chains of $length")
        }
        Crowding.check(radii, box, walled)
        val space = OccupiedSpace(radii, IntArray(radii.size) { it }, box, walled, emptyList())
        val chain = Array(length) { DoubleArray(AXES) }
        for (first in radii.indices step length) {
            var tries = 0
            while (!lay(chain, radii[0], box, walled, space, random)) {
                if (++tries == mostTries) {
                    throw PlacementException("no room found for a chain of $length in $mostTries tries; take fewer")
                }
            }
            for (k in chain.indices) space.add(first + k, chain[k][0], chain[k][1], chain[k][2])
        }
        fun along(axis: Int) = DoubleArray(radii.size) { space.coordinate(it, axis) }
        return Positions(along(0), along(1), along(2))
    }

    /** Lays a [chain] out at random. @return whether there is room for it */
    private fun lay(
        chain: Array<DoubleArray>,
        radius: Double,
        box: Box,
        walled: BooleanArray,
        space: OccupiedSpace,
        random: SeededRandom,
    ): Boolean {
        for (k in chain.indices) {
            if (k == 0) {
                for (axis in 0 until box.space.dimensions) {
                    chain[0][axis] = random.nextDouble(box.lower(axis), box.upper(axis))
                }
            } else {
                step(chain[k - 1], chain[k], 2 * radius * ratio, box, random)
            }
            val place = chain[k]
            for (axis in 0 until box.space.dimensions) {
                val low = box.lower(axis)
                val length = box.length(axis)
                if (walled[axis]) {
                    if (place[axis] < low + radius || place[axis] > low + length - radius) return false
                } else {
                    place[axis] -= length * floor((place[axis] - low) / length)
                    if (place[axis] >= low + length) place[axis] = low
                }
            }
            if (!space.isFree(place[0], place[1], place[2], radius)) return false
            for (j in 0 until k) if (overlap(chain[j], place, 2 * radius, box, walled)) return false
        }
        return true
    }

    private fun step(from: DoubleArray, to: DoubleArray, by: Double, box: Box, random: SeededRandom) {
        val isPlane = box.space.isPlane
        var square: Double
        do {
            for (axis in 0 until AXES) to[axis] = if (isPlane && axis == 2) 0.0 else random.nextDouble(-1.0, 1.0)
            square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2]
        } while (square > 1 || square < TOO_SHORT)
        val scale = by / sqrt(square)
        for (axis in 0 until AXES) to[axis] = from[axis] + scale * to[axis]
    }

    private fun overlap(a: DoubleArray, b: DoubleArray, reach: Double, box: Box, walled: BooleanArray): Boolean {
        var square = 0.0
        for (axis in 0 until box.space.dimensions) {
            val d = b[axis] - a[axis]
            val near = if (walled[axis]) d else d - box.length(axis) * Math.rint(d / box.length(axis))
            square += near * near
        }
        return square < reach * reach
    }

    private companion object {
        const val AXES = 3
        const val MOST_TRIES = 100_000

        /** Of a vector whose direction rounding would tell. */
        const val TOO_SHORT = 1e-4
    }
}
