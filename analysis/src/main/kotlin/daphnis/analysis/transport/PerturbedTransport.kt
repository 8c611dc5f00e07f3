package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.DISSIPATED
import daphnis.core.run.TransportColumns.MASS
import daphnis.core.run.TransportColumns.SCALE_HEIGHT
import daphnis.core.run.TransportColumns.TIME
import daphnis.core.run.TransportColumns.kinetic
import daphnis.core.run.TransportColumns.virial
import kotlin.math.floor

/**
 * Averages of a perturbed sheet over whole radial periods, from a run's [TransportTable]. Units are the run's.
 *
 * With u the flow of streamlines, which has the gradients ∂u_x/∂x and ∂u_y/∂x of the time, and P V = Σ m w_a w_b + Σ
 * Δp_a δ_b/T as in [Transport]:
 *
 * - the images do the work −(P_xx ∂u_x/∂x + P_yx ∂u_y/∂x) V, which over a period is what collisions dissipate;
 * - the flux of angular momentum through a streamline, over the length of the orbit and the distance from the planet, is
 *   P_yx integrated over the height, P_yx V/(ΔX L_y). Its mean over a period counts: that of every streamline
 *   (Borderies, Goldreich & Tremaine 1983, Icarus 55, 124). Here it is over the mean surface density. For q = 0 it is
 *   s ν with the rate of shear s. Negative, it is inward.
 *
 * Integrals are by trapezoids between rows; between rows they are linear, where a period does not end at one.
 *
 * @param boundary of the run, at any time
 * @param period of the perturbation, 2π/κ
 * @throws IllegalArgumentException for a boundary that stays as it is, or fewer than two rows
 */
