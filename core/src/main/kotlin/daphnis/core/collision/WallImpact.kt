package daphnis.core.collision

/** An impact of a sphere on a wall, as the wall describes it to what acts there. Reused for every impact of a worker. */
internal class WallImpact {
    /** The time of the impact, from the start of the step. */
    var time = 0.0

    /** The normal of the wall, into the room; of length 1 for those who exchange anything along the wall. */
    var nx = 0.0
    var ny = 0.0
    var nz = 0.0

    /** Velocity of the wall at the place of the impact, along itself or not. */
    var sx = 0.0
    var sy = 0.0
    var sz = 0.0

    /** Speed at which the sphere comes nearer. */
    var speed = 0.0

    /** Coefficient of restitution. */
    var coefficient = 1.0

    /** Length of the normal as the wall gives it, and what of that is along an axis across which the rest is. */
    var length = 1.0
    var lean = 0.0

    /** Product of that normal with the velocity relative to the wall. */
    var rate = 0.0

    /** Acceleration that presses the sphere to the wall. */
    var press = 0.0

    fun normal(x: Double, y: Double, z: Double) {
        nx = x
        ny = y
        nz = z
    }

    fun surface(x: Double, y: Double, z: Double) {
        sx = x
        sy = y
        sz = z
    }
}
