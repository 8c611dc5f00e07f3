package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallImpact
import kotlin.math.sqrt

/**
 * A [CurvedWall] within a step.
 *
 * **Gravity.** The surface stands where it is, and **q** is that of the true path, a parabola (see [MovingFace]): the
 * second derivative of its square is a quadratic in time, of which the least and the greatest value over the rest of
 * the step bound the gap from below. The search comes nearer from one side, as for walls that move, and passes over
 * nothing.
 *
 * **Bounces without end.** A sphere that slides along the inside of a surface touches it in ever shorter chords: what
 * presses it there is its own path. It leaves with a least speed as at walls under gravity, see [MovingFace.rebound].
 */
internal class CurvedContact(private val wall: CurvedWall, number: Int, walls: WallSet, law: CollisionLaw) :
    SurfaceContact(wall, number, walls, law) {
    private val ox = wall.origin[0]
    private val oy = wall.origin[1]
    private val oz = wall.origin[2]
    private val ax = wall.direction[0]
    private val ay = wall.direction[1]
    private val az = wall.direction[2]

    /** Gravity along the axis and across it. */
    private val fall = gx * ax + gy * ay + gz * az
    private val fallX = gx - fall * ax
    private val fallY = gy - fall * ay
    private val fallZ = gz - fall * az
    private val fall2 = fallX * fallX + fallY * fallY + fallZ * fallZ

    /** The strongest acceleration of the surface. */
    private val shaking = motion?.strongest ?: 0.0
    private val isExact = fall2 == 0.0 && (fall == 0.0 || !wall.leans) && shaking == 0.0
    private var grain = 0.0

    /** A time that is short for the step and for the motion, see [MovingFace.rebound]. */
    private var moment = 0.0

    /** What [soonest] adds to where the surface is, and to the radius of the sphere. */
    private var middle = 0.0
    private var play = 0.0

    override fun begin(start: Double, duration: Double) {
        super.begin(start, duration)
        grain = duration * GRAIN
        moment = MovingFace.momentOf(motion, duration)
    }

    override fun time(rows: StepRows, slot: Int): Double {
        val r = rows.state[slot * STRIDE + RADIUS]
        var t = rows.state[slot * STRIDE + TIME]
        while (true) {
            relative(rows, slot, t) { qx, qy, qz, h, wx, wy, wz, u ->
                val q2 = qx * qx + qy * qy + qz * qz
                val gap = wall.gap(q2, h, r)
                val rate = wall.rate(qx * wx + qy * wy + qz * wz, h, u, r)
                val bending = bending(q2, qx, qy, qz, wx, wy, wz, duration - t) { least, most ->
                    wall.bending(least, most, h, u, fall, duration - t, r)
                }
                val wait = waitForGap(gap, rate, bending, isExact)
                if (wait == 0.0 || rate < 0.0 && wait <= grain) return t
                val next = t + wait
                if (isExact || next > duration) return next
                t = maxOf(next, t + grain)
            }
        }
    }

    /**
     * Calls [use] with place and velocity of the sphere in [slot], if nothing happens to it until [t], relative to the
     * surface: across its axis, and along it.
     */
    private inline fun relative(
        rows: StepRows,
        slot: Int,
        t: Double,
        use: (Double, Double, Double, h: Double, Double, Double, Double, u: Double) -> Unit,
    ) {
        val state = rows.state
        val p = slot * STRIDE
        val elapsed = t - state[p + TIME]
        val bow = 0.5 * t * (duration - t)
        val slope = slope(t)
        var qx = state[p] + state[p + VX] * elapsed - ox - bow * gx
        var qy = state[p + 1] + state[p + VX + 1] * elapsed - oy - bow * gy
        var qz = state[p + 2] + state[p + VX + 2] * elapsed - oz - bow * gz
        var wx = state[p + VX] - slope * gx
        var wy = state[p + VX + 1] - slope * gy
        var wz = state[p + VX + 2] - slope * gz
        if (motion != null) {
            val moved = motion.displacement(phase, t)
            val speed = motion.velocity(phase, t)
            qx -= moved * wall.way[0]
            qy -= moved * wall.way[1]
            qz -= moved * wall.way[2]
            wx -= speed * wall.way[0]
            wy -= speed * wall.way[1]
            wz -= speed * wall.way[2]
        }
        val h = qx * ax + qy * ay + qz * az
        val u = wx * ax + wy * ay + wz * az
        use(qx - h * ax, qy - h * ay, qz - h * az, h, wx - u * ax, wy - u * ay, wz - u * az, u)
    }

    /** Calls [use] with bounds on the second derivative of q² in the time [rest] from now on. */
    private inline fun bending(
        q2: Double,
        qx: Double,
        qy: Double,
        qz: Double,
        wx: Double,
        wy: Double,
        wz: Double,
        rest: Double,
        use: (least: Double, most: Double) -> Double,
    ): Double {
        val w2 = wx * wx + wy * wy + wz * wz
        if (isExact) return use(2 * w2, 2 * w2)
        if (shaking > 0.0) {
            val most = sqrt(fall2) + shaking
            val fastest = sqrt(w2) + most * rest
            val far = sqrt(q2) + fastest * rest
            return use(-2 * far * most, 2 * (fastest * fastest + far * most))
        }
        val qg = qx * fallX + qy * fallY + qz * fallZ
        val wg = wx * fallX + wy * fallY + wz * fallZ
        val now = 2 * (w2 + qg)
        val then = now + (6 * wg + 3 * fall2 * rest) * rest
        val lowest = if (fall2 == 0.0) 0.0 else maxOf(0.0, minOf(-wg / fall2, rest))
        return use(now + (6 * wg + 3 * fall2 * lowest) * lowest, maxOf(now, then))
    }

    override fun spread(span: Double) {
        val g = sqrt(gx * gx + gy * gy + gz * gz)
        val low = motion?.lowest(phase, span) ?: 0.0
        val high = motion?.highest(phase, span) ?: 0.0
        middle = (low + high) / 2
        play = 0.125 * g * duration * duration + (high - low) / 2
    }

    override fun soonest(x: Double, y: Double, z: Double, vx: Double, vy: Double, vz: Double, r: Double): Double {
        val dx = x - ox - middle * wall.way[0]
        val dy = y - oy - middle * wall.way[1]
        val dz = z - oz - middle * wall.way[2]
        val h = dx * ax + dy * ay + dz * az
        val qx = dx - h * ax
        val qy = dy - h * ay
        val qz = dz - h * az
        val wide = r + play
        val gap = wall.gap(qx * qx + qy * qy + qz * qz, h, wide)
        if (gap <= 0.0) return 0.0
        val u = vx * ax + vy * ay + vz * az
        val wx = vx - u * ax
        val wy = vy - u * ay
        val wz = vz - u * az
        val rate = wall.rate(qx * wx + qy * wy + qz * wz, h, u, wide)
        val square = 2 * (wx * wx + wy * wy + wz * wz)
        return waitForGap(gap, rate, wall.bending(square, square, h, u, 0.0, 0.0, wide), isExact = true)
    }

    override fun meet(rows: StepRows, slot: Int, time: Double, impact: WallImpact): Boolean {
        relative(rows, slot, time) { qx, qy, qz, _, wx, wy, wz, u ->
            val q = sqrt(qx * qx + qy * qy + qz * qz)
            // In the middle of a surface that has no room for the sphere.
            if (q == 0.0) return false
            val qw = qx * wx + qy * wy + qz * wz
            val along = qw / q
            val turning = (wx * wx + wy * wy + wz * wz - along * along) / q
            val falling = (qx * fallX + qy * fallY + qz * fallZ) / q
            wall.meet(qx, qy, qz, q, turning + falling, fall, impact)
            impact.rate = impact.nx * wx + impact.ny * wy + impact.nz * wz + impact.lean * u
            impact.press = maxOf(0.0, impact.press + shaking)
        }
        return true
    }

    override fun least(impact: WallImpact, r: Double): Double {
        val gain = minOf(impact.press * moment, sqrt(impact.press * r))
        return gain * if (impact.coefficient == 1.0) LEAST_ELASTIC else MovingFace.LEAST_INELASTIC
    }

    override fun glide(impact: WallImpact, moving: Double) {
        wall.glide(impact)
        val way = wall.way
        impact.surface(impact.sx + moving * way[0], impact.sy + moving * way[1], impact.sz + moving * way[2])
    }

    private companion object {
        const val GRAIN = 1e-15

        /** As for faces, but less, as what presses may be the path itself; see [MovingFace.rebound]. */
        const val LEAST_ELASTIC = 1e-5
    }
}
