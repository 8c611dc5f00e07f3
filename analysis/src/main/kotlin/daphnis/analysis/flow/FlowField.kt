package daphnis.analysis.flow

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import kotlin.math.sqrt

/**
 * The mean flow of a box on a grid of cells in the x-y plane: mass-weighted mean velocities, and lines along it. As a
 * [Measure]: Σ m, Σ m v_x, Σ m v_y by cell `i · ny + j`, one block after the other, so that samples can be summed
 * before [mean] divides them.
 */
public class FlowField(public val nx: Int, public val ny: Int) : Measure {
    init {
        require(nx >= 1 && ny >= 1) { "$nx x $ny cells; there must be one at least" }
    }

    override fun of(state: State): DoubleArray {
        val p = state.population
        val box = state.boundary.box
        val sums = DoubleArray(3 * nx * ny)
        for (k in 0 until p.size) {
            val i = ((p.x[k] - box.lowerX) / box.length(0) * nx).toInt().coerceIn(0, nx - 1)
            val j = ((p.y[k] - box.lowerY) / box.length(1) * ny).toInt().coerceIn(0, ny - 1)
            val cell = i * ny + j
            sums[cell] += p.mass[k]
            sums[nx * ny + cell] += p.mass[k] * p.vx[k]
            sums[2 * nx * ny + cell] += p.mass[k] * p.vy[k]
        }
        return sums
    }

    /** Mean velocity along x (0) or y (1) by cell from [sums]; NaN in an empty cell. */
    public fun mean(sums: DoubleArray, axis: Int): DoubleArray = DoubleArray(nx * ny) { cell ->
        if (sums[cell] == 0.0) Double.NaN else sums[(1 + axis) * nx * ny + cell] / sums[cell]
    }

    /**
     * The line of the flow through ([x], [y]), both in cells, as pairs x, y: steps of half a cell by the midpoint rule,
     * until it leaves the grid, comes to an empty cell or has [steps] points.
     */
    @JvmOverloads
    public fun line(vx: DoubleArray, vy: DoubleArray, x: Double, y: Double, steps: Int = 4 * (nx + ny)): DoubleArray {
        val points = ArrayList<Double>()
        var a = x
        var b = y
        repeat(steps) {
            points += a
            points += b
            val (u, v) = direction(vx, vy, a, b) ?: return points.toDoubleArray()
            val (um, vm) = direction(vx, vy, a + 0.25 * u, b + 0.25 * v) ?: return points.toDoubleArray()
            a += 0.5 * um
            b += 0.5 * vm
        }
        return points.toDoubleArray()
    }

    private fun direction(vx: DoubleArray, vy: DoubleArray, a: Double, b: Double): Pair<Double, Double>? {
        if (!(a >= 0 && b >= 0 && a < nx && b < ny)) return null
        val cell = a.toInt() * ny + b.toInt()
        val speed = sqrt(vx[cell] * vx[cell] + vy[cell] * vy[cell])
        return if (speed > 0) vx[cell] / speed to vy[cell] / speed else null
    }
}
