package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.roomAt
import daphnis.core.population.Population
import daphnis.core.search.NearPairs
import daphnis.core.search.Overlap
import kotlin.math.sqrt

/**
 * Takes overlaps away from a [population], with others and with walls, as single precision and soft contacts leave
 * them. The result depends on the state alone, not on threads or the machine. It changes the arrays of [population].
 */
internal class OverlapRepair(
    private val population: Population,
    private val boundary: BoundaryConditions,
    private val time: Double,
    private val threads: Int,
) {
    private val room = boundary.roomAt(time)

    /**
     * The deepest overlap.
     *
     * @property depth in parts of the sum of the radii, or of the radius at a wall
     * @property second id of the other sphere, −1 for a wall
     */
    class Deepest(val depth: Double, private val first: Int, private val second: Int) {
        fun words(): String = if (second < 0) "particle $first and a wall" else "particles $first and $second"
    }

    fun deepest(): Deepest {
        val pair = Overlap.deepest(population, boundary, time, threads)
        var deepest = Deepest(pair.depth, pair.first, pair.second)
        for (axis in 0..2) {
            if (boundary.contactFaces(axis) != ContactFaces.WALL) continue
            val p = population.position(axis)
            for (k in p.indices) {
                val r = population.radius[k]
                val free = minOf(p[k] - room.lower(axis), room.upper(axis) - p[k])
                if ((r - free) / r > deepest.depth) deepest = Deepest((r - free) / r, population.id[k], -1)
            }
        }
        val p = population
        for (surface in boundary.walls.surfaces) {
            for (k in 0 until p.size) {
                val r = p.radius[k]
                val depth = (r - surface.distance(p.x[k], p.y[k], p.z[k], time)) / r
                if (depth > deepest.depth) deepest = Deepest(depth, p.id[k], -1)
            }
        }
        return deepest
    }

    /** Multiplies all radii by one factor, so that none overlap. @return the factor */
    fun shrink(): Double {
        var factor = 1.0
        while (true) {
            val depth = deepest().depth
            if (depth <= 0) return factor
            val by = (1 - depth) * ALMOST
            factor *= by
            for (k in 0 until population.size) population.radius[k] *= by
        }
    }

    /**
     * What moving spheres took.
     *
     * @property count of spheres that were moved
     * @property farthest distance
     */
    class Moved(val count: Int, val farthest: Double)

    /**
     * Moves spheres that overlap apart along the line between them, the lighter one farther, so that the centre of mass
     * stays: pair after pair in the order of ids, again and again, until none overlap. Velocities stay; a sphere that
     * leaves through a sliding face gets that of its image.
     *
     * @return null when that takes more than [MOST_SWEEPS] sweeps over all near pairs
     */
    fun relax(): Moved? {
        val slack = deepest().depth * SLACK
        val way = Array(3) { DoubleArray(population.size) }
        repeat(MOST_SWEEPS / SWEEPS) {
            if (deepest().depth <= 0) return moved(way)
            val pairs = pairs(1 + NEAR)
            var sweeps = 0
            do sweeps++ while (sweep(pairs, slack, way) && sweeps < SWEEPS)
            boundary.putBack(population, time)
        }
        return if (deepest().depth <= 0) moved(way) else null
    }

    private fun moved(way: Array<DoubleArray>): Moved {
        val distance = DoubleArray(population.size) { k ->
            sqrt(way[0][k] * way[0][k] + way[1][k] * way[1][k] + way[2][k] * way[2][k])
        }
        return Moved(distance.count { it > 0 }, distance.max())
    }

    /** Two spheres that are near, the second where one of its images is: at its place and [shift]. */
    private class Pair(val first: Int, val second: Int, val shift: DoubleArray)

    /** Pairs that would touch if radii were larger by the [factor], in the order of ids. */
    private fun pairs(factor: Double): List<Pair> {
        val near = NearPairs(population, boundary, time)
        val runs = near.runs()
        val found = ArrayList<Pair>()
        val p = population
        for (slot in 0 until p.size) {
            near.forEach(runs, slot, p.radius[near.index(slot)] * factor + p.radius.max() * (factor - 1)) {
                    k,
                    j,
                    x,
                    y,
                    z,
                ->
                val s = (p.radius[k] + p.radius[j]) * factor
                if (x * x + y * y + z * z >= s * s) return@forEach
                val shift = doubleArrayOf(x - (p.x[j] - p.x[k]), y - (p.y[j] - p.y[k]), z - (p.z[j] - p.z[k]))
                if (p.id[k] > p.id[j]) for (axis in 0..2) shift[axis] = -shift[axis]
                found += if (p.id[k] < p.id[j]) Pair(k, j, shift) else Pair(j, k, shift)
            }
        }
        return found.sortedWith(compareBy({ p.id[it.first] }, { p.id[it.second] }, { it.shift[0] }, { it.shift[1] }))
    }

    /** @return whether a sphere was moved */
    private fun sweep(pairs: List<Pair>, slack: Double, way: Array<DoubleArray>): Boolean {
        val p = population
        var isMoved = false
        for (pair in pairs) {
            val k = pair.first
            val j = pair.second
            val dx = p.x[j] - p.x[k] + pair.shift[0]
            val dy = p.y[j] - p.y[k] + pair.shift[1]
            val dz = p.z[j] - p.z[k] + pair.shift[2]
            val s = p.radius[k] + p.radius[j]
            val distance = sqrt(dx * dx + dy * dy + dz * dz)
            if (distance >= s || distance == 0.0) continue
            isMoved = true
            val part = (s * (1 + slack) - distance) / distance / (p.mass[k] + p.mass[j])
            move(k, -part * p.mass[j], dx, dy, dz, way)
            move(j, part * p.mass[k], dx, dy, dz, way)
        }
        return offWalls(slack, way) || isMoved
    }

    private fun move(k: Int, by: Double, dx: Double, dy: Double, dz: Double, way: Array<DoubleArray>) {
        moveAlong(0, k, by * dx, way)
        moveAlong(1, k, by * dy, way)
        moveAlong(2, k, by * dz, way)
    }

    private fun moveAlong(axis: Int, k: Int, by: Double, way: Array<DoubleArray>) {
        population.position(axis)[k] += by
        way[axis][k] += by
    }

    private fun offWalls(slack: Double, way: Array<DoubleArray>): Boolean {
        var isMoved = false
        for (axis in 0..2) {
            if (boundary.contactFaces(axis) != ContactFaces.WALL) continue
            for (k in 0 until population.size) {
                val p = population.position(axis)[k]
                val r = population.radius[k]
                val below = room.lower(axis) + r - p
                val above = p - (room.upper(axis) - r)
                if (below <= 0 && above <= 0) continue
                isMoved = true
                moveAlong(axis, k, if (below > 0) below + slack * r else -above - slack * r, way)
            }
        }
        return offSurfaces(slack, way) || isMoved
    }

    private fun offSurfaces(slack: Double, way: Array<DoubleArray>): Boolean {
        var isMoved = false
        val normal = DoubleArray(3)
        val p = population
        for (surface in boundary.walls.surfaces) {
            for (k in 0 until p.size) {
                val r = p.radius[k]
                val out = r - surface.distance(p.x[k], p.y[k], p.z[k], time)
                if (out <= 0) continue
                isMoved = true
                surface.normal(p.x[k], p.y[k], p.z[k], time, normal)
                for (axis in 0..2) moveAlong(axis, k, (out + slack * r) * normal[axis], way)
            }
        }
        return isMoved
    }

    companion object {
        /** The deepest overlap that is taken away: more is no rounding and no soft contact. */
        const val DEEPEST = 0.1
        const val WAY_OUT = "placement.overlaps: \"shrink\", \"relax\" or \"grow\" takes such overlaps away"

        /** Sweeps until it is given up. */
        const val MOST_SWEEPS = 2000

        /** Sweeps after which near pairs are searched again. */
        private const val SWEEPS = 20

        /** How much farther than their radii reach, in parts of these, spheres count as near. */
        private const val NEAR = 0.1

        /** By how much more than needed spheres are moved, in parts of the deepest overlap, so that there is an end. */
        private const val SLACK = 0.1

        /** 1 less some roundings, so that a product is below. */
        private const val ALMOST = 1 - 4e-16
    }
}
