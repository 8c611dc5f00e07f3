package daphnis.core.wall

import kotlin.math.abs
import kotlin.math.floor

/**
 * How a wall moves: its displacement along its way as a function of time since time 0. Of a face of the box, the lower
 * or the upper one, positive is towards greater coordinates; of other walls see [Wall]. Amplitudes are lengths,
 * frequencies are cycles per unit of time, and phases are parts of a cycle, at time 0.
 *
 * A motion consists of smooth pieces. Within a step it is followed from the phase at the start, so that time which has
 * long gone on costs no precision.
 */
public sealed class WallMotion {
    /** How far the wall goes at most from the face of the box, to either side; infinite for a steady motion. */
    public abstract val amplitude: Double

    /** Cycles per unit of time; 0 of a motion that does not repeat. */
    public open val frequency: Double get() = 0.0

    /** Whether it is known beyond the present step, and does not depend on what happens in this. */
    internal open val isKnownAhead: Boolean get() = true

    /** Whether there is one smooth piece. */
    internal open val isSmooth: Boolean get() = false

    /** The coefficient with which a sphere of mass [m] leaves a wall that moves so, whose own is [restitution]. */
    internal open fun coefficient(restitution: Double, m: Double): Double = restitution

    /** Displacement at [time]. */
    public fun displacement(time: Double): Double = displacement(phase(time), 0.0)

    /** Velocity along the axis at [time]; where it jumps, that after [time]. */
    public fun velocity(time: Double): Double = velocity(phase(time), 0.0)

    /** What [displacement] and the others need to know about the [time] from which they are counted. */
    internal abstract fun phase(time: Double): Double

    /** Displacement a time [t] after the moment of [phase]; likewise the others. */
    internal abstract fun displacement(phase: Double, t: Double): Double

    internal abstract fun velocity(phase: Double, t: Double): Double

    /** The number of the smooth piece at [t]. */
    internal open fun piece(phase: Double, t: Double): Long = 0

    /** When the piece ends. */
    internal open fun pieceEnd(phase: Double, piece: Long): Double = Double.POSITIVE_INFINITY

    /** Bounds on the acceleration within the piece; where they are the same it is constant. */
    internal open fun leastAcceleration(piece: Long): Double = 0.0

    internal open fun mostAcceleration(piece: Long): Double = 0.0

    /** The greatest acceleration to either side, within all pieces. */
    internal open val strongest: Double get() = 0.0

    /** The lowest displacement from [t] = 0 to [duration]; [highest] likewise. */
    internal open fun lowest(phase: Double, duration: Double): Double = -amplitude

    internal open fun highest(phase: Double, duration: Double): Double = amplitude

    /** Moves at one [velocity] for ever, such as a piston: at time 0 it is at the face of the box. */
    public class Steady(public val velocity: Double) : WallMotion() {
        init {
            require(velocity.isFinite()) { "velocity of a wall is $velocity; it must be finite" }
        }

        override val isSmooth: Boolean get() = true
        override val amplitude: Double get() = if (velocity == 0.0) 0.0 else Double.POSITIVE_INFINITY

        override fun phase(time: Double): Double = velocity * time

        override fun displacement(phase: Double, t: Double): Double = phase + velocity * t

        override fun velocity(phase: Double, t: Double): Double = velocity

        override fun lowest(phase: Double, duration: Double): Double = phase + minOf(velocity * duration, 0.0)

        override fun highest(phase: Double, duration: Double): Double = phase + maxOf(velocity * duration, 0.0)

        override fun toString(): String = "steady $velocity"
    }

    /** A motion that repeats after 1/[frequency]. */
    public sealed class Periodic(
        final override val amplitude: Double,
        final override val frequency: Double,
        public val phase: Double,
    ) : WallMotion() {
        init {
            require(amplitude >= 0 && amplitude.isFinite()) { "amplitude is $amplitude; it must be at least 0" }
            require(frequency > 0 && frequency.isFinite()) { "frequency is $frequency; it must be > 0" }
            require(abs(phase) <= 1) { "phase is $phase; it must be a part of a cycle, from -1 to 1" }
        }

        final override fun phase(time: Double): Double = part(part(frequency * time) + phase)

        /** The cycles that have gone, and the part of the present one. */
        protected fun cycles(phase: Double, t: Double): Double = phase + frequency * t

        protected fun part(cycles: Double): Double = cycles - floor(cycles)
    }

