package daphnis.analysis.occultation

import daphnis.analysis.insitu.State
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.space.Images
import kotlin.math.cos
import kotlin.math.sin

/** Whether the ray through (x, y, 0) comes nearer to a sphere or image than its radius, by a search of all of them. */
internal fun isBlocked(
    state: State,
    images: Images,
    x: Double,
    y: Double,
    elevation: Double,
    azimuth: Double,
): Boolean {
    val p = state.population
    val ray = doubleArrayOf(cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth), sin(elevation))
    val open = state.boundary.contactFaces(0) != ContactFaces.PERIODIC
    for (k in 0 until p.size) {
        for (ix in if (open) 0..0 else -6..6) {
            for (iy in -10..10) {
                val code = Images.code(ix, iy, 0)
                val d = doubleArrayOf(p.x[k] + images.shift(code, 0) - x, p.y[k] + images.shift(code, 1) - y, p.z[k])
                val along = (0..2).sumOf { d[it] * ray[it] }
                if ((0..2).sumOf { d[it] * d[it] } - along * along < p.radius[k] * p.radius[k]) return true
            }
        }
    }
    return false
}

/** Spheres with centres and radii as given, at rest. */
internal fun spheres(
    x: DoubleArray,
    y: DoubleArray,
    z: DoubleArray,
    radius: DoubleArray,
    boundary: BoundaryConditions,
    time: Double = 0.0,
): State {
    fun zero() = DoubleArray(x.size)
    return State(Population(x, y, z, zero(), zero(), zero(), radius, DoubleArray(x.size) { 1.0 }), boundary, time)
}

/** [count] spheres of [radius] that may overlap, uniform in the box, which [random] draws. */
internal fun overlapping(
    count: Int,
    boundary: BoundaryConditions,
    random: SeededRandom,
    radius: (Int) -> Double = { 1.0 },
): State {
    fun place(axis: Int) = DoubleArray(count) { random.nextDouble(boundary.box.lower(axis), boundary.box.upper(axis)) }
    return spheres(place(0), place(1), place(2), DoubleArray(count, radius), boundary)
}
