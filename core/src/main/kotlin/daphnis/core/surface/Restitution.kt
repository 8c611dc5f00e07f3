package daphnis.core.surface

import kotlin.math.sqrt

/**
 * The coefficient of restitution ε as a function of the impact speed: the law of smooth spheres that depends on nothing
 * else. Rough ones have a [daphnis.core.surface.Roughness] beside it.
 *
 * Must be a pure function that gives the same bits on every machine: use [StrictMath] for `pow`, `exp`, `sin`.
 */
public fun interface Restitution : ContactLaw {
    /**
     * @param impactSpeed normal component of the relative velocity at contact, ≥ 0, in the scenario's unit of speed
     * @return ε in [0, 1]; any other number ends the step with an [IllegalArgumentException]
     */
    public fun coefficient(impactSpeed: Double): Double

    override val isRough: Boolean get() = false

    override fun restitution(contact: SurfaceContact): Double = coefficient(contact.normalSpeed)
}

/** ε = [value] at every impact speed. */
public class ConstantRestitution(public val value: Double) : Restitution {
    init {
        require(value in 0.0..1.0) { "coefficient of restitution is $value; it must be in [0, 1]" }
    }

    override fun coefficient(impactSpeed: Double): Double = value
}

/**
 * Power law measured on ice: ε(v) = min(1, [prefactor] · v^[exponent]), v in cm/s (Bridges, Hatzes & Lin 1984, Nature
 * 309, 333).
 *
 * @property cmPerSecond how many cm/s one unit of speed of the scenario is
 */
public class BridgesRestitution @JvmOverloads constructor(
    public val prefactor: Double = LEWIS_PREFACTOR,
    public val exponent: Double = EXPONENT,
    public val cmPerSecond: Double = 1.0,
) : Restitution {
    init {
        require(prefactor > 0 && prefactor.isFinite()) { "Bridges prefactor is $prefactor; it must be > 0" }
        require(exponent <= 0 && exponent.isFinite()) { "Bridges exponent is $exponent; it must be <= 0" }
        require(cmPerSecond > 0 && cmPerSecond.isFinite()) { "one unit of speed is $cmPerSecond cm/s; it must be > 0" }
    }

    /** At and below this speed ε = 1; this saves the power and keeps ε(0) = 1. */
    private val elasticBelow = if (exponent == 0.0) 0.0 else StrictMath.pow(1 / prefactor, 1 / exponent)

    override fun coefficient(impactSpeed: Double): Double {
        val v = impactSpeed * cmPerSecond
        return if (v <= elasticBelow) 1.0 else minOf(1.0, prefactor * StrictMath.pow(v, exponent))
    }

    public companion object {
        /** The form in Lewis's code and in Wisdom & Tremaine 1988 (AJ 95, 925). */
        public const val LEWIS_PREFACTOR: Double = 0.34

        /** The fit of 1984, used by REBOUND. */
        public const val BRIDGES_1984_PREFACTOR: Double = 0.32

        public const val EXPONENT: Double = -0.234
    }
}

/**
 * Borderies, Goldreich & Tremaine 1984 (in *Planetary Rings*, p. 713), from a plastic-flow model:
 * with x = (v*​/v)², ε = √(−⅔x + √(10x/3 − 5x²/9)); ε = 1 for v ≤ v*.
 *
 * @property criticalSpeed v* in cm/s
 * @property cmPerSecond how many cm/s one unit of speed of the scenario is
 */
public class BorderiesRestitution @JvmOverloads constructor(
    public val criticalSpeed: Double,
    public val cmPerSecond: Double = 1.0,
) : Restitution {
    init {
        require(criticalSpeed > 0 && criticalSpeed.isFinite()) {
            "critical speed is $criticalSpeed cm/s; it must be > 0"
        }
        require(cmPerSecond > 0 && cmPerSecond.isFinite()) { "one unit of speed is $cmPerSecond cm/s; it must be > 0" }
    }

    override fun coefficient(impactSpeed: Double): Double {
        val v = impactSpeed * cmPerSecond
        if (v <= criticalSpeed) return 1.0
        val ratio = criticalSpeed / v
        val x = ratio * ratio
        return minOf(1.0, sqrt(maxOf(0.0, -2.0 / 3.0 * x + sqrt(10.0 / 3.0 * x - 5.0 / 9.0 * x * x))))
    }
}

/**
 * ε = [below] at impact speeds below [speed], elastic unless given, and [coefficient] from there on.
 *
 * @property speed in cm/s
 * @property cmPerSecond how many cm/s one unit of speed of the scenario is
 */
public class StepRestitution @JvmOverloads constructor(
    public val speed: Double,
    public val coefficient: Double,
    public val below: Double = 1.0,
    public val cmPerSecond: Double = 1.0,
) : Restitution {
    init {
        require(speed > 0 && speed.isFinite()) { "the speed of the step is $speed cm/s; it must be > 0" }
        require(coefficient in 0.0..1.0) { "coefficient of restitution is $coefficient; it must be in [0, 1]" }
        require(below in 0.0..1.0) { "coefficient of restitution below the step is $below; it must be in [0, 1]" }
        require(cmPerSecond > 0 && cmPerSecond.isFinite()) { "one unit of speed is $cmPerSecond cm/s; it must be > 0" }
    }

    override fun coefficient(impactSpeed: Double): Double =
        if (impactSpeed * cmPerSecond < speed) below else coefficient
}
