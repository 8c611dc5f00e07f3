package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import kotlin.math.sqrt

/** The number of the sphere at index [k] that [MovieColour] asks for; 0 for the density, which is that of a place. */
internal fun State.quantity(colour: MovieColour, k: Int): Double = when (colour) {
    MovieColour.SPEED -> {
        val x = againstFlow(k, 0)
        val y = againstFlow(k, 1)
        val z = againstFlow(k, 2)
        sqrt(x * x + y * y + z * z)
    }
    MovieColour.SPIN -> population.let {
        if (it.hasSpin) sqrt(it.wx[k] * it.wx[k] + it.wy[k] * it.wy[k] + it.wz[k] * it.wz[k]) else 0.0
    }
    MovieColour.SIZE -> population.radius[k]
    MovieColour.HEIGHT -> population.z[k]
    MovieColour.MATERIAL -> if (population.hasMaterials) population.material[k] else 0.0
    MovieColour.DENSITY -> 0.0
}

/** The number below which the part [q] of [values] lies; NaN of none. Sorts them. */
internal fun quantile(values: DoubleArray, q: Double): Double {
    if (values.isEmpty()) return Double.NaN
    values.sort()
    return values[(q * (values.size - 1)).toInt()]
}
