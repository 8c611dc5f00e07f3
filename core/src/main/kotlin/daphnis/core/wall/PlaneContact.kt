package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallImpact

/** A plane within a step: a [MovingFace] across its normal. */
internal class PlaneContact(private val wall: PlaneWall, number: Int, walls: WallSet, law: CollisionLaw) :
    SurfaceContact(wall, number, walls, law) {
    private val ox = wall.origin[0]
    private val oy = wall.origin[1]
    private val oz = wall.origin[2]
    private val ax = wall.direction[0]
    private val ay = wall.direction[1]
    private val az = wall.direction[2]
    private val plane = MovingFace(true, motion, gx * ax + gy * ay + gz * az)

    /** See [soonest]. */
    private var innermost = 0.0

    override fun begin(start: Double, duration: Double) {
        super.begin(start, duration)
        plane.begin(0.0, start, duration)
    }

    override fun time(rows: StepRows, slot: Int): Double {
        val state = rows.state
        val p = slot * STRIDE
        val x = (state[p] - ox) * ax + (state[p + 1] - oy) * ay + (state[p + 2] - oz) * az
        return plane.contact(x, across(rows, slot), state[p + RADIUS], state[p + TIME])
    }

    private fun across(rows: StepRows, slot: Int): Double {
        val v = slot * STRIDE + VX
        return rows.state[v] * ax + rows.state[v + 1] * ay + rows.state[v + 2] * az
    }

    override fun spread(span: Double) {
        innermost = plane.innermost(span)
    }

    override fun soonest(x: Double, y: Double, z: Double, vx: Double, vy: Double, vz: Double, r: Double): Double {
        val gap = (x - ox) * ax + (y - oy) * ay + (z - oz) * az - innermost - r
        if (gap <= 0.0) return 0.0
        val rate = vx * ax + vy * ay + vz * az
        return if (rate < 0.0) -gap / rate else NEVER
    }

    override fun meet(rows: StepRows, slot: Int, time: Double, impact: WallImpact): Boolean {
        impact.normal(ax, ay, az)
        impact.length = 1.0
        impact.rate = -plane.approach(across(rows, slot), time)
        return true
    }

    override fun least(impact: WallImpact, r: Double): Double = plane.rebound(0.0, impact.coefficient, r, impact.time)

    override fun glide(impact: WallImpact, moving: Double) {
        val belt = wall.belt
        impact.surface(belt[0] + moving * ax, belt[1] + moving * ay, belt[2] + moving * az)
    }
}
