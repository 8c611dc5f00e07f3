package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.wall.WallMotion
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction

/** How a wall moves along the axis across it, see [WallMotion]; toward greater coordinates is positive. */
@Serializable
public sealed interface WallMotionSpec {
    /** Whether the wall ever moves. */
    public val moves: Boolean

    /** Whether its velocity never jumps, and no impacts push it. */
    public val isSmooth: Boolean get() = false

    /** Cycles per unit of time; null for what has none. */
    public val frequency: Double? get() = null

    /** Position and velocity with which a wall begins that impacts push; null for one that moves as told. */
    public val begin: List<Double>? get() = null

    /** Whether impacts push the wall. */
    public val isFree: Boolean get() = begin != null

    /** The motion of what stands at [key], with its values checked. */
    public fun motion(key: String, check: ValueCheck): WallMotion

    /** The same where it has moved on as [begin] says. */
    public fun beginningWith(begin: List<Double>): WallMotionSpec = this

    /** A description for a reader: [number] writes numbers. */
    public fun inWords(number: DoubleFunction<String>): String

    /** At one speed: at time 0 at the face of the box. */
    @Serializable
    @SerialName("steady")
    @Described("displacement v t from the face of the box at time t")
    public class Steady(
        @Described("v, positive towards greater coordinates")
        public val velocity: Double,
    ) : WallMotionSpec {
        override val moves: Boolean get() = velocity != 0.0
        override val isSmooth: Boolean get() = true

        override fun motion(key: String, check: ValueCheck): WallMotion {
            check.speed("$key.velocity", velocity)
            return WallMotion.Steady(velocity)
        }

        override fun inWords(number: DoubleFunction<String>): String = "moves with ${number.apply(velocity)}"
    }

    /**
     * A wall with a mass, see [daphnis.core.wall.Piston].
     *
     * @property mass its mass
     * @property force along the axis
     * @property position displacement from the face of the box at the start
     * @property velocity at the start
     */
    @Serializable
    @SerialName("piston")
    @Described("that of a free body: the force and the impacts of spheres move it")
    public class Piston @JvmOverloads constructor(
        @Described("at least ten times that of a sphere")
        public val mass: Double,
        @Described("its weight included, positive towards greater coordinates; default 0")
        public val force: Double = 0.0,
        @Described("displacement at the start; default 0")
        public val position: Double = 0.0,
        @Described("at the start; default 0")
        public val velocity: Double = 0.0,
    ) : WallMotionSpec {
        override val moves: Boolean get() = true
        override val begin: List<Double> get() = listOf(position, velocity)

        override fun motion(key: String, check: ValueCheck): WallMotion {
            check.positive("$key.mass", mass)
            check.that("$key.force", force, force.isFinite()) { "must be finite" }
            check.that("$key.position", position, position.isFinite()) { "must be finite" }
            check.speed("$key.velocity", velocity)
            return daphnis.core.wall.Piston(mass, force, position, velocity)
        }

        override fun beginningWith(begin: List<Double>): WallMotionSpec = Piston(mass, force, begin[0], begin[1])

        override fun inWords(number: DoubleFunction<String>): String =
            "piston of mass ${number.apply(mass)} under the force ${number.apply(force)}"
    }

    /** @property phase part of a cycle, at time 0 */
    @Serializable
    @SerialName("sine")
    @Described("displacement A sin 2π(f t + φ)")
    public class Sine @JvmOverloads constructor(
        @Described("A, a length")
        public val amplitude: Double,
        @Described("f, cycles per unit of time")
        override val frequency: Double,
        @Described("φ, part of a cycle; default 0")
        public val phase: Double = 0.0,
    ) : WallMotionSpec {
        override val isSmooth: Boolean get() = true
        override val moves: Boolean get() = amplitude != 0.0

        override fun motion(key: String, check: ValueCheck): WallMotion {
            checkCycle(key, amplitude, frequency, phase, check)
            return WallMotion.Sine(amplitude, frequency, phase)
        }

        override fun inWords(number: DoubleFunction<String>): String =
            "sine of amplitude ${number.apply(amplitude)}, frequency ${number.apply(frequency)}"
    }

    /** @property rise part of a cycle that the way up takes */
    @Serializable
    @SerialName("sawtooth")
    @Described(
        "displacement from −A to A in the part `rise` of a cycle, and back in the rest; at −A where f t + φ is " +
            "whole",
    )
    public class Sawtooth @JvmOverloads constructor(
        @Described("A, a length")
        public val amplitude: Double,
        @Described("f, cycles per unit of time")
        override val frequency: Double,
        @Described("φ, part of a cycle; default 0")
        public val phase: Double = 0.0,
        @Described("part of a cycle in which it rises; default 0.5")
        public val rise: Double = 0.5,
    ) : WallMotionSpec {
        override val moves: Boolean get() = amplitude != 0.0

        override fun motion(key: String, check: ValueCheck): WallMotion {
            checkCycle(key, amplitude, frequency, phase, check)
            check.that("$key.rise", rise, rise > 0 && rise < 1) { "must be a part of a cycle, in (0, 1)" }
            return WallMotion.Sawtooth(amplitude, frequency, phase, rise)
        }

        override fun inWords(number: DoubleFunction<String>): String =
            "sawtooth of amplitude ${number.apply(amplitude)}, frequency ${number.apply(frequency)}, " +
                "of which it rises ${number.apply(rise)}"
    }

    @Serializable
    @SerialName("bi-parabolic")
    @Described("two parabolas a cycle, like a sine, with accelerations ±32 A f²")
    public class BiParabolic @JvmOverloads constructor(
        @Described("A, a length")
        public val amplitude: Double,
        @Described("f, cycles per unit of time")
        override val frequency: Double,
        @Described("φ, part of a cycle; default 0")
        public val phase: Double = 0.0,
    ) : WallMotionSpec {
        override val moves: Boolean get() = amplitude != 0.0

        override fun motion(key: String, check: ValueCheck): WallMotion {
            checkCycle(key, amplitude, frequency, phase, check)
            return WallMotion.BiParabolic(amplitude, frequency, phase)
        }

        override fun inWords(number: DoubleFunction<String>): String =
            "bi-parabolic of amplitude ${number.apply(amplitude)}, frequency ${number.apply(frequency)}"
    }
}

private fun checkCycle(key: String, amplitude: Double, frequency: Double, phase: Double, check: ValueCheck) {
    check.that("$key.amplitude", amplitude, amplitude >= 0 && amplitude.isFinite()) { "must be at least 0" }
    check.positive("$key.frequency", frequency)
    check.that("$key.phase", phase, phase in -1.0..1.0) { "must be a part of a cycle, in [-1, 1]" }
    check.speed("$key.frequency", 2 * Math.PI * frequency * amplitude)
}
