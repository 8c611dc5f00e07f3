package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX

/** What the kinds of [ContactWall] have in common: what acts at an impact, and the step. */
internal abstract class WallLaw(wall: Wall, number: Int, walls: WallSet, protected val law: CollisionLaw) :
    ContactWall {
    protected val motion = wall.motion
    protected val roughness = wall.roughness
    protected val restitution = wall.restitution ?: walls.restitution
    protected val thermal = wall.temperature?.let { ThermalWall(number, it, walls.space, walls.seed) }
    protected val gx = law.acceleration(0)
    protected val gy = law.acceleration(1)
    protected val gz = law.acceleration(2)
    protected var duration = 0.0
        private set

    /** See [WallMotion.phase]. */
    protected var phase = 0.0
        private set

    override fun begin(start: Double, duration: Double) {
        this.duration = duration
        phase = motion?.phase(start) ?: 0.0
        thermal?.begin(start)
    }

    /** By how much velocities of chords exceed the true ones at [time], in units of gravity; see [MovingFace]. */
    protected fun slope(time: Double): Double = 0.5 * (duration - 2 * time)

    /** Makes velocities of chords of [slot] true ones at [time]; with −1 for [sign] the reverse. */
    protected fun straighten(rows: StepRows, slot: Int, time: Double, sign: Double) {
        val slope = sign * slope(time)
        val v = slot * STRIDE + VX
        rows.state[v] -= slope * gx
        rows.state[v + 1] -= slope * gy
        rows.state[v + 2] -= slope * gz
    }

    /** Energy of motion and of spin of [slot], whose row has a velocity that exceeds the true one by [slope] · gravity. */
    protected fun energy(rows: StepRows, slot: Int, slope: Double): Double {
        val v = slot * STRIDE + VX
        val x = rows.state[v] - slope * gx
        val y = rows.state[v + 1] - slope * gy
        val z = rows.state[v + 2] - slope * gz
        return law.energy(rows, slot, x * x + y * y + z * z)
    }
}
