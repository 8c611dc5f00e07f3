@file:JvmName("SiSnapshots")

package daphnis.core.format

import daphnis.core.input.SiUnits
import daphnis.core.population.SphereQuantity

/** [snapshot] with every number in SI units. */
public fun SiUnits.convert(snapshot: Snapshot): Snapshot {
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
