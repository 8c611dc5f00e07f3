package daphnis.core.collision

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.RoomSide
import daphnis.core.boundary.WallSurface
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import kotlin.math.abs

/**
 * What an impact on a [WallSurface] does: it reverses the velocity along the normal, with the wall's restitution or at
 * its temperature, and rubs. Velocities are the true ones at the impact, not those of chords (see [MovingFace]).
 *
 * @param place number of the partner as a face, see [WallContact]
 */
internal class SurfaceImpact(
    private val surface: WallSurface,
    place: Int,
    boundary: BoundaryConditions,
    private val law: CollisionLaw,
) {
    private val restitution = surface.face.restitution ?: boundary.wallRestitution
    private val thermal =
        surface.face.temperature?.let { ThermalWall(place, it, boundary.space, boundary.wallSeed) }
    private val reach = if (surface.side == RoomSide.INSIDE) -surface.radius else surface.radius
    private val gx = law.acceleration(0)
    private val gy = law.acceleration(1)
    private val gz = law.acceleration(2)

    /** A step begins at [start]. */
    fun begin(start: Double) {
        thermal?.begin(start)
    }

    /** An impact of [slot] begins that may change nothing. */
    fun begin(rows: StepRows, slot: Int, outcome: CollisionOutcome) {
        outcome.impactSpeed = 0.0
        outcome.impulse = 0.0
        outcome.coefficient = 1.0
        outcome.forgetSurfaces()
        outcome.rank = rows.rank(slot)
        outcome.separationX = 0.0
        outcome.separationY = 0.0
        outcome.separationZ = 0.0
    }

    /**
     * The impact at a place where (nx, ny, nz) into the room has the [length], and the velocity relative to the surface
     * has the product [rate] with it.
     *
     * @param slope by how much chords exceed true velocities, in units of gravity
     * @param moving velocity of the surface along its way
     * @param least the speed with which it leaves at least, where the coefficient of restitution is given
     */
    inline fun meet(
        rows: StepRows,
        slot: Int,
        time: Double,
        slope: Double,
        moving: Double,
        nx: Double,
        ny: Double,
        nz: Double,
        length: Double,
        rate: Double,
        outcome: CollisionOutcome,
        least: (Double) -> Double,
    ) {
        val speed = -rate / length
        val r = rows.state[slot * STRIDE + RADIUS]
        outcome.impactSpeed = maxOf(speed, 0.0)
        outcome.separationX = r * (nx / length)
        outcome.separationY = r * (ny / length)
        outcome.separationZ = r * (nz / length)
        // Else it leaves, by rounding, or the wall has turned around at this very moment.
        if (speed < 0.0) return
        val coefficient = law.atWall(restitution, rows, slot, speed, time)
        val needed = maxOf(least(coefficient), VELOCITY_ROUNDING * fastest(rows, slot, slope, moving))
        val leaving = maxOf(coefficient * speed, needed)
        // Without a square root, that would cost energy, unless the speed is that needed.
        val isFree = coefficient * speed >= needed
        val factor = if (isFree) -(1.0 + coefficient) * rate / (length * length) else (speed + leaving) / length
        val kick = factor * length
        exchange(rows, slot, time, slope, moving, nx / length, ny / length, nz / length, kick, coefficient, outcome)
    }

    /**
     * Gives the sphere the speed [kick] along the unit normal (nx, ny, nz), unless the wall is thermal, and what it
     * gets along the surface.
     */
    fun exchange(
        rows: StepRows,
        slot: Int,
        time: Double,
        slope: Double,
        moving: Double,
        nx: Double,
        ny: Double,
        nz: Double,
        kick: Double,
        coefficient: Double,
        outcome: CollisionOutcome,
    ) {
        val state = rows.state
        val v = slot * STRIDE + VX
        val speed = outcome.impactSpeed
        val chordX = state[v]
        val chordY = state[v + 1]
        val chordZ = state[v + 2]
        val x = chordX - slope * gx
        val y = chordY - slope * gy
        val z = chordZ - slope * gz
        state[v] = x
        state[v + 1] = y
        state[v + 2] = z
        val before = energy(rows, slot)
        if (thermal != null || surface.roughness != null) {
            rub(rows, slot, time, moving, nx, ny, nz, speed, coefficient, outcome)
        }
        if (thermal == null) {
            state[v] += kick * nx
            state[v + 1] += kick * ny
            state[v + 2] += kick * nz
        }
        val mass = rows.mass[slot]
        val dx = state[v] - x
        val dy = state[v + 1] - y
        val dz = state[v + 2] - z
        val push = dx * nx + dy * ny + dz * nz
        outcome.impulse = mass * push
        outcome.coefficient = if (speed > 0.0) push / speed - 1.0 else 1.0
        outcome.slideX = mass * (dx - push * nx)
        outcome.slideY = mass * (dy - push * ny)
        outcome.slideZ = mass * (dz - push * nz)
        outcome.rubbed = before - energy(rows, slot)
        // +0.0 as in collisions of spheres.
        state[v] = chordX + dx + 0.0
        state[v + 1] = chordY + dy + 0.0
        state[v + 2] = chordZ + dz + 0.0
    }

    /** What the surface does along itself; a thermal one gives the whole velocity. */
    private fun rub(
        rows: StepRows,
        slot: Int,
        time: Double,
        moving: Double,
        nx: Double,
        ny: Double,
        nz: Double,
        speed: Double,
        coefficient: Double,
        outcome: CollisionOutcome,
    ) {
        val sx = glide(0, nx, ny, nz) + moving * surface.way[0]
        val sy = glide(1, nx, ny, nz) + moving * surface.way[1]
        val sz = glide(2, nx, ny, nz) + moving * surface.way[2]
        if (thermal == null) {
            val roughness = surface.roughness!!
            val contact = outcome.contact
            law.spins.reflect(rows, roughness, slot, -nx, -ny, -nz, sx, sy, sz, speed, coefficient, time, contact)
            return
        }
        val leaving = thermal.draw(rows, slot, time, nx, ny, nz, sx, sy, sz)
        val v = slot * STRIDE + VX
        val needed = VELOCITY_ROUNDING * (abs(moving) + abs(gx) + abs(gy) + abs(gz))
        val kick = maxOf(leaving, needed)
        rows.state[v] += kick * nx
        rows.state[v + 1] += kick * ny
        rows.state[v + 2] += kick * nz
    }

    /** Velocity of the surface along itself, along [axis]. */
    private fun glide(axis: Int, nx: Double, ny: Double, nz: Double): Double {
        val w = surface.turning
        if (surface.isPlane) return w[axis]
        return reach * when (axis) {
            0 -> w[1] * nz - w[2] * ny
            1 -> w[2] * nx - w[0] * nz
            else -> w[0] * ny - w[1] * nx
        }
    }

    private fun fastest(rows: StepRows, slot: Int, slope: Double, moving: Double): Double {
        val v = slot * STRIDE + VX
        val bow = abs(slope) * maxOf(abs(gx), abs(gy), abs(gz))
        return maxOf(abs(rows.state[v]), abs(rows.state[v + 1]), abs(rows.state[v + 2])) + bow + abs(moving)
    }

    private fun energy(rows: StepRows, slot: Int): Double {
        val p = slot * STRIDE
        val state = rows.state
        var squares = 0.0
        for (k in VX until VX + 3) squares += state[p + k] * state[p + k]
        return law.energy(rows, slot, squares)
    }

    companion object {
        const val VELOCITY_ROUNDING = 1e-14
    }
}
