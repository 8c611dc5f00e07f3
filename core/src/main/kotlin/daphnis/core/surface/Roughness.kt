package daphnis.core.surface

/**
 * The coefficient of tangential restitution β of rough spheres: an impact turns the tangential velocity **g** of the
 * surfaces at the point of contact into −β **g**. −1 is smooth, 0 ends sliding, 1 reverses it and loses no energy.
 *
 * Must be a pure function that gives the same bits on every machine: use [StrictMath] for `pow`, `exp`, `sin`. It is not
 * asked where surfaces do not slide.
 */
public fun interface Roughness {
    /** @return β in [−1, 1]; any other number ends the step with an [IllegalArgumentException] */
    public fun coefficient(contact: SurfaceContact): Double

    /** 1 + β, for a law that knows it better than as that sum: near −1 it would lose digits. */
    public fun change(contact: SurfaceContact): Double = 1.0 + coefficient(contact)
}

/** β = [value] in every impact. */
public class ConstantRoughness(public val value: Double) : Roughness {
    init {
        require(value in -1.0..1.0) { "coefficient of tangential restitution is $value; it must be in [-1, 1]" }
    }

    override fun coefficient(contact: SurfaceContact): Double = value
}

/**
 * Walton's law: surfaces stick, with β = [sticking], unless Coulomb friction is too weak for that. Then they slide, and
 * the tangential impulse is [friction] times the normal one (Walton & Braun 1986, J. Rheol. 30, 949; Walton 1993).
 *
 * @property friction μ ≥ 0
 * @property sticking β₀ in [−1, 1]
 */
public class CoulombRoughness(public val friction: Double, public val sticking: Double) : Roughness {
    init {
        require(friction >= 0 && friction.isFinite()) { "friction is $friction; it must be at least 0" }
        require(sticking in -1.0..1.0) { "coefficient of sticking contacts is $sticking; it must be in [-1, 1]" }
    }

    override fun coefficient(contact: SurfaceContact): Double = change(contact) - 1.0

    override fun change(contact: SurfaceContact): Double {
        val q = contact.momentFactor
        val most = friction * ((1.0 + contact.restitution) * contact.normalSpeed) * ((1.0 + q) / q)
        val needed = (1.0 + sticking) * contact.tangentialSpeed
        return if (needed <= most) 1.0 + sticking else most / contact.tangentialSpeed
    }
}
