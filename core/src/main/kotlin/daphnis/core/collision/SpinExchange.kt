package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.Roughness
import daphnis.core.surface.SurfaceContact
import kotlin.math.sqrt

/**
 * What roughness adds to an impact. With **n** the normal, from the first to the second, reduced mass μ, moments of
 * inertia q m r² and **g** the velocity of the second surface relative to the first at the point of contact,
 *
 * **g** = **u** − (**u**·**n**) **n** − (r₁ **ω**₁ + r₂ **ω**₂) × **n**,
 *
 * the first sphere receives the momentum **J** = μ (1 + β) q/(1 + q) **g**, the second −**J**, and **ω** of each grows
 * by
 * **n** × **J** / (q m r). After that the surfaces move with −β **g**. A wall is a second sphere of infinite mass that
 * does not turn.
 *
 * **Levers.** The impulse acts at one point, which divides the separation as the radii are: at r₁ **l** from the first
 * centre, with **l** the separation over r₁ + r₂. So angular momentum is conserved to round-off, also by spheres that
 * overlap after a wrap. **l** takes the place of **n**, and l²/q that of 1/q: what rounding makes of the length of
 * **l** is no energy, and no square root is needed.
 *
 * **Hill's frame.** Between collisions a spin whose axes turn with angular speed [turning] about z turns backwards in
 * them. Within a step spins are kept in the axes of its start, in which they rest, so a sphere changes only at its own
 * collisions. An impact turns them to its time and what it adds back; [daphnis.core.hill.HillFrame] turns all at the
 * end of the step.
 *
 * @param turning Ω of the axes in which spins are given
 */
internal class SpinExchange(private val momentFactor: Double, private val turning: Double) {
    // For solid spheres this is exact, 5/2. A factor 2/7 would be rounded, always to the same side, and so change the
    // energy of perfectly rough spheres a little in every impact.
    private val inverse = 1.0 / momentFactor

    /**
     * Describes the impact of [first] and [second] in the contact of [outcome], which has its speed, and puts **g** in
     * place of the momentum that [rub] finds. Of spheres without spins **g** is that of their velocities.
     */
    fun meet(rows: StepRows, first: Int, second: Int, time: Double, outcome: CollisionOutcome) {
        val dx = outcome.separationX
        val dy = outcome.separationY
        val dz = outcome.separationZ
        val along = outcome.nearing / outcome.distance2
        var gx = outcome.ux - along * dx
        var gy = outcome.uy - along * dy
        var gz = outcome.uz - along * dz
        if (rows.hasSpin) {
            val r1 = rows.state[first * STRIDE + RADIUS]
            val r2 = rows.state[second * STRIDE + RADIUS]
            val reach = r1 + r2
            val lx = dx / reach
            val ly = dy / reach
            val lz = dz / reach
            val sx = r1 * rows.wx[first] + r2 * rows.wx[second]
            val sy = r1 * rows.wy[first] + r2 * rows.wy[second]
            val wz = r1 * rows.wz[first] + r2 * rows.wz[second]
            val cosine = cosine(time)
            val sine = sine(time)
            val wx = cosine * sx + sine * sy
            val wy = cosine * sy - sine * sx
            gx -= wy * lz - wz * ly
            gy -= wz * lx - wx * lz
            gz -= wx * ly - wy * lx
            outcome.cosine = cosine
            outcome.sine = sine
        }
        outcome.slideX = gx
        outcome.slideY = gy
        outcome.slideZ = gz
        val contact = outcome.contact
        contact.ofPair(rows, first, second)
        contact.momentFactor = momentFactor
        contact.normalSpeed = outcome.impactSpeed
        contact.tangentialSpeed = sqrt(gx * gx + gy * gy + gz * gz)
        contact.restitution = Double.NaN
    }

