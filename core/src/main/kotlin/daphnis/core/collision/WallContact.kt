package daphnis.core.collision

import daphnis.core.api.EngineApi
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.Piston
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.surface.Roughness
import kotlin.math.abs

/**
 * Reflecting walls. A wall is a partner with a negative number, −1 − face; faces are numbered −x, +x, −y, +y, −z, +z
 * from 0, and in the order of events a wall counts as an id of that negative number. Walls that move, and those across
 * a uniform acceleration, are [MovingFace]s. Numbers from [FACES] on are those of the boundary's surfaces, each a
 * [SurfaceWall].
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
    private var surfaces = emptyArray<SurfaceWall>()
    private val pistons = arrayOfNulls<Piston>(FACES)
    private val acceleration = DoubleArray(3)
    private var duration = 0.0
    private var boundary: BoundaryConditions? = null
    private var law: CollisionLaw? = null

    /** How many walls there are that are not faces of the box. */
    internal val surfaceCount: Int get() = surfaces.size

    /** Whether there is any wall. */
    public var present: Boolean = false
        private set

    /** Whether any wall moves or is thermal. Then collisions with walls are recorded as well, see [CollisionRecord]. */
    public var areDriven: Boolean = false
        private set

    /**
     * Takes over the walls of [boundary] for spheres whose collisions have a [law], for a step of [duration] that
     * begins at [start]; neither matters where walls rest and nothing falls.
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
        this.duration = duration
        for (face in 0 until FACES) {
            moving[face]?.begin(faceOf(face), start, duration)
            thermal[face]?.begin(start)
        }
        for (surface in surfaces) surface.begin(start, duration)
        present = present || surfaces.isNotEmpty()
    }

    private fun takeFaces(boundary: BoundaryConditions, law: CollisionLaw) {
        areDriven = false
        for (axis in 0..2) acceleration[axis] = law.acceleration(axis)
        for (face in 0 until FACES) {
            val axis = face shr 1
            restitution[face] = boundary.wallRestitution(face)
            roughness[face] = boundary.wallRoughness(face)
            thermal[face] =
                boundary.wallTemperature(face)?.let { ThermalWall(face, it, boundary.space, boundary.wallSeed) }
            val motion = boundary.wallMotion(face)
            pistons[face] = motion as? Piston
            val rests = acceleration[axis] == 0.0 && motion == null
            moving[face] = if (rests || !walled[axis]) null else MovingFace(face and 1 == 0, motion, acceleration[axis])
            areDriven = areDriven || walled[axis] && (motion != null || thermal[face] != null)
        }
        surfaces = Array(boundary.surfaces.size) { SurfaceWall(boundary.surfaces[it], FACES + it, boundary, law) }
        areDriven = areDriven || boundary.surfaces.any { it.isDriven }
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

    /** The same for surface [k]. */
    internal fun timeOfSurface(rows: StepRows, slot: Int, k: Int): Double = surfaces[k].time(rows, slot)

    /** The same for a face or a surface by its number. */
    public fun timeOfAny(rows: StepRows, slot: Int, face: Int): Double =
        if (face < FACES) time(rows, slot, face) else timeOfSurface(rows, slot, face - FACES)

    /** Surface [k], for steps that cover the time [span] from the start of this one. */
    internal fun surface(k: Int, span: Double): SurfaceWall = surfaces[k].apply { spread(span) }

    /**
     * Where a sphere may touch the wall [face] that is at the box's face when it rests: as far into the room as the
     * wall comes, for paths that are straight within each step, in steps that cover the time [span] from the start of
     * this one.
     */
    internal fun innermost(face: Int, span: Double): Double = moving[face]?.innermost(span) ?: faceOf(face)

    /**
     * Reflects sphere [slot] at wall [face] at [time]. Where walls [are driven][areDriven] it describes that in
     * [outcome]; elsewhere the caller does not read it.
     */
    public fun reflect(rows: StepRows, slot: Int, face: Int, time: Double, outcome: CollisionOutcome) {
        rows.advance(slot, time)
        if (face >= FACES) return surfaces[face - FACES].reflect(rows, slot, time, outcome)
        if (areDriven) return reflectDriven(rows, slot, face, time, outcome)
        if (moving[face] != null || law!!.hasAcceleration) return bounce(rows, slot, face, time, outcome)
        val v = slot * STRIDE + VX + (face shr 1)
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

    /** The impact of a wall that moves or is thermal, or where spheres fall. */
    private fun bounce(rows: StepRows, slot: Int, face: Int, time: Double, outcome: CollisionOutcome) {
        val axis = face shr 1
        val v = slot * STRIDE + VX + axis
        val inward = if (face and 1 == 0) 1.0 else -1.0
        val wall = moving[face]
        val speed = wall?.approach(rows.state[v], time) ?: (-inward * rows.state[v])
        outcome.impactSpeed = maxOf(speed, 0.0)
        // Else the wall has turned around at this very moment.
        if (speed < 0.0) return
        val own = if (wall == null) restitution[face] else law!!.atWall(restitution[face], rows, slot, speed, time)
        val coefficient = pistons[face]?.coefficient(own, rows.mass[slot]) ?: own
        val leaving = alongWall(rows, slot, face, speed, coefficient, time, outcome)
        rows.state[v] = if (wall == null) {
            inward * leaving + 0.0
        } else if (thermal[face] != null) {
            wall.leaving(wall.apart(leaving, time), time)
        } else {
            wall.leaving(wall.rebound(leaving, own, rows.state[slot * STRIDE + RADIUS], time), time)
        }
    }

    /**
     * Changes what spheres do along the wall, and returns the speed with which the sphere leaves relative to it.
     */
    private fun alongWall(
        rows: StepRows,
        slot: Int,
        face: Int,
        speed: Double,
        coefficient: Double,
        time: Double,
        outcome: CollisionOutcome,
    ): Double {
        val thermal = thermal[face]
        if (thermal == null && roughness[face] == null) return coefficient * speed
        val axis = face shr 1
        val v = slot * STRIDE + VX
        // Surfaces rub with true velocities, not with those of chords.
        for (k in 0..2) if (k != axis) rows.state[v + k] -= bow(k, time)
        if (thermal == null) rub(rows, slot, face, speed, coefficient, time, outcome)
        val leaving = thermal?.draw(rows, slot, time) ?: (coefficient * speed)
        for (k in 0..2) if (k != axis) rows.state[v + k] += bow(k, time)
        return leaving
    }

    /** By how much the velocity of a chord along [axis] exceeds the true one at [time]. */
    private fun bow(axis: Int, time: Double) = 0.5 * acceleration[axis] * (duration - 2 * time)

    private fun reflectDriven(rows: StepRows, slot: Int, face: Int, time: Double, outcome: CollisionOutcome) {
        val energy = energy(rows, slot, time)
        val state = rows.state
        val v = slot * STRIDE + VX
        val vx = state[v]
        val vy = state[v + 1]
        val vz = state[v + 2]
        bounce(rows, slot, face, time, outcome)
        val axis = face shr 1
        val inward = if (face and 1 == 0) 1.0 else -1.0
        val mass = rows.mass[slot]
        val before = if (axis == 0) {
            vx
        } else if (axis == 1) {
            vy
        } else {
            vz
        }
        outcome.impulse = mass * inward * (state[v + axis] - before)
        outcome.coefficient = if (outcome.impactSpeed > 0.0) outcome.impulse / mass / outcome.impactSpeed - 1.0 else 1.0
        val reach = inward * state[slot * STRIDE + RADIUS]
        outcome.separationX = if (axis == 0) reach else 0.0
        outcome.separationY = if (axis == 1) reach else 0.0
        outcome.separationZ = if (axis == 2) reach else 0.0
        outcome.slideX = if (axis == 0) 0.0 else mass * (state[v] - vx)
        outcome.slideY = if (axis == 1) 0.0 else mass * (state[v + 1] - vy)
        outcome.slideZ = if (axis == 2) 0.0 else mass * (state[v + 2] - vz)
        outcome.rubbed = energy - energy(rows, slot, time)
        outcome.rank = rows.rank(slot)
    }

    /** Energy of motion and of spin of [slot] at [time]. */
    private fun energy(rows: StepRows, slot: Int, time: Double): Double {
        var squares = 0.0
        for (k in 0..2) {
            val u = rows.state[slot * STRIDE + VX + k] - bow(k, time)
            squares += u * u
        }
        return law!!.energy(rows, slot, squares)
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
