package daphnis.core.format

/**
 * The units of a scenario in SI units.
 *
 * @property metres in one unit of length
 * @property seconds in one unit of time
 * @property kilograms in one unit of mass
 */
public class SiUnits(public val metres: Double, public val seconds: Double, public val kilograms: Double) {
    /** [snapshot] with every number in SI units. */
    public fun convert(snapshot: Snapshot): Snapshot {
        fun times(factor: Double, a: DoubleArray) = DoubleArray(a.size) { a[it] * factor }
        val speed = metres / seconds
        return Snapshot(
            snapshot.step, snapshot.time * seconds,
            times(metres, snapshot.lengths), snapshot.periodic, snapshot.shearOffset * metres, snapshot.id,
            Array(3) { times(metres, snapshot.position[it]) }, Array(3) { times(speed, snapshot.velocity[it]) },
            times(metres, snapshot.radius), times(kilograms, snapshot.mass),
            snapshot.normalAxis, snapshot.slideAxis, snapshot.hasMass, snapshot.hasRadius, snapshot.image,
            snapshot.hasTime, times(metres, snapshot.shift), snapshot.hasVelocity,
        )
    }
}
