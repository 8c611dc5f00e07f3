package daphnis.core.collision

import daphnis.core.Sphere
import java.math.BigDecimal
import java.math.MathContext

/** Sixty digits. */
internal val EXACTLY = MathContext(60)

internal class Exact(val x: BigDecimal, val y: BigDecimal, val z: BigDecimal) {
    constructor(x: Double, y: Double, z: Double) : this(BigDecimal(x), BigDecimal(y), BigDecimal(z))

    operator fun plus(o: Exact) = Exact(x.add(o.x, EXACTLY), y.add(o.y, EXACTLY), z.add(o.z, EXACTLY))

    operator fun minus(o: Exact) = this + o * BigDecimal(-1)

    operator fun times(f: BigDecimal) = Exact(x.multiply(f, EXACTLY), y.multiply(f, EXACTLY), z.multiply(f, EXACTLY))

    operator fun times(o: Exact): BigDecimal =
        x.multiply(o.x, EXACTLY).add(y.multiply(o.y, EXACTLY), EXACTLY).add(z.multiply(o.z, EXACTLY), EXACTLY)

    infix fun cross(o: Exact): Exact {
        fun minor(a: BigDecimal, b: BigDecimal, c: BigDecimal, d: BigDecimal) =
            a.multiply(d, EXACTLY).subtract(b.multiply(c, EXACTLY), EXACTLY)
        return Exact(minor(y, z, o.y, o.z), minor(z, x, o.z, o.x), minor(x, y, o.x, o.y))
    }

    val length: BigDecimal get() = (this * this).sqrt(EXACTLY)

    val numbers get() = listOf(x.toDouble(), y.toDouble(), z.toDouble())
}

internal operator fun BigDecimal.div(o: BigDecimal): BigDecimal = divide(o, EXACTLY)

/** A sphere with its spin, in sixty digits; of infinite mass when [m] is null. */
internal class ExactSphere(val at: Exact, val v: Exact, val w: Exact, val r: BigDecimal, val m: BigDecimal?) {
    constructor(s: Sphere, w: Exact) :
        this(Exact(s.x, s.y, s.z), Exact(s.vx, s.vy, s.vz), w, BigDecimal(s.r), BigDecimal(s.m))

    val inverseMass: BigDecimal get() = m?.let { BigDecimal.ONE / it } ?: BigDecimal.ZERO

    /** After the [impulse] at a surface whose direction is [to], with the moment of inertia [q] m r². */
    fun pushed(impulse: Exact, to: Exact, q: BigDecimal): ExactSphere {
        if (m == null) return this
        val inertia = q.multiply(m, EXACTLY).multiply(r, EXACTLY).multiply(r, EXACTLY)
        return ExactSphere(at, v + impulse * inverseMass, w + (to * r cross impulse) * (BigDecimal.ONE / inertia), r, m)
    }

    fun angularMomentum(q: BigDecimal): Exact = ((at cross v) + w * q.multiply(r, EXACTLY).multiply(r, EXACTLY)) * m!!

    fun energy(q: BigDecimal): BigDecimal {
        val spinning = q.multiply(r, EXACTLY).multiply(r, EXACTLY).multiply(w * w, EXACTLY)
        return m!!.multiply((v * v).add(spinning, EXACTLY), EXACTLY) / BigDecimal(2)
    }
}

/** The impact of [a] and [b] as the textbook has it, velocities of the surfaces found one by one. */
internal class ExactImpact(val a: ExactSphere, val b: ExactSphere, val normal: Exact, private val q: BigDecimal) {
    private val slip = (b.v - (b.w cross normal * b.r)) - (a.v + (a.w cross normal * a.r))
    val approach: BigDecimal = slip * normal
    val sliding = slip - normal * approach
    val reduced: BigDecimal = BigDecimal.ONE / a.inverseMass.add(b.inverseMass, EXACTLY)

    /** 1/μ + Σ r²/I. */
    private val compliance = (BigDecimal.ONE / reduced).multiply(BigDecimal.ONE.add(BigDecimal.ONE / q), EXACTLY)

    fun normalImpulse(e: Double): BigDecimal =
        reduced.multiply(BigDecimal.ONE.add(BigDecimal(e)), EXACTLY).multiply(approach, EXACTLY)

    /** The impulse on [a] that makes the surfaces slide with −β times the velocity. */
    fun sticking(beta: Double): Exact = sliding * (BigDecimal.ONE.add(BigDecimal(beta)) / compliance)

    /** The same when friction [mu] is all there is. */
    fun slipping(mu: Double, e: Double): Exact =
        sliding * (BigDecimal(mu).multiply(normalImpulse(e).abs(), EXACTLY) / sliding.length)

    fun after(e: Double, tangential: Exact): Pair<ExactSphere, ExactSphere> {
        val impulse = normal * normalImpulse(e) + tangential
        return a.pushed(impulse, normal, q) to b.pushed(impulse * BigDecimal(-1), normal * BigDecimal(-1), q)
    }
}
