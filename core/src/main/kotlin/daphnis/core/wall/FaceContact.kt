package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX

/** A face of the box within a step. A wall that moves, or is across a uniform acceleration, is a [MovingFace]. */
internal class FaceContact(wall: FaceWall, number: Int, walls: WallSet, law: CollisionLaw) :
    WallLaw(wall, number, walls, law) {
    private val axis = number shr 1
    private val isLower = number and 1 == 0
    private val inward = FaceWall.inward(number)
    private val place = wall.place
    private val gravity = law.acceleration(axis)
    private val moving = if (motion == null && gravity == 0.0) null else MovingFace(isLower, motion, gravity)

    /** Whether collisions are recorded, so that what happened has to be described. */
    private val isTold = walls.areDriven

    /** See [soonest]. */
    private var innermost = place

    override fun begin(start: Double, duration: Double) {
        super.begin(start, duration)
        moving?.begin(place, start, duration)
    }

    override fun time(rows: StepRows, slot: Int): Double {
        val p = slot * STRIDE
        val v = rows.state[p + VX + axis]
        val x = rows.state[p + axis]
        val r = rows.state[p + RADIUS]
        if (moving != null) return moving.contact(x, v, r, rows.state[p + TIME])
        val outward = if (isLower) -v else v
        if (outward <= 0.0) return NEVER
        val gap = if (isLower) (x - r) - place else place - (x + r)
        return rows.state[p + TIME] + if (gap <= 0.0) 0.0 else gap / outward
    }

    override fun spread(span: Double) {
        innermost = moving?.innermost(span) ?: place
    }

    override fun soonest(x: Double, y: Double, z: Double, vx: Double, vy: Double, vz: Double, r: Double): Double {
        val at = along(x, y, z)
        val gap = if (isLower) (at - r) - innermost else innermost - (at + r)
        if (gap <= 0.0) return 0.0
        val outward = -inward * along(vx, vy, vz)
        return if (outward > 0.0) gap / outward else NEVER
    }

    private fun along(x: Double, y: Double, z: Double) = if (axis == 0) {
        x
    } else if (axis == 1) {
        y
    } else {
        z
    }

    override fun reflect(rows: StepRows, slot: Int, time: Double, outcome: CollisionOutcome) {
        if (!isTold) return bounce(rows, slot, time, outcome)
        val slope = slope(time)
        val energy = energy(rows, slot, slope)
        val state = rows.state
        val v = slot * STRIDE + VX
        val vx = state[v]
        val vy = state[v + 1]
        val vz = state[v + 2]
        bounce(rows, slot, time, outcome)
        val mass = rows.mass[slot]
        outcome.impulse = mass * inward * (state[v + axis] - along(vx, vy, vz))
        outcome.coefficient = if (outcome.impactSpeed > 0.0) outcome.impulse / mass / outcome.impactSpeed - 1.0 else 1.0
        val reach = inward * state[slot * STRIDE + RADIUS]
        outcome.separationX = if (axis == 0) reach else 0.0
        outcome.separationY = if (axis == 1) reach else 0.0
        outcome.separationZ = if (axis == 2) reach else 0.0
        outcome.slideX = if (axis == 0) 0.0 else mass * (state[v] - vx)
        outcome.slideY = if (axis == 1) 0.0 else mass * (state[v + 1] - vy)
        outcome.slideZ = if (axis == 2) 0.0 else mass * (state[v + 2] - vz)
        outcome.rubbed = energy - energy(rows, slot, slope)
        outcome.rank = rows.rank(slot)
    }

    private fun bounce(rows: StepRows, slot: Int, time: Double, outcome: CollisionOutcome) {
        val v = slot * STRIDE + VX + axis
        val speed = moving?.approach(rows.state[v], time) ?: (-inward * rows.state[v])
        outcome.impactSpeed = maxOf(speed, 0.0)
        // Else the wall has turned around at this very moment.
        if (speed < 0.0) return
        val own = if (moving == null) restitution else law.atWall(restitution, rows, slot, speed, time)
        val coefficient = motion?.coefficient(own, rows.mass[slot]) ?: own
        val leaving = alongWall(rows, slot, speed, coefficient, time, outcome)
        rows.state[v] = if (moving == null) {
            // +0.0 from a wall that absorbs all of the speed, whichever way the sphere came.
            inward * leaving + 0.0
        } else if (thermal != null) {
            moving.leaving(moving.apart(leaving, time), time)
        } else {
            moving.leaving(moving.rebound(leaving, own, rows.state[slot * STRIDE + RADIUS], time), time)
        }
    }

    /**
     * Changes what spheres do along the wall, and returns the speed with which the sphere leaves relative to it.
     */
    private fun alongWall(
        rows: StepRows,
        slot: Int,
        speed: Double,
        coefficient: Double,
        time: Double,
        outcome: CollisionOutcome,
    ): Double {
        if (thermal == null && roughness == null) return coefficient * speed
        val v = slot * STRIDE + VX + axis
        val across = rows.state[v]
        // Surfaces rub with true velocities, not with those of chords.
        straighten(rows, slot, time, 1.0)
        rows.state[v] = across
        val leaving = thermal?.drawAtFace(rows, slot, time) ?: (coefficient * speed)
        if (roughness != null) {
            val impact = outcome.wall
            impact.time = time
            impact.normal(along(inward, 0.0, 0.0), along(0.0, inward, 0.0), along(0.0, 0.0, inward))
            impact.surface(0.0, 0.0, 0.0)
            impact.speed = speed
            impact.coefficient = coefficient
            law.spins.reflect(rows, roughness, slot, outcome)
        }
        straighten(rows, slot, time, -1.0)
        return leaving
    }
}
