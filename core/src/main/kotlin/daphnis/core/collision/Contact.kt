@file:JvmName("Contacts")

package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.space.Images

/** Contact time of spheres that never touch. Larger than any time, so `contactTime(…) <= duration` is false. */
public const val NEVER: Double = Double.POSITIVE_INFINITY

/**
 * The time at which the surfaces of two approaching spheres touch, from the start of the step: the smaller root of
 * a t² + 2 b t + c = 0 with a = u², b = **d**·**u**, c = d² − s², for the relative position **d**, the relative velocity
 * **u** and s = r₁ + r₂.
 * - b ≥ 0: they recede. [NEVER], even when they overlap, since they separate by themselves.
 * - c ≤ 0 and b < 0: they touch or overlap by round-off, and approach. They collide at once
 *   (Bannerman, Strobl, Formella & Pöschel 2014, Comput. Part. Mech. 1, 191; arXiv 1211.6718).
 * - b² < ac: they miss each other. [NEVER].
 *
 * A pure function of the two states, and the same to the last bit from either side of the pair: exchanging the spheres
 * negates **d** and **u** exactly. Every search in daphnis computes exactly this expression.
 */
public fun contactTime(rows: StepRows, first: Int, second: Int, image: Int, images: Images): Double =
    contactTime(rows.state, first * STRIDE, rows.state, second * STRIDE, image, images)

/** The same for rows that begin at entry [p] of [a] and entry [q] of [b]. */
public fun contactTime(a: DoubleArray, p: Int, b: DoubleArray, q: Int, image: Int, images: Images): Double {
    relativeMotion(a, p, b, q, image, images) { t, dx, dy, dz, ux, uy, uz ->
        return t + timeToContact(dx, dy, dz, ux, uy, uz, a[p + RADIUS] + b[q + RADIUS])
    }
}

/**
 * Calls [use] with the later of the two local times, and the vector from the first to the second centre and their
 * relative velocity at that time, and returns its result.
 */
internal inline fun <R> relativeMotion(
    a: DoubleArray,
    p: Int,
    b: DoubleArray,
    q: Int,
    image: Int,
    images: Images,
    use: (t: Double, dx: Double, dy: Double, dz: Double, ux: Double, uy: Double, uz: Double) -> R,
): R {
    // Both at the later of the two local times. The sphere with the earlier one is moved there along its path, without
    // being changed.
    val t = maxOf(a[p + TIME], b[q + TIME])
    val dtP = t - a[p + TIME]
    val dtQ = t - b[q + TIME]
    val ux = b[q + VX] - a[p + VX] + images.slide(image, 0)
    val uy = b[q + VX + 1] - a[p + VX + 1] + images.slide(image, 1)
    val uz = b[q + VX + 2] - a[p + VX + 2] + images.slide(image, 2)
    val dx = (b[q] + b[q + VX] * dtQ) - (a[p] + a[p + VX] * dtP) + (images.shift(image, 0) + images.slide(image, 0) * t)
    val dy =
        (b[q + 1] + b[q + VX + 1] * dtQ) - (a[p + 1] + a[p + VX + 1] * dtP) +
            (images.shift(image, 1) + images.slide(image, 1) * t)
    val dz =
        (b[q + 2] + b[q + VX + 2] * dtQ) - (a[p + 2] + a[p + VX + 2] * dtP) +
            (images.shift(image, 2) + images.slide(image, 2) * t)
    return use(t, dx, dy, dz, ux, uy, uz)
}

/**
 * The same for spheres one of which has been made larger, as a bound for what it is: those that overlap touch at once,
 * at the later of their local times, whether they approach or not.
 */
internal fun soonestContact(a: DoubleArray, p: Int, b: DoubleArray, q: Int, image: Int, images: Images): Double {
    val time = contactTime(a, p, b, q, image, images)
    if (time < NEVER) return time
    val t = maxOf(a[p + TIME], b[q + TIME])
    var c = -(a[p + RADIUS] + b[q + RADIUS]) * (a[p + RADIUS] + b[q + RADIUS])
    for (axis in 0..2) {
        val at = b[q + axis] + b[q + VX + axis] * (t - b[q + TIME])
        val own = a[p + axis] + a[p + VX + axis] * (t - a[p + TIME])
        val d = at - own + (images.shift(image, axis) + images.slide(image, axis) * t)
        c += d * d
    }
    return if (c > 0) NEVER else t
}

/**
 * Calls [use] with the vector from the centre of [first] to the centre of [second], both at their places at [time], and
 * returns its result.
 */
internal inline fun <R> separation(
    rows: StepRows,
    first: Int,
    second: Int,
    image: Int,
    images: Images,
    time: Double,
    use: (dx: Double, dy: Double, dz: Double) -> R,
): R {
    val state = rows.state
    val p = first * STRIDE
    val q = second * STRIDE
    val dx = state[q] - state[p] + (images.shift(image, 0) + images.slide(image, 0) * time)
    val dy = state[q + 1] - state[p + 1] + (images.shift(image, 1) + images.slide(image, 1) * time)
    val dz = state[q + 2] - state[p + 2] + (images.shift(image, 2) + images.slide(image, 2) * time)
    return use(dx, dy, dz)
}

/**
 * The root described at [contactTime], counted from the moment of the given relative position and velocity; ≥ 0 or
 * [NEVER].
 */
public fun timeToContact(
    dx: Double,
    dy: Double,
    dz: Double,
    ux: Double,
    uy: Double,
    uz: Double,
    reach: Double,
): Double {
    ifApproaching(dx, dy, dz, ux, uy, uz, reach, Double.NEGATIVE_INFINITY) { a, b, c ->
        return waitUntilContact(a, b, c)
    }
    return NEVER
}
