package daphnis.core.surface

/**
 * An impact as a law of [Roughness] sees it, valid during the call. The first sphere is the one with the lower id. Of a
 * wall, radius and mass are infinite.
 */
public class SurfaceContact internal constructor() {
    /** Normal component of the relative velocity before the impact, ≥ 0. */
    public var normalSpeed: Double = 0.0
        internal set

    /** Speed with which the surfaces slide on one another before the impact, > 0. */
    public var tangentialSpeed: Double = 0.0
        internal set

    /** Coefficient of normal restitution of this impact, 1 where a guard has made it elastic. */
    public var restitution: Double = 1.0
        internal set

    /** Moment of inertia over mass · radius², of every sphere: 2/5 for solid ones. */
    public var momentFactor: Double = SOLID
        internal set
    public var firstRadius: Double = 0.0
        internal set
    public var secondRadius: Double = 0.0
        internal set
    public var firstMass: Double = 0.0
        internal set
    public var secondMass: Double = 0.0
        internal set

    public companion object {
        /** [momentFactor] of a homogeneous sphere. */
        public const val SOLID: Double = 0.4
    }
}
