package daphnis.app.live

import daphnis.core.scenario.WallSurfaceSpec
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * What is drawn of [walls]: the edges of the box, rings and lines of cylinders, great circles of spheres, a lattice on
 * planes. Each piece of a surface that is in the room, between [low] and [high] and on the right side of all other
 * surfaces.
 */
internal class WallLines(private val walls: SeenWalls, private val low: DoubleArray, private val high: DoubleArray) {
    private val ends = ArrayList<DoubleArray>()
    private val tolerance = TOLERANCE * norm(DoubleArray(AXES) { high[it] - low[it] })
    private val corners = List(8) { n -> DoubleArray(AXES) { if (n shr it and 1 == 0) low[it] else high[it] } }

    /** Pieces of straight lines, two points each. */
    fun pieces(): List<DoubleArray> {
        edges()
        walls.surfaces.forEachIndexed { k, it ->
            when (it) {
                is WallSurfaceSpec.Plane -> plane(k, it)
                is WallSurfaceSpec.Cylinder -> cylinder(k, it)
                is WallSurfaceSpec.Sphere -> sphere(k, it)
            }
        }
        return ends
    }

    /** Along each axis with faces, at the faces of the others, or in the middle of those that are open. */
    private fun edges() {
        for (axis in 0 until AXES) {
            if (!walls.isFace(axis)) continue
            val (one, other) = (0 until AXES).filter { it != axis }
            for (a in sides(one)) {
                for (b in sides(other)) {
                    val from = DoubleArray(AXES)
                    from[axis] = low[axis]
                    from[one] = a
                    from[other] = b
                    ends += from
                    ends += from.copyOf().also { it[axis] = high[axis] }
                }
            }
        }
    }

    private fun sides(axis: Int): List<Double> = when {
        walls.isFace(axis) -> listOf(low[axis], high[axis])
        walls.extent(axis) != null -> emptyList()
        else -> listOf((low[axis] + high[axis]) / 2)
    }

    private fun cylinder(k: Int, it: WallSurfaceSpec.Cylinder) {
        val axis = unit(it.axis)
        val (u, v) = across(axis)
        val middle = it.point.toDoubleArray()
        val along = corners.map { dot(it, axis) - dot(middle, axis) }
        val (from, to) = along.min() to along.max()
        val rings = if (axis.any { abs(it) == 1.0 }) 1 else RINGS
        for (n in 0..if (to - from > tolerance) rings else 0) {
            val s = from + (to - from) * n / rings
            val centre = DoubleArray(AXES) { middle[it] + s * axis[it] }
            curve(k) { t -> onCircle(centre, u, v, it.radius, 2 * PI * t) }
        }
        if (to - from <= tolerance) return
        for (n in 0 until LINES) {
            val foot = onCircle(middle, u, v, it.radius, 2 * PI * n / LINES)
            curve(k) { t -> DoubleArray(AXES) { foot[it] + (from + (to - from) * t) * axis[it] } }
        }
    }

    private fun sphere(k: Int, it: WallSurfaceSpec.Sphere) {
        val way = unit(it.along)
        val centre = DoubleArray(AXES) { axis -> it.centre[axis] + walls.displacement(k) * way[axis] }
        for (axis in 0 until AXES) {
            val (u, v) = across(DoubleArray(AXES) { if (it == axis) 1.0 else 0.0 })
            curve(k) { t -> onCircle(centre, u, v, it.radius, 2 * PI * t) }
        }
    }

    private fun plane(k: Int, it: WallSurfaceSpec.Plane) {
        val normal = unit(it.normal)
        val (u, v) = across(normal)
        val point = DoubleArray(AXES) { axis -> it.point[axis] + walls.displacement(k) * normal[axis] }
        val outline = crossings(point, normal)
        if (outline.isEmpty()) return
        val middle = DoubleArray(AXES) { axis -> outline.sumOf { it[axis] } / outline.size }
        fun along(at: DoubleArray, d: DoubleArray) = (0 until AXES).sumOf { (at[it] - middle[it]) * d[it] }
        val round = outline.sortedBy { atan2(along(it, v), along(it, u)) }
        for (n in round.indices) line(k, round[n], round[(n + 1) % round.size])
        for ((d, other) in listOf(u to v, v to u)) {
            val least = outline.minOf { along(it, d) }
            val most = outline.maxOf { along(it, d) }
            val reach = outline.maxOf { abs(along(it, other)) }
            for (n in 1 until LATTICE) {
                val s = least + (most - least) * n / LATTICE
                fun at(t: Double) = DoubleArray(AXES) { middle[it] + s * d[it] + t * other[it] }
                if (reach > tolerance && most - least > tolerance) line(k, at(-reach), at(reach))
            }
        }
    }

