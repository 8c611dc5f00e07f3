package daphnis.core.boundary

import daphnis.core.wall.PlaneWall
import daphnis.core.wall.WallMotion
import daphnis.core.wall.WallSet
import kotlin.math.abs
import kotlin.math.sqrt

/** The box whose faces are where the walls of this boundary are at [time]. */
internal fun BoundaryConditions.roomAt(time: Double): Box {
    if (walls.all { it.motion == null }) return box
    fun face(face: Int): Double {
        val at = if (face and 1 == 0) box.lower(face shr 1) else box.upper(face shr 1)
        return at + (walls[face]?.motion?.displacement(time) ?: 0.0)
    }
    return Box(face(0), face(2), face(4), face(1), face(3), face(5), space)
}

/** Two walls that face each other, by their numbers, and the least distance between them. */
internal class FacingWalls(val first: Int, val second: Int, val apart: Double) {
    /** Whether both are faces of the box. */
    val areFaces: Boolean get() = first < WallSet.FACES && second < WallSet.FACES
}

/**
 * Pairs of parallel planes among the walls of which one moves, with their least distance in the time [from] until [to],
 * or less. Where a piston will be is not known: then it is the distance at [from]. Planes that are not both faces and
 * move in different ways are left out.
 */
internal fun WallSet.facing(from: Double, to: Double): List<FacingWalls> {
    val planes = numbers.mapNotNull { n -> (get(n) as? PlaneWall)?.let { n to it } }
    val pairs = ArrayList<FacingWalls>()
    for ((k, first) in planes.withIndex()) {
        val (n, a) = first
        for ((m, b) in planes.drop(k + 1)) {
            if (a.motion == null && b.motion == null) continue
            if ((0 until 3).any { abs(a.direction[it] + b.direction[it]) > PARALLEL }) continue
            val rest = (0 until 3).sumOf { (b.origin[it] - a.origin[it]) * a.direction[it] }
            val less = if (a.motion?.isKnownAhead == false || b.motion?.isKnownAhead == false) {
                -(a.moved(from) + b.moved(from))
            } else if (a.motion == null || b.motion == null) {
                -(a.farthestIn(from, to) + b.farthestIn(from, to))
            } else {
                togetherAtLeast(a, b, from, to)
                    ?: if (m < WallSet.FACES) -(a.farthestIn(from, to) + b.farthestIn(from, to)) else continue
            }
            pairs += FacingWalls(n, m, rest + less)
        }
    }
    return pairs
}

/** How far into the room it has moved at [time]. */
private fun PlaneWall.moved(time: Double) = way * (motion?.displacement(time) ?: 0.0)

/** How far it comes into the room in the time [from] until [to]. */
private fun PlaneWall.farthestIn(from: Double, to: Double): Double {
    val motion = motion ?: return 0.0
    val phase = motion.phase(from)
    return if (way > 0) motion.highest(phase, to - from) else -motion.lowest(phase, to - from)
}

/**
 * How much farther apart two are at least than at rest, where they move alike, so that it is more than when each is
 * where it comes nearest: sines of one frequency, other motions which differ in their amplitudes alone, and steady
 * ones. Otherwise null.
 */
private fun togetherAtLeast(first: PlaneWall, second: PlaneWall, from: Double, to: Double): Double? {
    val lower = first.motion
    val upper = second.motion
    if (lower is WallMotion.Steady && upper is WallMotion.Steady) {
        val rate = -(first.way * lower.velocity + second.way * upper.velocity)
        return minOf(rate * from, rate * to)
    }
    if (lower !is WallMotion.Periodic ||
        upper !is WallMotion.Periodic ||
        lower.frequency != upper.frequency ||
        first.way == second.way
    ) {
        return null
    }
    val behind = upper.phase - lower.phase
    val more = lower.amplitude - upper.amplitude
    val areSines = lower is WallMotion.Sine && upper is WallMotion.Sine
    val areAlike = behind == Math.rint(behind) &&
        if (lower is WallMotion.Sawtooth) {
            upper is WallMotion.Sawtooth && lower.rise == upper.rise
        } else {
            areSines || lower is WallMotion.BiParabolic && upper is WallMotion.BiParabolic
        }
    if (areAlike) return -abs(more)
    if (!areSines) return null
    val half = StrictMath.sin(Math.PI * behind)
    return -sqrt(more * more + 4 * lower.amplitude * upper.amplitude * half * half)
}

private const val PARALLEL = 1e-12
