package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.COLLISIONS
import daphnis.core.run.TransportColumns.MASS
import daphnis.core.run.TransportColumns.PARTICLES
import daphnis.core.run.TransportColumns.TIME
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.max
import kotlin.math.sqrt

/**
 * Shear viscosity of a gas at rest, of smooth elastic spheres in a box that repeats along all axes, by Einstein's and
 * Helfand's formula (Helfand 1960, Phys. Rev. 119, 1): how fast the integral of the stress walks away.
 *
 * G_ab(t) = Σ Δp_a δ_b + ∫ M⟨c_a c_b⟩ dt is taken from the rows of a [TransportTable], by the trapezium rule, for the
 * five shears of space: xy, xz, yz, (xx − yy)/2 and (xx + yy − 2zz)/√12. The gas is at rest, so their means are 0, and
 * none is subtracted. Then 2 V kT η is the slope of ⟨(G(t + s) − G(t))²⟩ between the lags s = L/2 and L, on average over
 * the five and all t. What is correlated over times shorter than L/2 counts in full.
 *
 * **Lag.** L is ten mean free times of a particle, or twice the time in which one of thermal speed √(⟨c²⟩/3) crosses a
 * diameter, if that is longer. The stress that particles carry decays within some 1.3 mean free times. A longer lag adds
 * noise: the error grows as √L.
 *
 * **Error.** From blocks of time as long as L ([BlockAverage]), so there is none below 16 of them.
 *
 * Rows must be evenly spaced and at most half a mean free time apart: with longer spaces, and the trapezium rule, what
 * particles carry would seem to be correlated for longer than it is. At half a mean free time that part of η is 1.3 %
 * too large.
 *
 * @property average η, mass/(length · time)
 * @property lag L, in the run's unit of time
 */
public class HelfandViscosity private constructor(public val average: BlockAverage, public val lag: Double) {
    public companion object {
        /** L in mean free times. */
        private const val FREE_TIMES = 10.0

        /** L in times in which a sphere of thermal speed crosses its diameter. */
        private const val CROSSINGS = 2.0

        /** Most mean free times from row to row. */
        private const val WIDEST = 0.5
        private const val UNEVEN = 1e-6
        private const val FEWEST_BLOCKS = 2
        private val COMPONENTS = listOf("xx", "yy", "zz", "xy", "xz", "yz")

        /**
         * From all rows of [table]; null where these are too few, too far apart or not even, or without collisions. The
         * last row may be nearer: it is then left out.
         *
         * @param volume of the box
         * @param diameter mean of the spheres
         */
        @JvmStatic
        public fun of(table: TransportTable, volume: Double, diameter: Double): HelfandViscosity? {
            val rows = evenRows(table[TIME])
            if (rows < 2 || COMPONENTS.any { TransportColumns.moment(it) !in table }) return null
            val step = (table[TIME][rows - 1] - table[TIME][0]) / (rows - 1)
            val collisions = table[COLLISIONS][rows - 1] - table[COLLISIONS][0]
            val rate = 2 * collisions / table[PARTICLES][0] / (step * (rows - 1))
            val temperature = listOf("xx", "yy", "zz").sumOf { table[TransportColumns.moment(it)].average() } / 3
            if (!(rate > 0 && temperature > 0) || rate * step > WIDEST) return null
            val longest = max(FREE_TIMES / rate, CROSSINGS * diameter / sqrt(temperature))
            if (longest / step >= rows) return null
            val half = ceil(longest / step / 2).toInt()
            val thermal = table[MASS][0] / table[PARTICLES][0] * temperature
            val slopes = slopes(shears(table, rows, step), half) ?: return null
            val average = BlockAverage.of(slopes) * (1 / (2 * volume * thermal * half * step))
            return if (average.mean.isFinite()) HelfandViscosity(average, 2 * half * step) else null
        }

        /** How many rows from the first on are as far apart as the first two, if these are all, or all but the last. */
        private fun evenRows(time: DoubleArray): Int {
            if (time.size < 2) return 0
            val step = time[1] - time[0]
            val uneven = (1 until time.size).firstOrNull { abs(time[it] - time[it - 1] - step) > UNEVEN * step }
            return if (uneven == null) {
                time.size
            } else if (uneven == time.size - 1) {
                uneven
            } else {
                0
            }
        }

        /** G of the five shears at each of the [rows]. */
        private fun shears(table: TransportTable, rows: Int, step: Double): List<DoubleArray> {
            val (xx, yy, zz, xy, xz) = COMPONENTS.map { integral(table, it, rows, step) }
            val yz = integral(table, COMPONENTS.last(), rows, step)
            val across = DoubleArray(rows) { (xx[it] - yy[it]) / 2 }
            val upright = DoubleArray(rows) { (xx[it] + yy[it] - 2 * zz[it]) / sqrt(12.0) }
            return listOf(xy, xz, yz, across, upright)
        }

        private fun integral(table: TransportTable, component: String, rows: Int, step: Double): DoubleArray {
            val carried = table[TransportColumns.moment(component)]
            val jumped = table[TransportColumns.virial(component)]
            val mass = table[MASS]
            var sum = 0.0
            return DoubleArray(rows) {
                if (it > 0) sum += (mass[it] * carried[it] + mass[it - 1] * carried[it - 1]) / 2 * step
                jumped[it] - jumped[0] + sum
            }
        }

        /**
         * By block of time, the mean over the [walks] of the square over the lag 2[half] less the mean of those over its
         * two halves; null where there are too few blocks.
         */
        private fun slopes(walks: List<DoubleArray>, half: Int): DoubleArray? {
            val origins = walks[0].size - 2 * half
            val blocks = origins / (2 * half)
            if (blocks < FEWEST_BLOCKS) return null
            return DoubleArray(blocks) { b ->
                val begin = (origins.toLong() * b / blocks).toInt()
                val end = (origins.toLong() * (b + 1) / blocks).toInt()
                (begin until end).sumOf { i -> walks.sumOf { rise(it, i, half) } } / (walks.size * (end - begin))
            }
        }

        private fun rise(g: DoubleArray, from: Int, half: Int): Double {
            val first = g[from + half] - g[from]
            val second = g[from + 2 * half] - g[from + half]
            return (first + second) * (first + second) - (first * first + second * second) / 2
        }
    }
}
