package daphnis.core.collision

/**
 * Ends inelastic collapse by making some collisions elastic. Collapse means infinitely many collisions in finite time,
 * which a constant ε < 1 can lead to. Each collision which the guard makes elastic is counted.
 *
 * The answer must follow from the arguments alone and not depend on which sphere is first: engines may ask several
 * times, from several threads, and in either order.
 */
public interface CollapseGuard {
    /** Whether [makesElastic] uses the times since the last collisions, so that the engine has to keep them. */
    public val needsLastCollision: Boolean

    /**
     * @param impactSpeed normal component of the relative velocity, ≥ 0
     * @param sinceFirst time since the last collision of one sphere, +∞ when it had none; likewise [sinceSecond];
     *   meaningless unless [needsLastCollision]
     */
    public fun makesElastic(impactSpeed: Double, sinceFirst: Double, sinceSecond: Double): Boolean

    public companion object {
        /** [NoGuard], for Java. */
        @JvmStatic
        public fun none(): CollapseGuard = NoGuard
    }
}

/** No guard: right for laws with ε → 1 at low speed, such as Bridges'. */
public object NoGuard : CollapseGuard {
    override val needsLastCollision: Boolean get() = false

    override fun makesElastic(impactSpeed: Double, sinceFirst: Double, sinceSecond: Double): Boolean = false
}

/** ε = 1 below the impact speed [speed]. */
public class FloorSpeedGuard(public val speed: Double) : CollapseGuard {
    init {
        require(speed >= 0 && speed.isFinite()) { "floor speed is $speed; it must be at least 0" }
    }

    override val needsLastCollision: Boolean get() = false

    override fun makesElastic(impactSpeed: Double, sinceFirst: Double, sinceSecond: Double): Boolean =
        impactSpeed < speed
}

/**
 * The TC rule (Luding & McNamara 1998, Granular Matter 1, 113): ε = 1 when either sphere collided less than
 * [contactDuration] ago.
 */
public class ContactDurationGuard(public val contactDuration: Double) : CollapseGuard {
    init {
        require(contactDuration > 0 && contactDuration.isFinite()) {
            "contact duration is $contactDuration; it must be > 0"
        }
    }

    override val needsLastCollision: Boolean get() = true

    override fun makesElastic(impactSpeed: Double, sinceFirst: Double, sinceSecond: Double): Boolean =
        sinceFirst < contactDuration || sinceSecond < contactDuration
}
