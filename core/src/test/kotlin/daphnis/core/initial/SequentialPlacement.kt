package daphnis.core.initial

import daphnis.core.boundary.Box
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Random sequential addition one sphere and one try after the other: what [RandomPlacement] must come to, bit for bit,
 * on any number of threads.
 */
internal class SequentialPlacement(
    private val mostTries: Int = 200_000,
    private val obstacles: List<Obstacle> = emptyList(),
) : Placement {
    override fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions {
        val positions = Positions(DoubleArray(radii.size), DoubleArray(radii.size), DoubleArray(radii.size))
        val bySize = radii.indices.sortedByDescending { radii[it] }.toIntArray()
        val space = SequentialSpace(radii, positions, box, walled, obstacles)
        for (sphere in bySize) placeOne(sphere, radii[sphere], box, walled, random, space, positions)
        return positions
    }

    private fun placeOne(
        sphere: Int,
        radius: Double,
        box: Box,
        walled: BooleanArray,
        random: SeededRandom,
        space: SequentialSpace,
        positions: Positions,
    ) {
        val margin = DoubleArray(3) { if (walled[it]) radius else 0.0 }
        for (axis in 0..2) {
            if (box.length(axis) <= 2 * margin[axis]) {
                throw PlacementException(
                    "a sphere of radius $radius does not fit between the walls along ${"xyz"[axis]}",
                )
            }
        }
        repeat(mostTries) {
            val x = random.nextDouble(box.lowerX + margin[0], box.upperX - margin[0])
            val y = random.nextDouble(box.lowerY + margin[1], box.upperY - margin[1])
            val z = random.nextDouble(box.lowerZ + margin[2], box.upperZ - margin[2])
            if (space.isFree(x, y, z, radius)) {
                positions.x[sphere] = x
                positions.y[sphere] = y
                positions.z[sphere] = z
                space.add(sphere)
                return
            }
        }
        throw PlacementException(
            "no free place found for a sphere of radius $radius in $mostTries tries; " +
                "random placement reaches a filling factor of about 0.35, use a lattice above that",
        )
    }
}

/**
 * The spheres placed so far, in one linked-cell grid for each octave of radius. Spheres come largest first, so all that
 * are there are at least as large as the one asked for, and neighbouring cells suffice in every octave.
 */
private class SequentialSpace(
    private val radii: DoubleArray,
    private val positions: Positions,
    private val box: Box,
    private val walled: BooleanArray,
    private val obstacles: List<Obstacle>,
) {
    private class Octave(val largest: Double, val cells: IntArray, val heads: IntArray)

    private val octaves = ArrayList<Octave>()
    private val next = IntArray(radii.size)

    fun isFree(x: Double, y: Double, z: Double, radius: Double): Boolean =
        obstacles.none { overlaps(it.x, it.y, it.z, it.radius, x, y, z, radius) } &&
            octaves.all { isFree(it, x, y, z, radius) }

    fun add(sphere: Int) {
        val r = radii[sphere]
        if (octaves.isEmpty() || octaves.last().largest > 2 * r) octaves += octave(r)
        val octave = octaves.last()
        val row = cell(octave, 2, positions.z[sphere]) * octave.cells[1] + cell(octave, 1, positions.y[sphere])
        val cell = row * octave.cells[0] + cell(octave, 0, positions.x[sphere])
        next[sphere] = octave.heads[cell]
        octave.heads[cell] = sphere
    }

    private fun octave(largest: Double): Octave {
        var width = 2 * largest
        // No more cells than a few a sphere, however empty the box.
        val most = maxOf(64.0, 4.0 * radii.size)
        width = maxOf(width, StrictMath.cbrt(box.volume / most))
        val cells = IntArray(3) { (box.length(it) / width).coerceIn(1.0, 1e6).toInt() }
        while (cells[0].toDouble() * cells[1] * cells[2] > 8 * most) {
            for (k in 0..2) cells[k] = ceil(cells[k] / 2.0).toInt()
        }
        return Octave(largest, cells, IntArray(cells[0] * cells[1] * cells[2]) { -1 })
    }

    private fun cell(octave: Octave, axis: Int, position: Double): Int =
        floor((position - box.lower(axis)) / box.length(axis) * octave.cells[axis]).toInt().coerceIn(
            0,
            octave.cells[axis] - 1,
        )

    private fun isFree(octave: Octave, x: Double, y: Double, z: Double, radius: Double): Boolean {
        val n = octave.cells
        val cx = cell(octave, 0, x)
        val cy = cell(octave, 1, y)
        val cz = cell(octave, 2, z)
        for (kz in first(n[2])..last(n[2])) {
            for (ky in first(n[1])..last(n[1])) {
                for (kx in first(n[0])..last(n[0])) {
                    val cell =
                        (Math.floorMod(cz + kz, n[2]) * n[1] + Math.floorMod(cy + ky, n[1])) * n[0] +
                            Math.floorMod(cx + kx, n[0])
                    var other = octave.heads[cell]
                    while (other >= 0) {
                        if (overlaps(
                                positions.x[other],
                                positions.y[other],
                                positions.z[other],
                                radii[other],
                                x,
                                y,
                                z,
                                radius,
                            )
                        ) {
                            return false
                        }
                        other = next[other]
                    }
                }
            }
        }
        return true
    }

    // With one or two cells along an axis the neighbours on both sides are the same cells: visit each once.
    private fun first(cells: Int): Int = if (cells >= 3) -1 else 0

    private fun last(cells: Int): Int = if (cells >= 2) 1 else 0

    private fun overlaps(
        ox: Double,
        oy: Double,
        oz: Double,
        or: Double,
        x: Double,
        y: Double,
        z: Double,
        radius: Double,
    ): Boolean {
        val dx = apart(ox - x, 0)
        val dy = apart(oy - y, 1)
        val dz = apart(oz - z, 2)
        val s = or + radius
        return dx * dx + dy * dy + dz * dz < s * s
    }

    private fun apart(d: Double, axis: Int): Double = if (walled[axis]) {
        d
    } else {
        d -
            box.length(axis) * Math.rint(d / box.length(axis))
    }
}
