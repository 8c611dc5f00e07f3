package daphnis.core.surface

/**
 * An impact as a [ContactLaw] or a law of [Roughness] sees it, valid during the call. The first sphere is the one with
 * the lower id. Of a wall, radius and mass are infinite.
 */
public class SurfaceContact internal constructor() {
    /** Normal component of the relative velocity before the impact, ≥ 0. */
    public var normalSpeed: Double = 0.0
        internal set

    /**
     * Speed with which the surfaces slide on one another before the impact, ≥ 0; > 0 where β is asked for. Spins are
     * part of it where spheres have them.
     */
    public var tangentialSpeed: Double = 0.0
        internal set

    /** Coefficient of normal restitution of this impact, 1 where a guard has made it elastic; NaN before it is known. */
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

    /** Number of the material of the first sphere, 0 where spheres have no materials. */
    public var firstMaterial: Int = 0
        internal set

    /** As [firstMaterial], of the second sphere; −1 of a wall. */
    public var secondMaterial: Int = 0
        internal set

    /** Effective radius r₁ r₂/(r₁ + r₂), which the theory of contacts knows: half the radius of equal spheres. */
    public val effectiveRadius: Double
        get() = reduced(firstRadius, secondRadius)

    /** Reduced mass m₁ m₂/(m₁ + m₂): half the mass of equal spheres. */
    public val reducedMass: Double
        get() = reduced(firstMass, secondMass)

    private fun reduced(first: Double, second: Double) =
        if (second == Double.POSITIVE_INFINITY) first else first * second / (first + second)

    public companion object {
        /** [momentFactor] of a homogeneous sphere. */
        public const val SOLID: Double = 0.4

        /** Two equal spheres that meet head-on with [speed], to ask a law what it says of them. */
        @JvmStatic
        @JvmOverloads
        public fun headOn(speed: Double, radius: Double, mass: Double, material: Int = 0): SurfaceContact =
            SurfaceContact().apply {
                normalSpeed = speed
                restitution = Double.NaN
                firstRadius = radius
                secondRadius = radius
                firstMass = mass
                secondMass = mass
                firstMaterial = material
                secondMaterial = material
            }
    }
}
