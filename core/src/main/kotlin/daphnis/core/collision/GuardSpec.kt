package daphnis.core.collision

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** What ends inelastic collapse, see [CollapseGuard]. */
@Serializable
public sealed interface GuardSpec {
    /** Whether it is settled by the initial state only, see [settled]. */
    public val isOpen: Boolean get() = false

    /** Whether it depends on the times since the last collisions. */
    public val remembers: Boolean get() = false

    /** The impact speed below which it makes collisions elastic, where spheres have the [rms] speed; NaN for other rules. */
    public fun floor(rms: Double): Double

    /** The same for an initial state of so great an [rms] speed, with its values checked. */
    public fun settled(rms: Double, check: ValueCheck): GuardSpec = this

    /** The guard, with its values checked. */
    public fun guard(check: ValueCheck): CollapseGuard

    /** A description for a reader. */
    public fun inWords(say: Quantities): String

    @Serializable
    @SerialName("none")
    @Described("no guard")
    public class None : GuardSpec {
        override fun floor(rms: Double): Double = 0.0

        override fun guard(check: ValueCheck): CollapseGuard = NoGuard

        override fun inWords(say: Quantities): String = "none"
    }

    /**
     * ε = 1 below an impact speed: exactly one of [speed], in units of speed, and [relative], in initial rms speeds.
     */
    @Serializable
    @SerialName("floor-speed")
    @Described("impacts slower than this are elastic; exactly one of its keys")
    public class FloorSpeed @JvmOverloads constructor(
        @Described("a speed")
        public val speed: Double? = null,
        @Described("in initial rms speeds")
        public val relative: Double? = null,
    ) : GuardSpec {
        override val isOpen: Boolean get() = relative != null

        override fun floor(rms: Double): Double = speed ?: (relative?.times(rms) ?: 0.0)

        override fun settled(rms: Double, check: ValueCheck): GuardSpec {
            check.must("guard", (speed == null) != (relative == null)) { "needs exactly one of speed and relative" }
            if (relative == null) return this
            check.atLeast0("guard.relative", relative)
            return FloorSpeed(speed = relative * rms)
        }

        override fun guard(check: ValueCheck): CollapseGuard {
            val speed = speed ?: 0.0
            check.that("guard.speed", speed, speed >= 0 && speed.isFinite()) { "must be at least 0" }
            return FloorSpeedGuard(speed)
        }

        override fun inWords(say: Quantities): String = "elastic below ${say.speed(speed ?: 0.0)}"
    }

    /** The TC rule: ε = 1 within [duration], in units of time, of a sphere's last collision. */
    @Serializable
    @SerialName("contact-duration")
    @Described("the TC rule: elastic if either sphere collided less than this time ago")
    public class ContactDuration(
        @Described("in units of time")
        public val duration: Double,
    ) : GuardSpec {
        override val remembers: Boolean get() = true

        override fun floor(rms: Double): Double = Double.NaN

        override fun guard(check: ValueCheck): CollapseGuard {
            check.positive("guard.duration", duration)
            return ContactDurationGuard(duration)
        }

        override fun inWords(say: Quantities): String = "elastic within ${say.time(duration)} of the last collision"
    }
}
