package daphnis.core.wall

import daphnis.core.collision.NEVER
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A wall that moves within a step, as spheres see it whose paths are straight.
 *
 * **Gravity.** A uniform acceleration g acts as half a kick before the drift and half a kick after it. The path of the
 * drift is the chord X(t) = x₀ + (v₀ + ½ g τ) t of a step of length τ, and the true one is X(t) − ½ g t (τ − t). So
 * spheres which keep to their chords meet a wall at w that stands at w + ½ g t (τ − t), at the same time and with the
 * same velocity relative to it as on their parabolas. Pairs fall alike, so that nothing changes for them.
 *
 * **First contact.** With the gap c at some moment, its rate b and a lower bound a of its second derivative, the gap is
 * nowhere below c + b s + ½ a s² after a time s. So there is no contact before that parabola meets zero. Where the
 * acceleration is constant that is the contact. Elsewhere the search goes on from there, and comes nearer from one
 * side, twice as many digits at a time: it passes over no contact, however often the wall comes and goes.
 *
 * Everything is a pure function of the sphere's row and the step.
 */
internal class MovingFace(private val isLower: Boolean, private val motion: WallMotion?, private val gravity: Double) {
    /** 1 where the room is above the wall, −1 where it is below. */
    private val inward = if (isLower) 1.0 else -1.0
    private var place = 0.0
    private var duration = 0.0
    private var phase = 0.0

    /** Of its cycles; 0 when it has none. */
    private val frequency = motion?.frequency ?: 0.0

    /** The least time by which a search goes on, and another by which it tries to be in the next piece. */
    private var grain = 0.0
    private var grainOfPieces = 0.0

    /** A time that is short for the step and for the motion, see [rebound]. */
    private var moment = 0.0

    /** The strongest acceleration towards the wall, relative to it, in any step; 0 when there is none. */
    val press: Double = maxOf(0.0, (motion?.strongest ?: 0.0) - inward * gravity)

    /** A step of [duration] begins at [start]; without motion and gravity the wall is at [place]. */
    fun begin(place: Double, start: Double, duration: Double) {
        this.place = place
        this.duration = duration
        phase = motion?.phase(start) ?: 0.0
        moment = momentOf(motion, duration)
        grain = duration * GRAIN
        grainOfPieces = grain + (if (frequency == 0.0) 0.0 else GRAIN / frequency)
    }

    /** Velocity of the wall at [t] as spheres on chords see it. */
    fun velocity(t: Double): Double =
        (if (motion == null) 0.0 else motion.velocity(phase, t)) + 0.5 * gravity * (duration - 2 * t)

    private fun position(t: Double): Double =
        place + ((if (motion == null) 0.0 else motion.displacement(phase, t)) + 0.5 * gravity * t * (duration - t))

    /**
     * How far into the room the wall comes as spheres on chords see it, at any time in steps that cover the time [span]
     * from the start of this one.
     */
    fun innermost(span: Double): Double {
        val bow = 0.125 * gravity * duration * duration
        return if (isLower) {
            place + (motion?.highest(phase, span) ?: 0.0) + maxOf(bow, 0.0)
        } else {
            place + (motion?.lowest(phase, span) ?: 0.0) + minOf(bow, 0.0)
        }
    }

    /**
     * When a sphere of radius [r] that is at [x] at the time [from], with the velocity [v] along the axis, first
     * touches the wall while coming nearer; [NEVER] when it does not in this step.
     */
    fun contact(x: Double, v: Double, r: Double, from: Double): Double {
        var t = from
        if (frequency > 0.0) {
            val away = inward * (x - innermost(duration)) - r
            if (away > 0.0) {
                val nearing = -inward * v
                if (nearing <= 0.0) return NEVER
                t += away / nearing * ALMOST
                if (t > duration) return NEVER
            }
        }
        if (motion == null) return alongPiece(x, v, r, from, t, NEVER, inward * gravity, isExact = true)
        var piece = motion.piece(phase, t)
        while (true) {
            val end = motion.pieceEnd(phase, piece)
            val least = motion.leastAcceleration(piece)
            val most = motion.mostAcceleration(piece)
            val bending = if (isLower) gravity - most else least - gravity
            val touch = alongPiece(x, v, r, from, t, end, bending, least == most)
            if (touch <= duration && touch < end) return touch
            if (end >= duration) return NEVER
            piece++
            t = maxOf(t, end)
            while (motion.piece(phase, t) < piece) t += grainOfPieces
        }
    }

