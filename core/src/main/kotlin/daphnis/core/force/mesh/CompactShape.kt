package daphnis.core.force.mesh

/**
 * Splits 1/r into a part that a mesh can hold and one that ends at a [radius]: the first is the potential of a cloud of
 * density ∝ (1 − r²/a²)³ within a = [radius], and 1/r outside (particle–particle, particle–mesh: Hockney & Eastwood
 * 1988, Computer Simulation Using Particles, chapter 8). Within the cloud force and potential are polynomials in r²/a².
 */
internal class CompactShape(val radius: Double) {
    /** The potential of the cloud in its middle, per unit of mass, 1/length. */
    val middle: Double = MIDDLE / radius

    /** The transform of the cloud at wave number [k]: 945 j₄(ka)/(ka)⁴, 1 at 0. */
    fun transform(k: Double): Double {
        val q = k * radius
        if (q < SERIES_BELOW) return series(q * q)
        val i = 1 / q
        val i2 = i * i
        val j4 = i * ((105 * i2 * i2 - 45 * i2 + 1) * StrictMath.sin(q) - i * (105 * i2 - 10) * StrictMath.cos(q))
        return 945 * j4 * i2 * i2
    }

    private fun series(q2: Double): Double {
        var term = 1.0
        var sum = 1.0
        for (m in 1..TERMS) {
            term *= -q2 / (2.0 * m * (2 * m + 9))
            sum += term
        }
        return sum
    }

    companion object {
        const val MIDDLE = 315.0 / 128
        private const val SERIES_BELOW = 4.0
        private const val TERMS = 24

        /** Force over distance, times a³, at u² = r²/a² ≤ 1. */
        fun pull(u2: Double): Double = 105.0 / 16 + u2 * (-189.0 / 16 + u2 * (135.0 / 16 - u2 * (35.0 / 16)))

        /** Potential times a, at u² = r²/a² ≤ 1. */
        fun depth(u2: Double): Double =
            MIDDLE + u2 * (-105.0 / 32 + u2 * (189.0 / 64 + u2 * (-45.0 / 32 + u2 * (35.0 / 128))))
    }
}
