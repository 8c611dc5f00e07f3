@file:JvmName("Finite")

package daphnis.core.population

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import java.util.concurrent.atomic.AtomicBoolean

/**
 * A number that is infinite or NaN, such as "vx of particle 3 is NaN": that of the lowest id in the first column with
 * any. Null when there is none. Looks at positions, velocities, radii and masses, and at spins where there are any. One
 * sum over everything, which is not 0 as soon as one number is not finite: cheap compared with a step.
 */
@JvmOverloads
public fun SphereColumns.firstNotFinite(loop: RangeLoop = InlineLoop): String? {
    val suspect = AtomicBoolean()
    loop.runLight(size) { _, from, to -> if (!isFinite(from, to)) suspect.set(true) }
    return if (suspect.get()) nameNotFinite() else null
}

/** Whether all numbers of the spheres [from] until [to] are finite. */
internal fun SphereColumns.isFinite(from: Int, to: Int): Boolean {
    val x = x
    val y = y
    val z = z
    val vx = vx
    val vy = vy
    val vz = vz
    val radius = radius
    val mass = mass
    var sum = 0.0
    for (k in from until to) {
        // Nothing here depends on the sphere before but for one addition.
        val place = x[k] * 0.0 + y[k] * 0.0 + z[k] * 0.0
        val velocity = vx[k] * 0.0 + vy[k] * 0.0 + vz[k] * 0.0
        sum += place + velocity + (radius[k] * 0.0 + mass[k] * 0.0)
    }
    for (place in OTHERS) {
        val column = column(place)
        if (column === SphereQuantity.NONE) continue
        for (k in from until to) sum += column[k] * 0.0
    }
    return sum == 0.0
}

/** What [firstNotFinite] says. */
internal fun SphereColumns.nameNotFinite(): String? {
    for (quantity in SphereQuantity.EXPORTED) {
        for ((c, name) in quantity.columns.withIndex()) {
            val column = column(quantity.place + c)
            if (column === SphereQuantity.NONE) continue
            // The lowest id: the order of the arrays is up to the engine.
            var first = -1
            for (k in 0 until size) if (!column[k].isFinite() && (first < 0 || id[k] < id[first])) first = k
            if (first >= 0) return "$name of particle ${id[first]} is ${column[first]}"
        }
    }
    return null
}

/** Places of the columns that the one sum over all spheres does not have. */
private val OTHERS = SphereQuantity.places {
    it.isExported &&
        it !in setOf(
            SphereQuantity.POSITION,
            SphereQuantity.VELOCITY,
            SphereQuantity.RADIUS,
            SphereQuantity.MASS,
        )
}
