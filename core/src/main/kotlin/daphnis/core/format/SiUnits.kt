package daphnis.core.format

import daphnis.core.population.SphereQuantity

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
        return snapshot.with(
            time = snapshot.time * seconds,
            lengths = times(metres, snapshot.lengths),
            shearOffset = snapshot.shearOffset * metres,
            shift = times(metres, snapshot.shift),
            numbers = SphereQuantity.EXPORTED.flatMap { quantity ->
                snapshot.columns(quantity).map { times(quantity.dimension.of(metres, seconds, kilograms), it) }
            }.toTypedArray(),
        )
    }
}
