package daphnis.core.scenario

import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

internal const val AXES = 3

/** A length that does not count where all that is seen has these [corners]. */
internal fun toleranceOf(corners: List<DoubleArray>): Double = 1e-9 *
    DoubleArray(AXES) { axis -> corners.maxOf { it[axis] } - corners.minOf { it[axis] } }.let { sqrt(dot(it, it)) }

internal fun line(a: DoubleArray, b: DoubleArray): SurfaceCurve =
    SurfaceCurve(isStraight = true) { t -> DoubleArray(AXES) { a[it] + (b[it] - a[it]) * t } }

internal fun onCircle(centre: DoubleArray, u: DoubleArray, v: DoubleArray, radius: Double, angle: Double): DoubleArray =
    DoubleArray(AXES) { centre[it] + radius * (cos(angle) * u[it] + sin(angle) * v[it]) }

internal fun dot(a: DoubleArray, b: DoubleArray): Double = (0 until AXES).sumOf { a[it] * b[it] }

/** Exact along an axis. */
internal fun unit(v: List<Double>): DoubleArray {
    val scale = v.maxOf { abs(it) }
    val scaled = DoubleArray(AXES) { v[it] / scale }
    return sqrt(dot(scaled, scaled)).let { length -> DoubleArray(AXES) { scaled[it] / length } }
}

/** Two directions across [d] and each other. */
internal fun across(d: DoubleArray): Pair<DoubleArray, DoubleArray> {
    val least = (0 until AXES).minBy { abs(d[it]) }
    val other = (least + 1) % AXES
    val third = (least + 2) % AXES
    val u = DoubleArray(AXES)
    u[other] = -d[third]
    u[third] = d[other]
    val length = sqrt(dot(u, u))
    for (k in u.indices) u[k] /= length
    val v = DoubleArray(AXES) {
        val (a, b) = (it + 1) % AXES to (it + 2) % AXES
        d[a] * u[b] - d[b] * u[a]
    }
    return u to v
}