public class PerturbedTransport(
    private val table: TransportTable,
    private val boundary: BoundaryConditions,
    private val period: Double,
) {
    init {
        require(boundary.isChanging) { "the boundary stays as it is" }
        require(table.size >= 2) { "the transport table has fewer than two rows; two are needed" }
    }

    private val time = table[TIME]
    private val from = time[0]

    /** Whole periods from the first row on. */
    public val periods: Int = floor((time.last() - from) / period * (1 + ROUNDING)).toInt()

    private val mass = table[MASS]
    private val meanLength = (boundary.at(0.0).box.length(0) + boundary.at(period / 2).box.length(0)) / 2

    /** Work over mass in each period. */
    private val work = inPeriods(sums { row, carried -> power(time[row], carried) })

    /** Energy dissipated over mass in each period. */
    private val dissipated = table[DISSIPATED].let { sum ->
        inPeriods(DoubleArray(time.size) { (sum[it] - sum[0]) / mass[0] })
    }

    /**
     * What is carried over the mean surface density, in each period: of the particles that move, and of all.
     */
    private val translational =
        inPeriods(sums { row, carried -> if (carried.isJump) 0.0 else flux(time[row], carried) })
    private val flux = inPeriods(sums { row, carried -> flux(time[row], carried) })

    /** P V/M along xx and yx. */
    private class Carried(val xx: Double, val yx: Double, val isJump: Boolean)

    private fun power(t: Double, carried: Carried): Double = boundary.at(t).meanFlow!!.let {
        -(carried.xx * it.spread + carried.yx * it.rate)
    }

    private fun flux(t: Double, carried: Carried): Double = carried.yx * meanLength / boundary.at(t).box.length(0)

    private fun interface OfRow {
        fun of(row: Int, carried: Carried): Double
    }

    /** The integral of [of] from the first row to each. What collisions add is halved between the rows around it. */
    private fun sums(of: OfRow): DoubleArray {
        val (xx, yx) = table[kinetic("xx")] to table[kinetic("xy")]
        val impactsX = table[virial("xx")]
        val impactsY = virial("yx").let { if (it in table) table[it] else table[virial("xy")] }
        val result = DoubleArray(time.size)
        for (k in 1 until time.size) {
            val half = (time[k] - time[k - 1]) / 2
            val jump = Carried(
                (impactsX[k] - impactsX[k - 1]) / mass[k - 1] / 2,
                (impactsY[k] - impactsY[k - 1]) / mass[k - 1] / 2,
                isJump = true,
            )
            result[k] = result[k - 1]
            for (row in k - 1..k) {
                result[k] += half * of.of(row, Carried(xx[row], yx[row], isJump = false)) + of.of(row, jump)
            }
        }
        return result
    }

    /** What [sum] gains in each period. */
    private fun inPeriods(sum: DoubleArray): DoubleArray = DoubleArray(periods) { at(sum, it + 1) - at(sum, it) }

    /** [values] at the end of period [k]. */
    private fun at(values: DoubleArray, k: Int): Double {
        val t = minOf(from + k * period, time.last())
        val next = time.indexOfFirst { it >= t }
        if (next == 0) return values[0]
        val part = (t - time[next - 1]) / (time[next] - time[next - 1])
        return values[next - 1] + part * (values[next] - values[next - 1])
    }

    /** The [flux] of angular momentum in each period, length²/time². */
    public fun fluxes(): DoubleArray = DoubleArray(periods) { flux[it] / period }

    /** The times at which these periods end. */
    public fun ends(): DoubleArray = DoubleArray(periods) { from + (it + 1) * period }

    /** The flux of angular momentum over the mean surface density, length²/time², see [PerturbedTransport]. */
    public val angularMomentumFlux: BlockAverage get() = BlockAverage.of(flux) * (1 / period)

    /** The part of it that particles carry by moving. */
    public val translationalFlux: BlockAverage get() = BlockAverage.of(translational) * (1 / period)

    /**
     * Work of the images over what is dissipated: 1 in a steady state; NaN without dissipation. What they differ by adds
     * up to the change of the energy from the first period to the last.
     */
    public val energyBalance: BlockAverage
        get() {
            val (xx, yy, zz) = listOf("xx", "yy", "zz").map { table[kinetic(it)] }
            val height = table[SCALE_HEIGHT]
            val energies = arrayOf(
                atEnds(DoubleArray(time.size) { xx[it] + yy[it] + zz[it] }),
                atEnds(DoubleArray(time.size) { height[it] * height[it] }),
            )
            return BlockAverage.of(arrayOf(work, dissipated), energies) {
                if (it[1] == 0.0) Double.NaN else it[0] / it[1]
            }
        }

    private fun atEnds(values: DoubleArray) = DoubleArray(periods + 1) { at(values, it) }

    /**
     * By phase of the perturbation in [bins] of a period, means over all periods: phase from 0 to 1, surface density
     * over its mean, ⟨w²⟩, and the flux of angular momentum; empty bins have NaN.
     */
    public fun byPhase(bins: Int): Array<DoubleArray> {
        val (xx, yy, zz) = listOf("xx", "yy", "zz").map { table[kinetic(it)] }
        val sum = sums { row, carried -> flux(time[row], carried) }
        val columns = Array(PHASE_COLUMNS) { DoubleArray(bins) }
        val counts = IntArray(bins)
        val lengths = DoubleArray(bins)
        for (k in 1 until time.size) {
            if (time[k] > from + periods * period * (1 + ROUNDING)) break
            val middle = (time[k] + time[k - 1]) / 2 / period
            val bin = ((middle - floor(middle)) * bins).toInt().coerceAtMost(bins - 1)
            counts[bin]++
            lengths[bin] += time[k] - time[k - 1]
            columns[1][bin] += meanLength / boundary.at(middle * period).box.length(0)
            columns[2][bin] += (xx[k] + yy[k] + zz[k] + xx[k - 1] + yy[k - 1] + zz[k - 1]) / 2
            columns[3][bin] += sum[k] - sum[k - 1]
        }
        for (bin in 0 until bins) {
            columns[0][bin] = (bin + 0.5) / bins
            for (c in 1..2) columns[c][bin] /= counts[bin].toDouble()
            columns[3][bin] /= lengths[bin]
        }
        return columns
    }

    private companion object {
        const val ROUNDING = 1e-9
        const val PHASE_COLUMNS = 4
    }
}
