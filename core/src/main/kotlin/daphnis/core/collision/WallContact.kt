package daphnis.core.collision

import daphnis.core.api.EngineApi
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.surface.Roughness
import kotlin.math.abs

/**
 * Reflecting walls. A wall is a partner with a negative number, −1 − face; faces are numbered −x, +x, −y, +y, −z, +z
 * from 0, and in the order of events a wall counts as an id of that negative number. Walls that move, and those across a
 * uniform acceleration, are [MovingFace]s.
 */
@EngineApi
public class WallContact {
    private val lower = DoubleArray(3)
    private val upper = DoubleArray(3)
    private val walled = BooleanArray(3)
    private val restitution = DoubleArray(FACES)
    private val roughness = arrayOfNulls<Roughness>(FACES)
    private val moving = arrayOfNulls<MovingFace>(FACES)
    private val thermal = arrayOfNulls<ThermalWall>(FACES)
    private var boundary: BoundaryConditions? = null
    private var law: CollisionLaw? = null

    /** Whether there is any wall. */
    public var present: Boolean = false
        private set

    /**
     * Takes over the walls of [boundary] for spheres whose collisions have a [law], for a step of [duration] that begins
     * at [start]; neither matters where walls rest and nothing falls.
     */
    @JvmOverloads
    public fun prepare(boundary: BoundaryConditions, law: CollisionLaw, start: Double = 0.0, duration: Double = 0.0) {
        present = false
        for (axis in 0..2) {
            walled[axis] = boundary.contactFaces(axis) == ContactFaces.WALL
            lower[axis] = boundary.box.lower(axis)
            upper[axis] = boundary.box.upper(axis)
            present = present || walled[axis]
        }
        if (boundary !== this.boundary || law !== this.law) takeFaces(boundary, law)
        for (face in 0 until FACES) {
            moving[face]?.begin(faceOf(face), start, duration)
            thermal[face]?.begin(start)
        }
    }

    private fun takeFaces(boundary: BoundaryConditions, law: CollisionLaw) {
        for (face in 0 until FACES) {
            val axis = face shr 1
            restitution[face] = boundary.wallRestitution(face)
            roughness[face] = boundary.wallRoughness(face)
            thermal[face] = boundary.wallTemperature(face)?.let { ThermalWall(face, it, boundary.wallSeed) }
            val gravity = law.acceleration(axis)
            val motion = boundary.wallMotion(face)
            val rests = !walled[axis] || gravity == 0.0 && motion == null
            moving[face] = if (rests) null else MovingFace(face and 1 == 0, motion, gravity)
        }
        this.boundary = boundary
        this.law = law
    }

    private fun faceOf(face: Int) = if (face and 1 == 0) lower[face shr 1] else upper[face shr 1]

    /**
     * The time at which sphere [slot] reaches the wall [face], from the start of the step, or [NEVER]. A sphere that
     * overlaps the wall and moves outward touches at once.
     */
    public fun time(rows: StepRows, slot: Int, face: Int): Double {
        val axis = face shr 1
        if (!walled[axis]) return NEVER
        val p = slot * STRIDE
        val v = rows.state[p + VX + axis]
        val x = rows.state[p + axis]
        val r = rows.state[p + RADIUS]
        moving[face]?.let { return it.contact(x, v, r, rows.state[p + TIME]) }
        val outward = if (face and 1 == 0) -v else v
        if (outward <= 0.0) return NEVER
        val gap = if (face and 1 == 0) (x - r) - lower[axis] else upper[axis] - (x + r)
        return rows.state[p + TIME] + if (gap <= 0.0) 0.0 else gap / outward
    }

    /**
     * Where a sphere may touch the wall [face] that is at the box's face when it rests: as far into the room as the wall
     * comes, for paths that are straight within each step, in steps that cover the time [span] from the start of this
     * one.
     */
    internal fun innermost(face: Int, span: Double): Double = moving[face]?.innermost(span) ?: faceOf(face)

    /** Reflects sphere [slot] at wall [face] at [time]; the caller does not read [outcome]. */
    public fun reflect(rows: StepRows, slot: Int, face: Int, time: Double, outcome: CollisionOutcome) {
        rows.advance(slot, time)
        val v = slot * STRIDE + VX + (face shr 1)
        if (moving[face] != null || thermal[face] != null) return reflectElsewise(rows, slot, face, time, outcome)
        rub(rows, slot, face, abs(rows.state[v]), restitution[face], time, outcome)
        // +0.0 from a wall that absorbs all of the speed, whichever way the sphere came.
        rows.state[v] = rows.state[v] * -restitution[face] + 0.0
    }

    private fun rub(
        rows: StepRows,
        slot: Int,
        face: Int,
        speed: Double,
        restitution: Double,
        time: Double,
        outcome: CollisionOutcome,
    ) {
        val roughness = roughness[face] ?: return
        law!!.spins.reflect(rows, roughness, slot, face, speed, restitution, time, outcome.contact)
    }

    private fun reflectElsewise(rows: StepRows, slot: Int, face: Int, time: Double, outcome: CollisionOutcome) {
        val v = slot * STRIDE + VX + (face shr 1)
        val inward = if (face and 1 == 0) 1.0 else -1.0
        val wall = moving[face]
        val speed = wall?.approach(rows.state[v], time) ?: (-inward * rows.state[v])
        // The wall has turned around at this very moment.
        if (speed < 0.0) return
        val thermal = thermal[face]
        val coefficient = if (wall == null) restitution[face] else guarded(rows, slot, face, speed, time)
        if (thermal == null) rub(rows, slot, face, speed, coefficient, time, outcome)
        val leaving = thermal?.draw(rows, slot, time) ?: (coefficient * speed)
        rows.state[v] = wall?.leaving(wall.rebound(leaving, coefficient, time), time) ?: (inward * leaving + 0.0)
    }

    /** The coefficient of restitution of a wall that moves, which the guard may make 1 as between spheres. */
    private fun guarded(rows: StepRows, slot: Int, face: Int, speed: Double, time: Double): Double {
        val guard = law!!.guard
        if (!guard.needsLastCollision) {
            return if (guard.makesElastic(speed, 0.0, 0.0)) 1.0 else restitution[face]
        }
        val since = time - rows.lastCollision[slot]
        rows.lastCollision[slot] = time
        return if (guard.makesElastic(speed, since, Double.POSITIVE_INFINITY)) 1.0 else restitution[face]
    }

    public companion object {
        public const val FACES: Int = 6

        /** The partner number of [face]. */
        @JvmStatic
        public fun partner(face: Int): Int = -1 - face

        /** The face of a partner number. */
        @JvmStatic
        public fun face(partner: Int): Int = -1 - partner
    }
}
