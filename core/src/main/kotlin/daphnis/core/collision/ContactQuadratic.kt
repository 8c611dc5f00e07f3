package daphnis.core.collision

import kotlin.math.max
import kotlin.math.sqrt

// The quadratic a t² + 2 b t + c = 0 whose smaller root is the contact, see contactTime: a = u², b = d·u, c = d² − s².
//
// Root. c / (√(b² − ac) − b), which does not cancel for b < 0.
//
// Bounds. For c > 0 and b < 0 the root is not before c / (−2b). So there is no contact within a time τ
//   - if c > 0 and b ≥ 0 (apart, receding),
//   - if c > −2bτ (too far away),
//   - if b² < ac (a miss).
// With s larger than r₁ + r₂ all of them hold for spheres that stray from their paths, or whose places are rounded, by
// as much; the root is then a moment before which they cannot touch.
//
// | who asks | numbers | which bounds | root |
// |---|---|---|---|
// | every engine, for what is a collision: contactTime, and in grids ifApproaching | double, exact s | b, c | exact |
// | horizon: Lines.touch | double, s inflated | all | lower bound |
// | horizon: ScalarFilter, VectorFilter, for a block of lines | float, s inflated | all, with room for rounding | none |
// | lists: Approaching, for the list of a sphere | double, s with a margin | b, b² < ac | lower bound |

/** Time until a t² + 2 b t + c = 0 with [b] < 0, the surfaces in contact; [NEVER] when they miss. */
internal fun waitUntilContact(a: Double, b: Double, c: Double): Double {
    if (c <= 0.0) return 0.0
    val discriminant = b * b - a * c
    return if (discriminant < 0.0) NEVER else waitUntilRoot(b, c, discriminant)
}

/** The same for [c] > 0 and a [discriminant] b² − ac that is not negative: for spheres that are apart and do not miss. */
internal fun waitUntilRoot(b: Double, c: Double, discriminant: Double): Double = c / (sqrt(discriminant) - b)

/**
 * The kernel of searches in grids: calls [found] with a, b and c for a pair that approaches and is near enough to touch
 * in time. Nine of ten candidates end here, without a square root and with one well predicted branch.
 *
 * @param closing −2τ, from [closingWithin]; −∞ for no limit of time
 */
internal inline fun ifApproaching(
    dx: Double,
    dy: Double,
    dz: Double,
    ux: Double,
    uy: Double,
    uz: Double,
    reach: Double,
    closing: Double,
    found: (a: Double, b: Double, c: Double) -> Unit,
) {
    val b = dx * ux + dy * uy + dz * uz
    val c = dx * dx + dy * dy + dz * dz - reach * reach
    if (!(c > b * closing || b >= 0.0)) found(ux * ux + uy * uy + uz * uz, b, c)
}

/** −2τ for contacts up to [rest] from now in a step of [duration], with ample room for a few units of rounding. */
internal fun closingWithin(rest: Double, duration: Double): Double = -2.0 * (rest + duration * ROUNDING)

/**
 * Time until a point at distance² [most] − [inside] from a centre is at distance √[most] from it, as it moves with
 * velocity² [a]; [b] is its place times its velocity. The larger root of the same kind of quadratic; [FAR] at rest.
 */
internal fun waitUntilOutside(a: Double, b: Double, inside: Double): Double =
    if (a > 0.0) max(0.0, (sqrt(max(0.0, b * b + a * inside)) - b) / a) else FAR

/** A time that is too large to come, and finite, so that sums with it are no NaN. */
internal const val FAR = 1e300

private const val ROUNDING = 1e-12
