package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallImpact
import kotlin.math.abs

/**
 * A wall that is not a face of the box within a step. An impact reverses the velocity along the normal, with the wall's
 * restitution or at its temperature, and rubs. Velocities are the true ones, not those of chords (see [MovingFace]).
 */
internal abstract class SurfaceContact(wall: Wall, number: Int, walls: WallSet, law: CollisionLaw) :
    WallLaw(wall, number, walls, law) {
    /**
     * Writes to [impact] how sphere [slot] meets the wall at [time], with a normal of any length.
     *
     * @return false where there is no normal
     */
    protected abstract fun meet(rows: StepRows, slot: Int, time: Double, impact: WallImpact): Boolean

    /** The speed with which a sphere of radius [r] leaves at least, see [MovingFace.rebound]. */
    protected abstract fun least(impact: WallImpact, r: Double): Double

    /** Writes the velocity of the surface, which moves with [moving] along its way, where the unit normal is known. */
    protected abstract fun glide(impact: WallImpact, moving: Double)

    override fun reflect(rows: StepRows, slot: Int, time: Double, outcome: CollisionOutcome) {
        outcome.begin(rows.rank(slot))
        val impact = outcome.wall
        impact.time = time
        if (!meet(rows, slot, time, impact)) return
        val length = impact.length
        val rate = impact.rate
        val speed = -rate / length
        val r = rows.state[slot * STRIDE + RADIUS]
        impact.normal(impact.nx / length, impact.ny / length, impact.nz / length)
        impact.speed = maxOf(speed, 0.0)
        outcome.impactSpeed = impact.speed
        outcome.separationX = r * impact.nx
        outcome.separationY = r * impact.ny
        outcome.separationZ = r * impact.nz
        // Else it leaves, by rounding, or the wall has turned around at this very moment.
        if (speed < 0.0) return
        val moving = motion?.velocity(phase, time) ?: 0.0
        val coefficient = law.atWall(restitution, rows, slot, speed, time)
        impact.coefficient = coefficient
        val needed = maxOf(least(impact, r), VELOCITY_ROUNDING * fastest(rows, slot, time, moving))
        val leaving = maxOf(coefficient * speed, needed)
        // Without a square root, that would cost energy, unless the speed is that needed.
        val isFree = coefficient * speed >= needed
        val factor = if (isFree) -(1.0 + coefficient) * rate / (length * length) else (speed + leaving) / length
        exchange(rows, slot, factor * length, moving, outcome)
    }

    /**
     * Gives the sphere the speed [kick] along the normal, unless the wall is thermal, and what it gets along the
     * surface.
     */
    private fun exchange(rows: StepRows, slot: Int, kick: Double, moving: Double, outcome: CollisionOutcome) {
        val impact = outcome.wall
        val state = rows.state
        val v = slot * STRIDE + VX
        val chordX = state[v]
        val chordY = state[v + 1]
        val chordZ = state[v + 2]
        straighten(rows, slot, impact.time, 1.0)
        val x = state[v]
        val y = state[v + 1]
        val z = state[v + 2]
        val before = energy(rows, slot, 0.0)
        if (thermal != null || roughness != null) glide(impact, moving)
        if (roughness != null) law.spins.reflect(rows, roughness, slot, outcome)
        push(rows, slot, impact, if (thermal == null) kick else warmed(rows, slot, moving, impact))
        val mass = rows.mass[slot]
        val dx = state[v] - x
        val dy = state[v + 1] - y
        val dz = state[v + 2] - z
        val push = dx * impact.nx + dy * impact.ny + dz * impact.nz
        outcome.impulse = mass * push
        outcome.coefficient = if (impact.speed > 0.0) push / impact.speed - 1.0 else 1.0
        outcome.slideX = mass * (dx - push * impact.nx)
        outcome.slideY = mass * (dy - push * impact.ny)
        outcome.slideZ = mass * (dz - push * impact.nz)
        outcome.rubbed = before - energy(rows, slot, 0.0)
        // +0.0 as in collisions of spheres.
        state[v] = chordX + dx + 0.0
        state[v + 1] = chordY + dy + 0.0
        state[v + 2] = chordZ + dz + 0.0
    }

    private fun push(rows: StepRows, slot: Int, impact: WallImpact, kick: Double) {
        val v = slot * STRIDE + VX
        rows.state[v] += kick * impact.nx
        rows.state[v + 1] += kick * impact.ny
        rows.state[v + 2] += kick * impact.nz
    }

    /** Gives [slot] the velocity of a thermal wall along itself, and returns the speed with which it leaves. */
    private fun warmed(rows: StepRows, slot: Int, moving: Double, impact: WallImpact) =
        maxOf(thermal!!.draw(rows, slot, impact), VELOCITY_ROUNDING * (abs(moving) + abs(gx) + abs(gy) + abs(gz)))

    private fun fastest(rows: StepRows, slot: Int, time: Double, moving: Double): Double {
        val v = slot * STRIDE + VX
        val bow = abs(slope(time)) * maxOf(abs(gx), abs(gy), abs(gz))
        return maxOf(abs(rows.state[v]), abs(rows.state[v + 1]), abs(rows.state[v + 2])) + bow + abs(moving)
    }

    private companion object {
        const val VELOCITY_ROUNDING = 1e-14
    }
}
