package daphnis.core.collision

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.RoomSide
import daphnis.core.boundary.WallMotion
import daphnis.core.boundary.WallSurface
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A [WallSurface] within a step. A plane is a [MovingFace] across its normal. For the others the gap is ±(ρ² − q²),
 * where **q** is the sphere's centre from the axis or the centre of the surface, and ρ is the distance at contact: the
 * difference of the radii, or their sum where the room is outside. On a straight path this is a quadratic in time.
 *
 * **Gravity.** The surface stands where it is, and **q** is that of the true path, a parabola (see [MovingFace]): the
 * gap is a quartic. Its second derivative is a quadratic, whose least value over the rest of the step bounds the gap
 * from below. The search comes nearer from one side, as for walls that move, and passes over nothing.
 *
 * **Bounces without end.** A sphere that slides along the inside of a surface touches it in ever shorter chords: what
 * presses it there is its own path. It leaves with a least speed as at walls under gravity, see [MovingFace.rebound].
 *
 * Threads share one object; everything is a pure function of the sphere's row and the step.
 *
 * @param place number of the partner as a face, see [WallContact]
 */
internal class SurfaceWall(
    private val surface: WallSurface,
    place: Int,
    boundary: BoundaryConditions,
    law: CollisionLaw,
) {
    private val impact = SurfaceImpact(surface, place, boundary, law)
    private val motion = surface.face.motion
    private val isInside = surface.side == RoomSide.INSIDE

    /** 1 where the gap is ρ² − q², else −1. */
    private val sign = if (isInside) 1.0 else -1.0
    private val ox = surface.origin[0]
    private val oy = surface.origin[1]
    private val oz = surface.origin[2]
    private val ax = surface.direction[0]
    private val ay = surface.direction[1]
    private val az = surface.direction[2]
    private val gx = law.acceleration(0)
    private val gy = law.acceleration(1)
    private val gz = law.acceleration(2)
    private val plane = if (surface.isPlane) MovingFace(true, motion, gx * ax + gy * ay + gz * az) else null

    /** Gravity across the axis. */
    private val fallX = gx - (gx * ax + gy * ay + gz * az) * ax
    private val fallY = gy - (gx * ax + gy * ay + gz * az) * ay
    private val fallZ = gz - (gx * ax + gy * ay + gz * az) * az
    private val fall2 = fallX * fallX + fallY * fallY + fallZ * fallZ

    /** The strongest acceleration of the surface. */
    private val shaking = motion?.strongest ?: 0.0
    private val isExact = fall2 == 0.0 && shaking == 0.0
    private var duration = 0.0
    private var phase = 0.0
    private var grain = 0.0

    /** A time that is short for the step and for the motion, see [MovingFace.rebound]. */
    private var moment = 0.0

    /** What [soonest] adds to where the surface is, and to the radii. */
    private var middle = 0.0
    private var play = 0.0

    /** A step of [duration] begins at [start]. */
    fun begin(start: Double, duration: Double) {
        this.duration = duration
        phase = motion?.phase(start) ?: 0.0
        grain = duration * GRAIN
        plane?.begin(0.0, start, duration)
        impact.begin(start)
        val frequency = (motion as? WallMotion.Periodic)?.frequency ?: 0.0
        moment = if (frequency == 0.0) duration else minOf(duration, MovingFace.PART_OF_CYCLE / frequency)
    }

    /** See [WallContact.time]. */
    fun time(rows: StepRows, slot: Int): Double {
        val state = rows.state
        val p = slot * STRIDE
        val from = state[p + TIME]
        val r = state[p + RADIUS]
        if (plane != null) {
            val x = (state[p] - ox) * ax + (state[p + 1] - oy) * ay + (state[p + 2] - oz) * az
            val v = state[p + VX] * ax + state[p + VX + 1] * ay + state[p + VX + 2] * az
            return plane.contact(x, v, r, from)
        }
        val reach = if (isInside) surface.radius - r else surface.radius + r
        var t = from
        while (true) {
            relative(rows, slot, t) { qx, qy, qz, wx, wy, wz ->
                val gap = sign * (reach * abs(reach) - (qx * qx + qy * qy + qz * qz))
                val rate = -2 * sign * (qx * wx + qy * wy + qz * wz)
                val wait = waitForGap(gap, rate, bending(qx, qy, qz, wx, wy, wz, duration - t), isExact)
                if (wait == 0.0 || rate < 0.0 && wait <= grain) return t
                val next = t + wait
                if (isExact || next > duration) return next
                t = maxOf(next, t + grain)
            }
        }
    }

    /**
     * Calls [use] with place and velocity of the sphere in [slot], if nothing happens to it until [t], relative to the
     * surface and across its axis.
     */
    private inline fun relative(
        rows: StepRows,
        slot: Int,
        t: Double,
        use: (qx: Double, qy: Double, qz: Double, wx: Double, wy: Double, wz: Double) -> Unit,
    ) {
        val state = rows.state
        val p = slot * STRIDE
        val elapsed = t - state[p + TIME]
        val bow = 0.5 * t * (duration - t)
        val slope = 0.5 * (duration - 2 * t)
        var qx = state[p] + state[p + VX] * elapsed - ox - bow * gx
        var qy = state[p + 1] + state[p + VX + 1] * elapsed - oy - bow * gy
        var qz = state[p + 2] + state[p + VX + 2] * elapsed - oz - bow * gz
        var wx = state[p + VX] - slope * gx
        var wy = state[p + VX + 1] - slope * gy
        var wz = state[p + VX + 2] - slope * gz
        if (motion != null) {
            val moved = motion.displacement(phase, t)
            val speed = motion.velocity(phase, t)
            qx -= moved * surface.way[0]
            qy -= moved * surface.way[1]
            qz -= moved * surface.way[2]
            wx -= speed * surface.way[0]
            wy -= speed * surface.way[1]
            wz -= speed * surface.way[2]
        }
        val along = qx * ax + qy * ay + qz * az
        val gliding = wx * ax + wy * ay + wz * az
        use(
            qx - along * ax,
            qy - along * ay,
            qz - along * az,
            wx - gliding * ax,
            wy - gliding * ay,
            wz - gliding * az,
        )
    }

    /** The least second derivative of the gap in the time [rest] from now on, where **q** and its rate are given. */
    private fun bending(qx: Double, qy: Double, qz: Double, wx: Double, wy: Double, wz: Double, rest: Double): Double {
        val w2 = wx * wx + wy * wy + wz * wz
        if (isExact) return -2 * sign * w2
        if (shaking > 0.0) {
            // Only outside: there the velocity alone opens the gap.
            val most = sqrt(fall2) + shaking
            val far = sqrt(qx * qx + qy * qy + qz * qz) + (sqrt(w2) + most * rest) * rest
            return -2 * far * most
        }
        val qg = qx * fallX + qy * fallY + qz * fallZ
        val wg = wx * fallX + wy * fallY + wz * fallZ
        val now = 2 * (w2 + qg)
        val then = now + (6 * wg + 3 * fall2 * rest) * rest
        if (isInside) return -maxOf(now, then)
        val lowest = (-wg / fall2).coerceIn(0.0, rest)
        return now + (6 * wg + 3 * fall2 * lowest) * lowest
    }

    /** From now on [soonest] is asked about the time [span] from the start of this step. */
    fun spread(span: Double) {
        val g = sqrt(gx * gx + gy * gy + gz * gz)
        val bow = if (plane == null) 0.125 * g * duration * duration else 0.0
        val low = motion?.lowest(phase, span) ?: 0.0
        val high = motion?.highest(phase, span) ?: 0.0
        middle = if (plane == null) (low + high) / 2 else plane.innermost(span)
        play = bow + if (plane == null) (high - low) / 2 else 0.0
    }

    /**
     * How long a sphere of radius [r] which keeps to a line, now at ([x], [y], [z]), surely does not touch; [NEVER]
     * when it cannot at all. See [spread].
     */
    fun soonest(x: Double, y: Double, z: Double, vx: Double, vy: Double, vz: Double, r: Double): Double {
        val dx = x - ox - middle * surface.way[0]
        val dy = y - oy - middle * surface.way[1]
        val dz = z - oz - middle * surface.way[2]
        val along = dx * ax + dy * ay + dz * az
        val gliding = vx * ax + vy * ay + vz * az
        if (plane != null) {
            val gap = along - r
            return if (gap <= 0.0) {
                0.0
            } else if (gliding < 0.0) {
                -gap / gliding
            } else {
                NEVER
            }
        }
        val reach = if (isInside) surface.radius - r - play else surface.radius + r + play
        val qx = dx - along * ax
        val qy = dy - along * ay
        val qz = dz - along * az
        val ux = vx - gliding * ax
        val uy = vy - gliding * ay
        val uz = vz - gliding * az
        val gap = sign * (reach * abs(reach) - (qx * qx + qy * qy + qz * qz))
        if (gap <= 0.0) return 0.0
        val rate = -2 * sign * (qx * ux + qy * uy + qz * uz)
        return waitForGap(gap, rate, -2 * sign * (ux * ux + uy * uy + uz * uz), isExact = true)
    }

    /** Reflects sphere [slot], which has been advanced to [time]; what happened is described in [outcome]. */
    fun reflect(rows: StepRows, slot: Int, time: Double, outcome: CollisionOutcome) {
        val slope = 0.5 * (duration - 2 * time)
        val speed = motion?.velocity(phase, time) ?: 0.0
        impact.begin(rows, slot, outcome)
        if (plane != null) {
            val v = slot * STRIDE + VX
            val across = rows.state[v] * ax + rows.state[v + 1] * ay + rows.state[v + 2] * az
            val rate = -plane.approach(across, time)
            impact.meet(rows, slot, time, slope, speed, ax, ay, az, 1.0, rate, outcome) {
                plane.rebound(0.0, it, rows.state[slot * STRIDE + RADIUS], time)
            }
            return
        }
        relative(rows, slot, time) { qx, qy, qz, wx, wy, wz ->
            val q = sqrt(qx * qx + qy * qy + qz * qz)
            // In the middle of a surface that has no room for the sphere.
            if (q == 0.0) return
            val qw = qx * wx + qy * wy + qz * wz
            val along = qw / q
            val turning = (wx * wx + wy * wy + wz * wz - along * along) / q
            val falling = (qx * fallX + qy * fallY + qz * fallZ) / q
            val press = maxOf(0.0, sign * (turning + falling) + shaking)
            impact.meet(rows, slot, time, slope, speed, -sign * qx, -sign * qy, -sign * qz, q, -sign * qw, outcome) {
                val gain = minOf(press * moment, sqrt(press * rows.state[slot * STRIDE + RADIUS]))
                gain * if (it == 1.0) LEAST_ELASTIC else MovingFace.LEAST_INELASTIC
            }
        }
    }

    private companion object {
        const val GRAIN = 1e-15

        /** As for faces, but less, as what presses may be the path itself; see [MovingFace.rebound]. */
        const val LEAST_ELASTIC = 1e-5
    }
}
