package daphnis.core.boundary

import kotlin.math.floor

internal const val AXES = 3

/** A box that repeats or has walls must end somewhere along the axes that [which] accepts. */
internal inline fun requireFinite(box: Box, which: (Int) -> Boolean) {
    for (axis in 0 until AXES) {
        require(!which(axis) || box.length(axis).isFinite()) { "box along ${"xyz"[axis]} must be finite for this boundary" }
    }
}

/** Puts the entries [from] until [to] back into [lower, upper). */
internal fun wrap(a: DoubleArray, lower: Double, upper: Double, from: Int, to: Int) {
    val length = upper - lower
    for (k in from until to) {
        val v = a[k]
        if (v >= lower && v < upper) continue
        a[k] = inside(v - floor((v - lower) / length) * length, lower, upper)
    }
}

/** −tiny + length rounds to the upper face itself, which is outside; the nearest double inside is the same point to half an ulp. */
internal fun inside(v: Double, lower: Double, upper: Double): Double = if (v < lower) {
    lower
} else if (v >= upper) {
    Math.nextDown(upper)
} else {
    v
}