    /**
     * The contact from the time [start] on in a piece of the motion that lasts until [end]; later than that, or
     * [NEVER], when there is none in it. [bending] is the least second derivative of the gap.
     */
    private fun alongPiece(
        x: Double,
        v: Double,
        r: Double,
        from: Double,
        start: Double,
        end: Double,
        bending: Double,
        isExact: Boolean,
    ): Double {
        var t = start
        while (true) {
            val gap = inward * (x + v * (t - from) - position(t)) - r
            val rate = inward * (v - velocity(t))
            val wait = waitForGap(gap, rate, bending, isExact)
            if (wait == 0.0) return t
            val next = t + wait
            if (isExact || next > duration || next >= end) return next
            t = maxOf(next, t + grain)
        }
    }

    /** The speed at which a sphere at [t] with the velocity [v] along the axis comes nearer; below 0 when it leaves. */
    fun approach(v: Double, t: Double): Double = -inward * (v - velocity(t))

    /** The velocity of a sphere that leaves the wall with [speed], relative to it, at [t]. */
    fun leaving(speed: Double, t: Double): Double = velocity(t) + inward * speed + 0.0

    /**
     * The speed of a sphere of radius [r] that leaves at [t], where the law of the wall says [speed], unless it would
     * be back so soon that bounces on the way to rest have no end: see docs/physics.md. Long steps add nothing: the
     * time to be back is short for the cycle of the wall too, and for the height of a radius.
     *
     * @param restitution of the wall: 1 for elastic bounces
     */
    fun rebound(speed: Double, restitution: Double, r: Double, t: Double): Double {
        if (press == 0.0) return speed
        val gain = minOf(press * moment, sqrt(press * r))
        return apart(maxOf(speed, (if (restitution == 1.0) LEAST_ELASTIC else LEAST_INELASTIC) * gain), t)
    }

    /** [speed], or the least that can be told from the velocity of the wall at [t]. */
    fun apart(speed: Double, t: Double): Double = maxOf(speed, VELOCITY_ROUNDING * abs(velocity(t)))

    companion object {
        private const val GRAIN = 1e-15
        private const val ALMOST = 1 - 1e-12

        /** A time that is short for a step of [duration] and for the cycle of [motion]. */
        fun momentOf(motion: WallMotion?, duration: Double): Double = if (motion == null ||
            motion.frequency == 0.0
        ) {
            duration
        } else {
            minOf(duration, PART_OF_CYCLE / motion.frequency)
        }

        /** That speeds which follow from it are small for those of the wall. */
        private const val PART_OF_CYCLE = 1.0 / 64

        /** Relative to the change of speed in that time, by the acceleration towards the wall. */
        const val LEAST_INELASTIC = 1.0 / 16
        private const val LEAST_ELASTIC = 1e-3
        private const val VELOCITY_ROUNDING = 1e-15
    }
}

/**
 * How long a gap stays open, or grows, at least: it is [gap] now and changes with [rate], and its second derivative is
 * [bending] or more; exactly that where [isExact]. 0 where it is closed and would be negative, [NEVER] where it stays
 * open for good. See [MovingFace].
 */
internal fun waitForGap(gap: Double, rate: Double, bending: Double, isExact: Boolean): Double {
    if (gap <= 0.0) {
        if (rate < 0.0) return 0.0
        if (bending >= 0.0) return NEVER
        // It touches, or overlaps by rounding, and leaves.
        if (!isExact) return rate / -bending
        return (rate + sqrt(maxOf(rate * rate - 2 * bending * gap, 0.0))) / -bending
    }
    if (bending >= 0.0 && rate >= 0.0) return NEVER
    val square = rate * rate - 2 * bending * gap
    if (square < 0.0) return NEVER
    val root = sqrt(square)
    return if (rate <= 0.0) 2 * gap / (root - rate) else (rate + root) / -bending
}
