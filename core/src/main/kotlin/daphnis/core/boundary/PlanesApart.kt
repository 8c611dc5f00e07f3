package daphnis.core.boundary

import kotlin.math.abs

/** Two walls that face each other, by their names in a scenario, and the least distance between them. */
internal class FacingWalls(val first: String, val second: String, val apart: Double)

private class FacingWall(val name: String, val point: DoubleArray, val into: DoubleArray, val motion: WallMotion?) {
    /** How far into the room the wall goes at most; of a piston, at [from]. A motion of a face is along its axis. */
    fun highest(from: Double, to: Double, along: Double): Double = when {
        motion == null -> 0.0
        // As of faces, where it will be is not known.
        motion is Piston -> along * motion.displacement(from)
        along > 0 -> motion.highest(motion.phase(from), to - from)
        else -> -motion.lowest(motion.phase(from), to - from)
    }
}

/**
 * Pairs of a plane among the surfaces and a wall parallel to it, with the least distance of the two in the time [from]
 * until [to], where one of them moves, or both do steadily. Of others it is not known.
 */
internal fun BoundaryConditions.planesApart(from: Double, to: Double): List<FacingWalls> {
    val planes = surfaces.withIndex().filter { it.value.isPlane }.map { (n, it) ->
        FacingWall("boundary.surfaces[$n]", it.origin, it.direction, it.face.motion)
    }
    if (planes.isEmpty()) return emptyList()
    val pairs = ArrayList<FacingWalls>()
    for ((n, plane) in planes.withIndex()) {
        for (other in planes.drop(n + 1)) pair(plane, other, 1.0, from, to)?.let { pairs += it }
        for (face in 0 until 2 * space.dimensions) {
            if (contactFaces(face shr 1) != ContactFaces.WALL) continue
            val inward = if (face and 1 == 0) 1.0 else -1.0
            val at = DoubleArray(AXES).also {
                it[face shr 1] = if (inward > 0) box.lower(face shr 1) else box.upper(face shr 1)
            }
            val into = DoubleArray(AXES).also { it[face shr 1] = inward }
            val name = "the wall ${if (inward > 0) "lower" else "upper"}${"XYZ"[face shr 1]}"
            pair(plane, FacingWall(name, at, into, wallMotion(face)), inward, from, to)?.let { pairs += it }
        }
    }
    return pairs
}

/** @param along 1 where the motion of [b] is along its normal into the room, and -1 where it is against that */
private fun pair(a: FacingWall, b: FacingWall, along: Double, from: Double, to: Double): FacingWalls? {
    if (a.motion == null && b.motion == null) return null
    if ((0 until AXES).any { abs(a.into[it] + b.into[it]) > PARALLEL }) return null
    val rest = (0 until AXES).sumOf { (b.point[it] - a.point[it]) * a.into[it] }
    val least = if (a.motion == null || b.motion == null) {
        rest - a.highest(from, to, 1.0) - b.highest(from, to, along)
    } else if (a.motion is WallMotion.Steady && b.motion is WallMotion.Steady) {
        val rate = a.motion.velocity + along * b.motion.velocity
        rest - maxOf(rate * from, rate * to)
    } else {
        return null
    }
    return FacingWalls(a.name, b.name, least)
}

private const val PARALLEL = 1e-12
