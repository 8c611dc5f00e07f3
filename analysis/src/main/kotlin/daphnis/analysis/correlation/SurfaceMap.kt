package daphnis.analysis.correlation

import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State

/**
 * Surface density of a patch on a grid of cells: entry `i · ny + j` for the cell i along x, j along y. Particles count
 * where their centre is.
 *
 * @property nx cells along x; [ny] along y
 */
public class SurfaceMap private constructor(public val nx: Int, public val ny: Int, state: State) {
    private val box = state.boundary.box
    private val images = PlaneImages(state.boundary, state.time)

    public val density: DoubleArray = DoubleArray(nx * ny)

    /**
     * The row of images beyond the upper face, in cells that go on from those of [density]: counted anew, because a
     * slide is not a whole number of cells.
     */
    private val beyond: DoubleArray = if (images.offset == 0.0) density else DoubleArray(nx * ny)

    /** Width of a cell. */
    public val dx: Double = box.length(0) / nx
    public val dy: Double = box.length(1) / ny

    /** Mean of [density]. */
    public val mean: Double get() = density.sum() / density.size

    private fun add(x: Double, y: Double, mass: Double) {
        if (!(x >= box.lowerX && y >= box.lowerY)) return
        val i = ((x - box.lowerX) / dx).toInt()
        val j = ((y - box.lowerY) / dy).toInt()
        if (i >= nx || j >= ny) return
        density[i * ny + j] += mass / (dx * dy)
        if (beyond === density) return
        if (images.across == 0) {
            beyond[i * ny + slid(y - box.lowerY, dy, ny)] += mass / (dx * dy)
        } else {
            beyond[slid(x - box.lowerX, dx, nx) * ny + j] += mass / (dx * dy)
        }
    }

    private fun slid(place: Double, width: Double, cells: Int) = ((place + images.offset) / width).toInt() % cells

    /**
     * Autocorrelation of the surface density at lags of whole cells, ⟨δΣ(r) δΣ(r + l)⟩ / ⟨Σ⟩². Continues through
     * periodic faces, with images at their places at that time; at faces without images the average is over the cells
     * that have a partner. 0 throughout for an empty patch.
     *
     * @param lagX largest lag along x in cells, below [nx]; likewise [lagY]
     * @return entry `(i + lagX) · (2 lagY + 1) + j + lagY`
     */
    public fun autocorrelation(lagX: Int, lagY: Int): DoubleArray {
        require(lagX in 0 until nx && lagY in 0 until ny) {
            "lags are $lagX and $lagY; they must be in 0 until $nx and $ny"
        }
        val result = DoubleArray((2 * lagX + 1) * (2 * lagY + 1))
        val mean = mean
        if (mean == 0.0) return result
        val here = DoubleArray(density.size) { density[it] - mean }
        val there = if (beyond === density) here else DoubleArray(beyond.size) { beyond[it] - mean }
        val width = 2 * lagY + 1
        val radial = images.across == 0
        for (across in 0..if (radial) lagX else lagY) {
            val most = if (radial) lagY else lagX
            for (along in -most..most) {
                val value = covariance(across, along, here, there) / (mean * mean)
                val a = if (radial) across else along
                val b = if (radial) along else across
                result[(lagX + a) * width + lagY + b] = value
                result[(lagX - a) * width + lagY - b] = value
            }
        }
        return result
    }

    /**
     * ⟨δΣ(r) δΣ(r + l)⟩ for the lag of [across] ≥ 0 cells from row to row and [along] cells within, from δΣ [here] and
     * in the row of images beyond, [there].
     */
    private fun covariance(across: Int, along: Int, here: DoubleArray, there: DoubleArray): Double {
        val radial = images.across == 0
        val rows = if (radial) nx else ny
        val places = if (radial) ny else nx
        val row = if (radial) ny else 1
        val place = if (radial) 1 else ny
        val isRing = images.repeats(images.along)
        var sum = 0.0
        var count = 0
        for (i in 0 until if (images.repeats(images.across)) rows else rows - across) {
            val isOver = i + across >= rows
            val other = if (isOver) there else here
            val base = (if (isOver) i + across - rows else i + across) * row
            // Cells whose partner is before the row, in it and behind it, in their order.
            val first = (-along).coerceIn(0, places)
            val end = (places - along).coerceIn(0, places)
            val own = i * row
            val at = base + along * place
            val turn = places * place
            if (isRing) sum += product(here, own, other, at + turn, place, 0, first)
            sum += product(here, own, other, at, place, first, end)
            if (isRing) sum += product(here, own, other, at - turn, place, end, places)
            count += if (isRing) places else end - first
        }
        return sum / count
    }

    /** Σ a[atA + j step] b[atB + j step] over j from [from] to [end], in four sums, none of which waits for another. */
    private fun product(a: DoubleArray, atA: Int, b: DoubleArray, atB: Int, step: Int, from: Int, end: Int): Double {
        var s0 = 0.0
        var s1 = 0.0
        var s2 = 0.0
        var s3 = 0.0
        var j = from
        while (j < end - 3) {
            val i = atA + j * step
            val k = atB + j * step
            s0 += a[i] * b[k]
            s1 += a[i + step] * b[k + step]
            s2 += a[i + 2 * step] * b[k + 2 * step]
            s3 += a[i + 3 * step] * b[k + 3 * step]
            j += 4
        }
        while (j < end) {
            s0 += a[atA + j * step] * b[atB + j * step]
            j++
        }
        return (s0 + s1) + (s2 + s3)
    }

    public companion object {
        /** The map of [state] in cells of about [cell]. */
        @JvmStatic
        public fun of(state: State, cell: Double): SurfaceMap {
            require(cell > 0) { "cell is $cell; it must be > 0" }
            val box = state.boundary.box
            val nx = Math.rint(box.length(0) / cell).toInt().coerceIn(1, MOST_CELLS)
            val ny = Math.rint(box.length(1) / cell).toInt().coerceIn(1, MOST_CELLS)
            return of(state, nx, ny)
        }

        /** The map of [state] in [nx] cells along x and [ny] along y, however large its box is. */
        @JvmStatic
        public fun of(state: State, nx: Int, ny: Int): SurfaceMap {
            require(nx >= 1 && ny >= 1) { "$nx x $ny cells; there must be one at least" }
            val map = SurfaceMap(nx, ny, state)
            val p = state.population
            for (k in 0 until p.size) if (state.isParticle(k)) map.add(p.x[k], p.y[k], p.mass[k])
            return map
        }

        private const val MOST_CELLS = 128
    }
}