    /** Where a plane meets the twelve edges of what is seen. */
    private fun crossings(point: DoubleArray, normal: DoubleArray): List<DoubleArray> {
        val found = ArrayList<DoubleArray>()
        for (n in corners.indices) {
            for (axis in 0 until AXES) {
                val m = n or (1 shl axis)
                if (m == n) continue
                val (a, b) = corners[n] to corners[m]
                val (da, db) = dot(a, normal) - dot(point, normal) to dot(b, normal) - dot(point, normal)
                if (da * db > 0 || da == db) continue
                val at = DoubleArray(AXES) { a[it] + (b[it] - a[it]) * (da / (da - db)) }
                if (found.none { other -> (0 until AXES).all { abs(other[it] - at[it]) <= tolerance } }) found += at
            }
        }
        return found
    }

    private fun line(k: Int, a: DoubleArray, b: DoubleArray) =
        curve(k, isStraight = true) { t -> DoubleArray(AXES) { a[it] + (b[it] - a[it]) * t } }

    /** What of the curve [at], on the surface [k], is in the room; parameters are from 0 to 1. */
    private fun curve(k: Int, isStraight: Boolean = false, at: (Double) -> DoubleArray) {
        var begin = -1
        for (n in 0..PIECES) {
            val isSeen = n < PIECES && isInRoom(k, at((n + 0.5) / PIECES))
            if (isSeen && begin < 0) begin = n
            if (begin >= 0 && (!isSeen || !isStraight)) {
                ends += at(begin.toDouble() / PIECES)
                ends += at((if (isSeen) n + 1.0 else n.toDouble()) / PIECES)
                begin = -1
            }
        }
    }

    private fun isInRoom(k: Int, at: DoubleArray): Boolean =
        (0 until AXES).all { at[it] >= low[it] - tolerance && at[it] <= high[it] + tolerance } &&
            walls.surfaces.indices.all { it == k || walls.distance(it, at) >= -tolerance }

    private fun onCircle(centre: DoubleArray, u: DoubleArray, v: DoubleArray, radius: Double, angle: Double) =
        DoubleArray(AXES) { centre[it] + radius * (cos(angle) * u[it] + sin(angle) * v[it]) }

    private companion object {
        const val AXES = 3
        const val PIECES = 64
        const val LINES = 8
        const val RINGS = 8
        const val LATTICE = 6

        /** Of the diagonal of what is seen. */
        const val TOLERANCE = 1e-9

        fun dot(a: DoubleArray, b: DoubleArray) = (0 until AXES).sumOf { a[it] * b[it] }

        fun norm(a: DoubleArray) = sqrt(dot(a, a))

        /** Exact along an axis. */
        fun unit(v: List<Double>): DoubleArray {
            val scale = v.maxOf { abs(it) }
            val scaled = DoubleArray(AXES) { v[it] / scale }
            return norm(scaled).let { length -> DoubleArray(AXES) { scaled[it] / length } }
        }

        /** Two directions across [d] and each other. */
        fun across(d: DoubleArray): Pair<DoubleArray, DoubleArray> {
            val least = (0 until AXES).minBy { abs(d[it]) }
            val other = (least + 1) % AXES
            val third = (least + 2) % AXES
            val u = DoubleArray(AXES)
            u[other] = -d[third]
            u[third] = d[other]
            val length = norm(u)
            for (k in u.indices) u[k] /= length
            val v = DoubleArray(AXES) {
                val (a, b) = (it + 1) % AXES to (it + 2) % AXES
                d[a] * u[b] - d[b] * u[a]
            }
            return u to v
        }
    }
}
