package daphnis.core.wall

import daphnis.core.collision.NEVER
import kotlin.math.sqrt

/**
 * How long a gap stays open, or grows, at least: it is [gap] now and changes with [rate], and its second derivative is
 * [bending] or more; exactly that where [isExact]. 0 where it is closed and would be negative, [NEVER] where it stays
 * open for good. See [MovingFace].
 */
internal fun waitForGap(gap: Double, rate: Double, bending: Double, isExact: Boolean): Double {
    if (gap <= 0.0) {
        if (rate < 0.0) return 0.0
        if (bending >= 0.0) return NEVER
        // It touches, or overlaps by rounding, and leaves.
        if (!isExact) return rate / -bending
        return (rate + sqrt(maxOf(rate * rate - 2 * bending * gap, 0.0))) / -bending
    }
    if (bending >= 0.0 && rate >= 0.0) return NEVER
    val square = rate * rate - 2 * bending * gap
    if (square < 0.0) return NEVER
    val root = sqrt(square)
    return if (rate <= 0.0) 2 * gap / (root - rate) else (rate + root) / -bending
}
