package daphnis.core.collision

import daphnis.core.boundary.Images
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import kotlin.math.sqrt

/** Contact time of spheres that never touch. Larger than any time, so `contactTime(…) <= duration` is false. */
public const val NEVER: Double = Double.POSITIVE_INFINITY

/**
 * When do the surfaces of two spheres, approaching, touch? Times count from the start of the step.
 *
 * With relative position **d**, relative velocity **u** and s = r₁ + r₂, the surfaces touch at the smaller root of
 * a t² + 2 b t + c = 0, a = u², b = **d**·**u**, c = d² − s², taken in the form c / (−b + √(b² − ac)), which does not cancel.
 * - b ≥ 0: they recede, [NEVER], also when they overlap: they part by themselves.
 * - c ≤ 0 and b < 0: they touch or overlap by round-off and approach: at once
 *   (Bannerman, Strobl, Formella & Pöschel 2014, Comput. Part. Mech. 1, 191; arXiv 1211.6718).
 * - b² < ac: they miss each other, [NEVER].
 *
 * A pure function of the two states, and the same to the last bit from either side of the pair: exchanging the spheres negates
 * **d** and **u** exactly. Every search in daphnis computes exactly this expression.
 */
public fun contactTime(rows: StepRows, first: Int, second: Int, image: Int, images: Images): Double {
    val state = rows.state
    val p = first * STRIDE
    val q = second * STRIDE
    // Both at the later of the two local times: the earlier one is carried there along its path, without being changed.
    val t = maxOf(state[p + TIME], state[q + TIME])
    val dtP = t - state[p + TIME]
    val dtQ = t - state[q + TIME]
    val ux = state[q + VX] - state[p + VX] + images.slide(image, 0)
    val uy = state[q + VX + 1] - state[p + VX + 1] + images.slide(image, 1)
    val uz = state[q + VX + 2] - state[p + VX + 2]
    val dx = (state[q] + state[q + VX] * dtQ) - (state[p] + state[p + VX] * dtP) + (images.shift(image, 0) + images.slide(image, 0) * t)
    val dy = (state[q + 1] + state[q + VX + 1] * dtQ) - (state[p + 1] + state[p + VX + 1] * dtP) +
        (images.shift(image, 1) + images.slide(image, 1) * t)
    val dz = (state[q + 2] + state[q + VX + 2] * dtQ) - (state[p + 2] + state[p + VX + 2] * dtP) + images.shift(image, 2)
    return t + timeToContact(dx, dy, dz, ux, uy, uz, state[p + RADIUS] + state[q + RADIUS])
}

/** The root described at [contactTime], counted from the moment of the given relative position and velocity; ≥ 0 or [NEVER]. */
public fun timeToContact(dx: Double, dy: Double, dz: Double, ux: Double, uy: Double, uz: Double, reach: Double): Double {
    val b = dx * ux + dy * uy + dz * uz
    if (b >= 0.0) return NEVER
    val c = dx * dx + dy * dy + dz * dz - reach * reach
    if (c <= 0.0) return 0.0
    val discriminant = b * b - (ux * ux + uy * uy + uz * uz) * c
    return if (discriminant < 0.0) NEVER else c / (sqrt(discriminant) - b)
}
