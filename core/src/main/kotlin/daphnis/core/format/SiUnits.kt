package daphnis.core.format

/**
 * What one unit of a scenario is in SI units.
 *
 * @property metres in one unit of length
 * @property seconds in one unit of time
 * @property kilograms in one unit of mass
 */
public class SiUnits(public val metres: Double, public val seconds: Double, public val kilograms: Double) {
    /** [frame] with every number in SI units. */
    public fun convert(frame: Snapshot): Snapshot {
        fun times(factor: Double, a: DoubleArray) = DoubleArray(a.size) { a[it] * factor }
        val speed = metres / seconds
        return Snapshot(
            frame.step, frame.time * seconds,
            times(
                metres,
                frame.lengths,
            ),
            frame.periodic, frame.shearOffset * metres, frame.id,
            Array(3) { times(metres, frame.position[it]) }, Array(3) { times(speed, frame.velocity[it]) },
            times(
                metres,
                frame.radius,
            ),
            times(
                kilograms,
                frame.mass,
            ),
            frame.normalAxis, frame.slideAxis, frame.hasMass, frame.hasRadius, frame.image,
        )
    }
}
