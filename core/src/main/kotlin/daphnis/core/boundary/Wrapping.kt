package daphnis.core.boundary

import daphnis.core.population.Population
import kotlin.math.floor

internal const val AXES = 3

/** A box that repeats or has walls must end somewhere along the axes that [which] accepts. */
internal inline fun requireFinite(box: Box, which: (Int) -> Boolean) {
    for (axis in 0 until AXES) {
        require(!which(axis) || box.length(axis).isFinite()) {
            "box along ${"xyz"[axis]} must be finite for this boundary"
        }
    }
}

/** Puts the spheres [from] until [to] back into [box] along [axis], and counts the boxes they crossed. */
internal fun wrap(population: Population, axis: Int, box: Box, from: Int, to: Int) {
    val a = if (axis == 0) {
        population.x
    } else if (axis == 1) {
        population.y
    } else {
        population.z
    }
    val lower = box.lower(axis)
    val upper = box.upper(axis)
    val length = upper - lower
    for (k in from until to) {
        val v = a[k]
        if (v >= lower && v < upper) continue
        val boxes = floor((v - lower) / length)
        a[k] = inside(v - boxes * length, lower, upper)
        population.addCrossing(k, axis, boxes.toInt())
    }
}

/** Counts that the sphere at [index] has gone through [boxes] along the normal axis of images that slide, at [time]. */
internal fun ImageShear.count(population: Population, index: Int, boxes: Double, time: Double) {
    population.addCrossing(index, normalAxis, boxes.toInt())
    population.addCrossing(index, slideAxis, (-boxes * turns(time)).toInt())
}

/**
 * −tiny + length rounds to the upper face itself, which is outside; the nearest double inside is the same point to half
 * an ulp.
 */
internal fun inside(v: Double, lower: Double, upper: Double): Double = if (v < lower) {
    lower
} else if (v >= upper) {
    Math.nextDown(upper)
} else {
    v
}
