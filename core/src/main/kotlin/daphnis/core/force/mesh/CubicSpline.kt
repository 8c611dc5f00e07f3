package daphnis.core.force.mesh

/**
 * The cubic B-spline by which a sphere is spread over four points of a mesh along an axis, and by which the mesh is
 * read at the sphere. For a sphere t of a spacing beyond point i these are the points i − 1 to i + 2.
 */
internal object CubicSpline {
    /** How many points along an axis a sphere has a share in. */
    const val POINTS = 4

    /** Writes the four weights to [w] from [at] on. */
    fun weights(t: Double, w: DoubleArray, at: Int) {
        val s = 1 - t
        w[at] = s * s * s * SIXTH
        w[at + 1] = (4 + t * t * (3 * t - 6)) * SIXTH
        w[at + 2] = (4 + s * s * (3 * s - 6)) * SIXTH
        w[at + 3] = t * t * t * SIXTH
    }

    /** Writes the slopes of the four weights, per spacing, to [w] from [at] on. */
    fun slopes(t: Double, w: DoubleArray, at: Int) {
        val s = 1 - t
        w[at] = -0.5 * s * s
        w[at + 1] = t * (1.5 * t - 2)
        w[at + 2] = s * (2 - 1.5 * s)
        w[at + 3] = 0.5 * t * t
    }

    /**
     * What a wave of [angle] radians per spacing, within ±π, is to be multiplied by so that what is spread and read
     * with these weights has its true amplitude, with the least error from waves that look alike on the mesh: W²/(Σ
     * W²)² (Hockney & Eastwood 1988, chapter 8).
     */
    fun correction(angle: Double): Double {
        val half = angle / 2
        val sine = StrictMath.sin(half)
        val sinc = if (half == 0.0) 1.0 else sine / half
        val s2 = sine * sine
        val all = 1 + s2 * (-4.0 / 3 + s2 * (2.0 / 5 - s2 * (4.0 / 315)))
        val squared = sinc * sinc
        val fourth = squared * squared
        return fourth * fourth / (all * all)
    }

    private const val SIXTH = 1.0 / 6
}