    /** The impulse along the surfaces of [first] and [second], which [meet] has described, by β of [law]. */
    fun rub(rows: StepRows, law: ContactLaw, first: Int, second: Int, outcome: CollisionOutcome) {
        val contact = outcome.contact
        val sliding = contact.tangentialSpeed
        val factor = if (sliding == 0.0) 0.0 else checked(law.change(contact), sliding)
        val state = rows.state
        val r1 = state[first * STRIDE + RADIUS]
        val r2 = state[second * STRIDE + RADIUS]
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val reach = r1 + r2
        val lx = outcome.separationX / reach
        val ly = outcome.separationY / reach
        val lz = outcome.separationZ / reach
        var gx = outcome.slideX
        var gy = outcome.slideY
        var gz = outcome.slideZ
        val g2 = gx * gx + gy * gy + gz * gz
        val compliance = 1.0 + inverse * (lx * lx + ly * ly + lz * lz)
        gx /= compliance
        gy /= compliance
        gz /= compliance
        val f1 = factor * (m2 / (m1 + m2))
        val f2 = factor * (m1 / (m1 + m2))
        // From the reduced mass, as the impulse along the normal.
        val moved = factor * (m1 * m2 / (m1 + m2))
        outcome.slideX = -moved * gx
        outcome.slideY = -moved * gy
        outcome.slideZ = -moved * gz
        outcome.rubbed = 0.5 * moved * (2.0 - factor) * (g2 / compliance)
        push(rows, first, f1 * gx, f1 * gy, f1 * gz)
        push(rows, second, -f2 * gx, -f2 * gy, -f2 * gz)
        val kx = ly * gz - lz * gy
        val ky = lz * gx - lx * gz
        val kz = lx * gy - ly * gx
        val ax = outcome.cosine * kx - outcome.sine * ky
        val ay = outcome.cosine * ky + outcome.sine * kx
        spin(rows, first, f1 * inverse / r1, ax, ay, kz)
        spin(rows, second, f2 * inverse / r2, ax, ay, kz)
    }

    /**
     * The impact of [slot] on a wall, which [outcome] describes with its unit normal, by β of [roughness]. Velocities
     * are the true ones, not those of chords.
     */
    fun reflect(rows: StepRows, roughness: Roughness, slot: Int, outcome: CollisionOutcome) {
        val impact = outcome.wall
        val nx = -impact.nx
        val ny = -impact.ny
        val nz = -impact.nz
        val p = slot * STRIDE + VX
        val ux = impact.sx - rows.state[p]
        val uy = impact.sy - rows.state[p + 1]
        val uz = impact.sz - rows.state[p + 2]
        val across = ux * nx + uy * ny + uz * nz
        val r = rows.state[slot * STRIDE + RADIUS]
        val cosine = cosine(impact.time)
        val sine = sine(impact.time)
        val wx = r * (cosine * rows.wx[slot] + sine * rows.wy[slot])
        val wy = r * (cosine * rows.wy[slot] - sine * rows.wx[slot])
        val wz = r * rows.wz[slot]
        // Of the wall relative to the sphere's surface.
        var gx = ux - across * nx - (wy * nz - wz * ny)
        var gy = uy - across * ny - (wz * nx - wx * nz)
        var gz = uz - across * nz - (wx * ny - wy * nx)
        val sliding = sqrt(gx * gx + gy * gy + gz * gz)
        val contact = outcome.contact
        contact.ofWall(rows, slot)
        contact.momentFactor = momentFactor
        contact.normalSpeed = impact.speed
        contact.tangentialSpeed = sliding
        contact.restitution = impact.coefficient
        val factor = if (sliding == 0.0) 0.0 else checked(roughness.change(contact), sliding)
        gx /= 1.0 + inverse
        gy /= 1.0 + inverse
        gz /= 1.0 + inverse
        push(rows, slot, factor * gx, factor * gy, factor * gz)
        val kx = ny * gz - nz * gy
        val ky = nz * gx - nx * gz
        val kz = nx * gy - ny * gx
        spin(rows, slot, factor * inverse / r, cosine * kx - sine * ky, cosine * ky + sine * kx, kz)
    }

    /** The [change] 1 + β that a law gives where surfaces slide with [speed]. */
    private fun checked(change: Double, speed: Double): Double {
        // NaN is in no range.
        require(change >= 0.0 && change <= 2.0) {
            "the coefficient of tangential restitution is ${change - 1.0} where surfaces slide at $speed; " +
                "it must be in [-1, 1]"
        }
        return change
    }

    // Adding 0.0 turns −0.0 into +0.0, see CollisionLaw.
    private fun push(rows: StepRows, slot: Int, x: Double, y: Double, z: Double) {
        val state = rows.state
        val p = slot * STRIDE + VX
        state[p] = (state[p] + x) + 0.0
        state[p + 1] = (state[p + 1] + y) + 0.0
        state[p + 2] = (state[p + 2] + z) + 0.0
    }

    private fun spin(rows: StepRows, slot: Int, factor: Double, x: Double, y: Double, z: Double) {
        rows.wx[slot] = (rows.wx[slot] + factor * x) + 0.0
        rows.wy[slot] = (rows.wy[slot] + factor * y) + 0.0
        rows.wz[slot] = (rows.wz[slot] + factor * z) + 0.0
    }

    private fun cosine(time: Double) = if (turning == 0.0) 1.0 else StrictMath.cos(turning * time)

    private fun sine(time: Double) = if (turning == 0.0) 0.0 else StrictMath.sin(turning * time)
}
