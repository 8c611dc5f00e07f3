package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.space.Images
import kotlin.math.abs
import kotlin.math.sqrt

/** Changes the velocities by [factor] times the separation, shared by the masses. */
internal fun exchange(rows: StepRows, first: Int, second: Int, factor: Double, outcome: CollisionOutcome) {
    val state = rows.state
    val p = first * STRIDE + VX
    val q = second * STRIDE + VX
    val dx = outcome.separationX
    val dy = outcome.separationY
    val dz = outcome.separationZ
    val m1 = rows.mass[first]
    val m2 = rows.mass[second]
    val f1 = factor * (m2 / (m1 + m2))
    val f2 = factor * (m1 / (m1 + m2))
    // Adding 0.0 turns −0.0 into +0.0. Otherwise the sign of a component that no impulse changes would depend on
    // which of the two was named first.
    state[p] = (state[p] + f1 * dx) + 0.0
    state[p + 1] = (state[p + 1] + f1 * dy) + 0.0
    state[p + 2] = (state[p + 2] + f1 * dz) + 0.0
    state[q] = (state[q] - f2 * dx) + 0.0
    state[q + 1] = (state[q + 1] - f2 * dy) + 0.0
    state[q + 2] = (state[q + 2] - f2 * dz) + 0.0
}

/**
 * Sees to it that the two do not approach any more. After an impact with ε = 0 they may still do so by round-off,
 * and an impulse as small as the rounding of the velocities is lost, or moves only the slower one. They touch, so
 * they would collide at once, and again for ever. What is added is of the size of that rounding, and moves both: of
 * three that press on one another the one in the middle would else be pushed to and fro. At an edge the same may be
 * so of two that are to approach, where [sign] is −1.
 */
internal fun separate(
    rows: StepRows,
    first: Int,
    second: Int,
    image: Int,
    images: Images,
    outcome: CollisionOutcome,
    sign: Double,
) {
    var b = sign * approach(rows, first, second, image, images, outcome)
    var fastest = maxOf(rows.fastestComponent(first), rows.fastestComponent(second))
    for (axis in 0..2) fastest = maxOf(fastest, abs(images.slide(image, axis)))
    val rounding = VELOCITY_ROUNDING * fastest
    if (b >= 0.0 && abs(outcome.impactSpeed) > rounding) return
    val dx = outcome.separationX
    val dy = outcome.separationY
    val dz = outcome.separationZ
    val d2 = dx * dx + dy * dy + dz * dz
    var more = minOf(b / d2, -rounding / sqrt(d2), -Double.MIN_VALUE)
    do {
        exchange(rows, first, second, sign * more, outcome)
        more *= 2
        b = sign * approach(rows, first, second, image, images, outcome)
    } while (b < 0.0)
}

private fun StepRows.fastestComponent(slot: Int): Double {
    val p = slot * STRIDE + VX
    return maxOf(abs(state[p]), abs(state[p + 1]), abs(state[p + 2]))
}

/** **d**·**u** of the two at contact, as [contactTime] finds it. */
private fun approach(
    rows: StepRows,
    first: Int,
    second: Int,
    image: Int,
    images: Images,
    outcome: CollisionOutcome,
): Double {
    val state = rows.state
    val p = first * STRIDE + VX
    val q = second * STRIDE + VX
    val ux = state[q] - state[p] + images.slide(image, 0)
    val uy = state[q + 1] - state[p + 1] + images.slide(image, 1)
    val uz = state[q + 2] - state[p + 2] + images.slide(image, 2)
    return outcome.separationX * ux + outcome.separationY * uy + outcome.separationZ * uz
}

/** Of a velocity and of what is computed from it, relative to it. */
private const val VELOCITY_ROUNDING = 1e-15
