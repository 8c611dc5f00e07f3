package daphnis.core.force

import kotlin.math.sqrt

/**
 * The potential of the force that fades with the weights of [GravityCut]. It is 0 where gravity ends, and its slope
 * along the periodic axes is the weighted force there. With q = ρ² + ε² and w a cubic in q, the work ½ ∫ w q^(−3/2) dq
 * is elementary. Where gravity fades, the height z between two particles is neglected. The relative error of this is
 * about (z/ρ)², where gravity is small already.
 *
 * @param range2 square of the distance at which gravity ends; infinite where nothing is cut
 * @param inner2 square of that at which it begins to fade
 * @param softening2 ε²
 */
internal class FadingPotential(range2: Double, inner2: Double, private val softening2: Double) {
    private val end = range2 + softening2
    private val width = range2 - inner2
    private val a0 = 3 * sq(end / width) - 2 * cube(end / width)
    private val a1 = (-6 * end / width + 6 * sq(end / width)) / width
    private val a2 = (3 - 6 * end / width) / sq(width)
    private val a3 = 2 / cube(width)
    private val atEnd = primitive(end)

    /**
     * By how much the potential is shallower than 1/√(r² + ε²) where nothing fades, in 1/length; 0 without a cut.
     */
    val lift: Double = if (range2.isInfinite()) 0.0 else 1 / sqrt(inner2 + softening2) - depth(inner2)

    /** Minus the potential of a unit of mass at ρ² = [rho2] where it fades, divided by G. */
    fun depth(rho2: Double): Double = atEnd - primitive(rho2 + softening2)

    /** ½ ∫ w q^(−3/2) dq. */
    private fun primitive(q: Double): Double = (-a0 + q * (a1 + q * (a2 / 3 + q * a3 / 5))) / sqrt(q)

    private fun sq(a: Double) = a * a

    private fun cube(a: Double) = a * a * a
}
