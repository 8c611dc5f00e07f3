package daphnis.core.boundary

import daphnis.core.population.Population
import kotlin.math.floor

internal const val AXES = 3
internal const val AXIS_NAMES = "xyz"

/** Requires finite bounds along the axes that [which] accepts: a box cannot repeat or have walls without them. */
internal inline fun requireFinite(box: Box, which: (Int) -> Boolean) {
    for (axis in 0 until AXES) {
        require(!which(axis) || box.length(axis).isFinite()) {
            "box along ${AXIS_NAMES[axis]} must be finite for this boundary"
        }
    }
}

/**
 * Puts the spheres [from] until [to] back into [box] along [axis], and counts the boxes they crossed. Calls [crossed]
 * with the index of each that was outside, and with the number of boxes by which it is put back.
 */
internal inline fun wrap(
    population: Population,
    axis: Int,
    box: Box,
    from: Int,
    to: Int,
    crossed: (Int, Double) -> Unit = { _, _ -> },
) {
    val position = population.position(axis)
    val lower = box.lower(axis)
    val upper = box.upper(axis)
    val length = upper - lower
    for (k in from until to) {
        val v = position[k]
        if (v >= lower && v < upper) continue
        val boxes = floor((v - lower) / length)
        position[k] = inside(v - boxes * length, lower, upper)
        population.addCrossing(k, axis, boxes.toInt())
        crossed(k, boxes)
    }
}

/**
 * −tiny + length rounds to the upper face itself, which is outside. The nearest double inside is the same point to half
 * an ulp.
 */
internal fun inside(v: Double, lower: Double, upper: Double): Double = if (v < lower) {
    lower
} else if (v >= upper) {
    Math.nextDown(upper)
} else {
    v
}
