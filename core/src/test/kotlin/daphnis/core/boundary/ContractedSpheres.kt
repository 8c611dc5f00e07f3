package daphnis.core.boundary

import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import kotlin.math.abs

private const val COUNT = 60
private const val OPEN_EXTENT = 10.0

/** Spheres drawn up to so many boxes outside along each axis, about as fast as to cross a box in a unit of time. */
internal fun spheres(case: Contracted, boxesAway: Int): Population {
    val random = SeededRandom(11)
    val columns = Array(6) { DoubleArray(COUNT) }
    for (k in 0 until COUNT) {
        for (axis in 0..2) {
            val boxes = (2 * boxesAway + 1) * (random.nextDouble() - 0.5)
            columns[axis][k] = middle(case, axis) + boxes * extent(case, axis)
            columns[3 + axis][k] = 2 * extent(case, axis) * (random.nextDouble() - 0.5)
        }
    }
    return population(case, columns)
}

/** Spheres on, just below and just above faces, of both zeros, in corners, and up to a million boxes away. */
internal fun faces(case: Contracted): Population {
    val along = Array(3) { axis ->
        val low = middle(case, axis) - extent(case, axis) / 2
        val high = middle(case, axis) + extent(case, axis) / 2
        val edge = extent(case, axis)
        listOf(low, high).flatMap { listOf(it, Math.nextDown(it), Math.nextUp(it)) } +
            listOf(0.0, -0.0, Double.MIN_VALUE, -Double.MIN_VALUE, low - edge, high + edge, high + edge / 3) +
            listOf(low + 1e6 * edge, low - 1e6 * edge, high - 123_456.7 * edge)
    }
    val n = along[0].size
    // The second round brings each place along x together with another along y and z: corners.
    val columns = Array(6) { c ->
        DoubleArray(2 * n) { if (c > 2) 0.1 * extent(case, c - 3) else along[c][(it + it / n * (c + 1)) % n] }
    }
    return population(case, columns)
}

private fun population(case: Contracted, c: Array<DoubleArray>): Population {
    val radius = 0.2 * (0..2).minOf { extent(case, it) }
    val n = c[0].size
    return Population(c[0], c[1], c[2], c[3], c[4], c[5], DoubleArray(n) { radius }, DoubleArray(n) { 1.0 })
}

internal fun extent(case: Contracted, axis: Int) =
    case.conditions.box.length(axis).let { if (it.isFinite()) it else OPEN_EXTENT }

internal fun middle(case: Contracted, axis: Int): Double {
    val box = case.conditions.box
    return if (box.length(axis).isFinite()) box.lower(axis) + box.length(axis) / 2 else 0.0
}

internal fun speedOfImages(case: Contracted) = (0..2).maxOf { extent(case, it) }

/** Of positions some boxes away, after some additions. */
internal fun rounding(case: Contracted, axis: Int): Double =
    1e-14 * 10 * ((0..2).maxOf { extent(case, it) } + abs(middle(case, axis)))