    /** A sin 2π(f t + φ), φ being the [phase]. */
    public class Sine @JvmOverloads constructor(amplitude: Double, frequency: Double, phase: Double = 0.0) :
        Periodic(amplitude, frequency, phase) {
        private val omega = TURN * frequency
        override val isSmooth: Boolean get() = true
        override val strongest: Double = amplitude * omega * omega * (1 + ROUNDING)

        override fun displacement(phase: Double, t: Double): Double =
            amplitude * StrictMath.sin(TURN * part(cycles(phase, t)))

        override fun velocity(phase: Double, t: Double): Double =
            amplitude * omega * StrictMath.cos(TURN * part(cycles(phase, t)))

        override fun leastAcceleration(piece: Long): Double = -strongest

        override fun mostAcceleration(piece: Long): Double = strongest

        override fun toString(): String = "sine, amplitude $amplitude, frequency $frequency, phase $phase"
    }

    /**
     * Goes from −A to A at one speed and back at another: [rise] is the part of a cycle that the way up takes, 0.5 for
     * a triangle. At phase 0 it is at −A.
     */
    public class Sawtooth @JvmOverloads constructor(
        amplitude: Double,
        frequency: Double,
        phase: Double = 0.0,
        public val rise: Double = 0.5,
    ) : Periodic(amplitude, frequency, phase) {
        init {
            require(rise > 0 && rise < 1) { "rise is $rise; it must be a part of a cycle, in (0, 1)" }
        }

        private val up = 2 * amplitude * frequency / rise
        private val down = -2 * amplitude * frequency / (1 - rise)

        override fun piece(phase: Double, t: Double): Long {
            val cycles = cycles(phase, t)
            return 2 * floor(cycles).toLong() + if (part(cycles) < rise) 0 else 1
        }

        override fun pieceEnd(phase: Double, piece: Long): Double =
            ((piece shr 1) + (if (piece and 1L == 0L) rise else 1.0) - phase) / frequency

        override fun displacement(phase: Double, t: Double): Double {
            val p = part(cycles(phase, t))
            return if (p < rise) amplitude * (2 * p / rise - 1) else amplitude * (1 - 2 * (p - rise) / (1 - rise))
        }

        override fun velocity(phase: Double, t: Double): Double = if (part(cycles(phase, t)) < rise) up else down

        override fun toString(): String =
            "sawtooth, amplitude $amplitude, frequency $frequency, phase $phase, rise $rise"
    }

    /** Two parabolas a cycle, of the same acceleration up and down: like a sine of the same amplitude and phase. */
    public class BiParabolic @JvmOverloads constructor(amplitude: Double, frequency: Double, phase: Double = 0.0) :
        Periodic(amplitude, frequency, phase) {
        override val strongest: Double = 32 * amplitude * frequency * frequency

        override fun piece(phase: Double, t: Double): Long = floor(2 * cycles(phase, t)).toLong()

        override fun pieceEnd(phase: Double, piece: Long): Double = (0.5 * (piece + 1) - phase) / frequency

        override fun displacement(phase: Double, t: Double): Double {
            val p = part(cycles(phase, t))
            return if (p < 0.5) 16 * amplitude * p * (0.5 - p) else 16 * amplitude * (0.5 - p) * (1 - p)
        }

        override fun velocity(phase: Double, t: Double): Double {
            val p = part(cycles(phase, t))
            return 8 * amplitude * frequency * (if (p < 0.5) 1 - 4 * p else 4 * p - 3)
        }

        override fun leastAcceleration(piece: Long): Double = if (piece and 1L == 0L) -strongest else strongest

        override fun mostAcceleration(piece: Long): Double = leastAcceleration(piece)

        override fun toString(): String = "bi-parabolic, amplitude $amplitude, frequency $frequency, phase $phase"
    }

    private companion object {
        const val TURN = 2 * Math.PI
        const val ROUNDING = 1e-12
    }
}
