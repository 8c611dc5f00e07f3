package daphnis.analysis.correlation

import daphnis.analysis.insitu.PatchState
import kotlin.math.atan2

/**
 * Surface density of a patch on a grid of cells: entry `i · ny + j` for the cell i along x, j along y. Particles count where their centre is.
 *
 * @property nx cells along x; [ny] along y
 */
public class SurfaceMap private constructor(public val nx: Int, public val ny: Int, private val state: PatchState) {
    public val density: DoubleArray = DoubleArray(nx * ny)

    /** Width of a cell. */
    public val dx: Double = state.boundary.box.length(0) / nx
    public val dy: Double = state.boundary.box.length(1) / ny

    private val slide: Int = state.boundary.shear.let { shear ->
        if (shear != null && shear.normalAxis == 0) Math.rint(shear.offset(state.time) / dy).toInt() else 0
    }

    /** Mean of [density]. */
    public val mean: Double get() = density.sum() / density.size

    /**
     * Autocorrelation of the surface density at lags of whole cells, ⟨δΣ(r) δΣ(r + l)⟩ / ⟨Σ⟩², through periodic faces, images where they are at the time.
     *
     * @param lagX largest lag along x in cells; likewise [lagY]
     * @return entry `(i + lagX) · (2 lagY + 1) + j + lagY`
     */
    public fun autocorrelation(lagX: Int, lagY: Int): DoubleArray {
        val mean = mean
        val result = DoubleArray((2 * lagX + 1) * (2 * lagY + 1))
        if (mean == 0.0) return result
        val width = 2 * lagY + 1
        for (a in 0..lagX) {
            for (b in -lagY..lagY) {
                var sum = 0.0
                for (i in 0 until nx) {
                    val over = if (i + a >= nx) 1 else 0
                    val column = (i + a - over * nx) * ny
                    // Beyond the outer face stands the image, displaced by the slide.
                    val shift = b - over * slide
                    for (j in 0 until ny) sum += (density[i * ny + j] - mean) * (density[column + Math.floorMod(j + shift, ny)] - mean)
                }
                val value = sum / (nx * ny) / (mean * mean)
                result[(a + lagX) * width + b + lagY] = value
                result[(lagX - a) * width + lagY - b] = value
            }
        }
        return result
    }

    public companion object {
        /** The map of [state] in cells of about [cell]. */
        public fun of(state: PatchState, cell: Double): SurfaceMap {
            require(cell > 0) { "cell is $cell; it must be > 0" }
            val box = state.boundary.box
            val nx = Math.rint(box.length(0) / cell).toInt().coerceIn(1, MOST_CELLS)
            val ny = Math.rint(box.length(1) / cell).toInt().coerceIn(1, MOST_CELLS)
            val map = SurfaceMap(nx, ny, state)
            val p = state.population
            for (k in 0 until p.size) {
                if (!state.isParticle(k)) continue
                val i = ((p.x[k] - box.lowerX) / map.dx).toInt()
                val j = ((p.y[k] - box.lowerY) / map.dy).toInt()
                if (p.x[k] >= box.lowerX && p.y[k] >= box.lowerY && i < nx && j < ny) map.density[i * ny + j] += p.mass[k] / (map.dx * map.dy)
            }
            return map
        }

        /**
         * Angle in radians between the orbit (y) and the long axis of the central ridge of an autocorrelation, positive for a trailing one, which leans
         * backward outward; from the second moments of what exceeds half the mean of the lags next to the centre. NaN when nothing does.
         */
        public fun pitchAngle(autocorrelation: DoubleArray, lagX: Int, lagY: Int, dx: Double, dy: Double): Double {
            val width = 2 * lagY + 1
            // The centre itself holds the noise of counting.
            val peak = listOf(1 to 0, 0 to 1, 1 to 1, 1 to -1).filter { it.first <= lagX && Math.abs(it.second) <= lagY }
                .map { (a, b) -> autocorrelation[(a + lagX) * width + b + lagY] }.ifEmpty { return Double.NaN }.average()
            if (!(peak > 0)) return Double.NaN
            var xx = 0.0
            var yy = 0.0
            var xy = 0.0
            for (a in -lagX..lagX) {
                for (b in -lagY..lagY) {
                    val excess = autocorrelation[(a + lagX) * width + b + lagY] - peak / 2
                    if (excess <= 0 || a == 0 && b == 0) continue
                    xx += excess * a * a * dx * dx
                    yy += excess * b * b * dy * dy
                    xy += excess * a * b * dx * dy
                }
            }
            if (xx == 0.0 && yy == 0.0) return Double.NaN
            // Long axis at the angle t from y toward x: tan 2t = 2 xy / (yy − xx); outward and backward is x > 0, y < 0.
            return -0.5 * atan2(2 * xy, yy - xx)
        }

        private const val MOST_CELLS = 128
    }
}
