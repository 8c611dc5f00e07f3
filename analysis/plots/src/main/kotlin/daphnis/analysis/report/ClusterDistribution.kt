package daphnis.analysis.report

import daphnis.analysis.neighbour.ClusterSizes
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * How many clusters of each size there are in a state.
 *
 * @param mean by bin of [ClusterSizes], over the averaged states, and its standard [error]
 * @param last in the last state
 */
internal class ClusterDistribution(
    private val mean: DoubleArray,
    private val error: DoubleArray,
    private val last: List<Double>,
) {
    /** Up to the last in which there is a cluster. */
    private val bins = (mean.indices.lastOrNull { mean[it] > 0 || last[it] > 0 } ?: 0) + 1

    /** Whether all spheres are in clusters that span the box. */
    val isEmpty: Boolean = mean.all { it == 0.0 } && last.all { it == 0.0 }

    private fun width(k: Int) = (ClusterSizes.highest(k).toDouble() - ClusterSizes.lowest(k) + 1)

    private fun of(value: (Int) -> Double) = DoubleArray(bins, value)

    fun table(): Table = Table(
        "cluster-sizes",
        listOf(
            Column("size_from", "", of { ClusterSizes.lowest(it).toDouble() }),
            Column("size_to", "", of { ClusterSizes.highest(it).toDouble() }),
            Column("clusters", "", of { mean[it] }),
            Column("clusters_error", "", of { error(it) }),
            Column("clusters_last", "", of { last[it] }),
        ),
    )

    /** Of what is never there no error is known. */
    private fun error(k: Int) = if (mean[k] > 0) error[k] else Double.NaN

    /** Per size, with the line of a [slope] from the size [least] on that has as many clusters. */
    fun curves(slope: Double, least: Int): List<Curve> {
        val middle = of { sqrt(ClusterSizes.lowest(it).toDouble() * ClusterSizes.highest(it)) }
        val curves = arrayListOf(
            Curve("averaged states", middle, of { mean[it] / width(it) }, of { error(it) / width(it) }),
            Curve("last state", middle, of { last[it] / width(it) }),
        )
        val from = ClusterSizes.binOf(least)
        if (slope.isNaN() || from >= bins) return curves
        val clusters = (from until bins).sumOf { mean[it] }
        val shape = (from until bins).sumOf { middle[it].pow(-slope) * width(it) }
        curves += Curve(
            "power law",
            middle,
            of { if (it < from) Double.NaN else clusters / shape * middle[it].pow(-slope) },
        )
        return curves
    }
}
