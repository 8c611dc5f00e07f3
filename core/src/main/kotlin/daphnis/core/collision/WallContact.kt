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
 * from 0, and in the order of events a wall counts as an id of that negative number.
 */
@EngineApi
public class WallContact {
    private val lower = DoubleArray(3)
    private val upper = DoubleArray(3)
    private val walled = BooleanArray(3)
    private var restitution = 1.0
    private val roughness = arrayOfNulls<Roughness>(FACES)
    private var spins: SpinExchange? = null

    /** Whether there is any wall. */
    public var present: Boolean = false
        private set

    /** Takes over the walls of [boundary] for spheres whose collisions have a [law]. */
    public fun prepare(boundary: BoundaryConditions, law: CollisionLaw) {
        present = false
        for (axis in 0..2) {
            walled[axis] = boundary.contactFaces(axis) == ContactFaces.WALL
            lower[axis] = boundary.box.lower(axis)
            upper[axis] = boundary.box.upper(axis)
            present = present || walled[axis]
        }
        restitution = boundary.wallRestitution
        for (face in 0 until FACES) roughness[face] = boundary.wallRoughness(face)
        spins = law.spins
    }

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
        val outward = if (face and 1 == 0) -v else v
        if (outward <= 0.0) return NEVER
        val gap = if (face and 1 == 0) (x - r) - lower[axis] else upper[axis] - (x + r)
        return rows.state[p + TIME] + if (gap <= 0.0) 0.0 else gap / outward
    }

    /** Reflects sphere [slot] at wall [face] at [time]; the caller does not read [outcome]. */
    public fun reflect(rows: StepRows, slot: Int, face: Int, time: Double, outcome: CollisionOutcome) {
        rows.advance(slot, time)
        val v = slot * STRIDE + VX + (face shr 1)
        roughness[face]?.let {
            spins!!.reflect(rows, it, slot, face, abs(rows.state[v]), restitution, time, outcome.contact)
        }
        // +0.0 from a wall that absorbs all of the speed, whichever way the sphere came.
        rows.state[v] = rows.state[v] * -restitution + 0.0
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
