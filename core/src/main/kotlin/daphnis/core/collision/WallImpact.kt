package daphnis.core.collision

/** An impact of a sphere on a wall, as the wall describes it to what acts there. Reused for every impact of a worker. */
public class WallImpact internal constructor() {
    /** The time of the impact, from the start of the step. */
    public var time: Double = 0.0

    /** The normal of the wall, into the room; of length 1 for those who exchange anything along the wall. */
    public var nx: Double = 0.0
    public var ny: Double = 0.0
    public var nz: Double = 0.0

    /** Velocity of the wall at the place of the impact, along itself or not. */
    public var sx: Double = 0.0
    public var sy: Double = 0.0
    public var sz: Double = 0.0

    /** Speed at which the sphere comes nearer. */
    public var speed: Double = 0.0

    /** Coefficient of restitution. */
    public var coefficient: Double = 1.0

    /** Length of the normal as the wall gives it, and what of that is along an axis across which the rest is. */
    public var length: Double = 1.0
    public var lean: Double = 0.0

    /** Product of that normal with the velocity relative to the wall. */
    public var rate: Double = 0.0

    /** Acceleration that presses the sphere to the wall. */
    public var press: Double = 0.0

    /** Sets the normal. */
    public fun normal(x: Double, y: Double, z: Double) {
        nx = x
        ny = y
        nz = z
    }

    /** Sets the velocity of the wall. */
    public fun surface(x: Double, y: Double, z: Double) {
        sx = x
        sy = y
        sz = z
    }
}
