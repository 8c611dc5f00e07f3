package daphnis.analysis.plot

import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.core.run.SeriesColumns
import daphnis.core.run.SeriesColumns.POTENTIAL_ENERGY
import daphnis.core.run.SeriesColumns.TIME
import daphnis.core.table.Column
import daphnis.core.table.Dimension

/**
 * What a run's time series shows, as curves and as plots; axes are logarithmic where the values spread over much, and
 * say so. A quantity whose column the file lacks, or that has fewer than two values, has no curve.
 *
 * @param from a time that is marked, where averages begin; null for none
 * @param across times that every plot shows too, in [PlotScale.time]
 */
internal class SeriesPlots(
    private val series: SeriesTable,
    private val scale: PlotScale,
    private val from: Double? = null,
    private val across: List<Double> = emptyList(),
) {
    private val rows = thinned()
    private val time = DoubleArray(rows.size) { series[TIME][rows[it]] / scale.time }
    private val timeLabel = UnitNames.axis("time", scale.timeName)

    /** Granular temperature in [PlotScale.temperatureName]. */
    fun temperature(): Curve? =
        column(SeriesColumns.GRANULAR_TEMPERATURE, "granular temperature", scale.speed * scale.speed)

    /** Rotational temperature in [PlotScale.temperatureName], where spheres spin. */
    fun rotationalTemperature(): Curve? =
        column(SeriesColumns.ROTATIONAL_TEMPERATURE, "rotational temperature", scale.speed * scale.speed)

    /** Every column that is an energy, in the scenario's units, by its name. */
    fun energies(): List<Curve> {
        val all = SeriesColumns.columns.filter { it.dimension == Dimension.ENERGY && it in series }
        // Without forces the total is the kinetic energy.
        val isFree = POTENTIAL_ENERGY in series && series[POTENTIAL_ENERGY].all { it == 0.0 }
        val told = if (isFree) all - POTENTIAL_ENERGY - SeriesColumns.TOTAL_ENERGY else all
        return told.mapNotNull { column(it, spoken(it), 1.0) }
    }

    private fun spoken(energy: Column) = energy.name.removeSuffix("_energy").replace("hill", "Hill's").replace('_', ' ')

    /**
     * Collisions per particle in a unit of time, between rows so far apart that the noise of single steps does not
     * hide it.
     */
    fun collisionRate(): Curve? {
        val stride = maxOf(1, rows.size / MOST_BINS)
        val n = series[SeriesColumns.PARTICLES]
        val collisions = series[SeriesColumns.COLLISIONS]
        val t = series[TIME]
        val apart = rows.filterIndexed { k, _ -> k % stride == 0 }.zipWithNext()
        val pairs = apart.filter { (a, b) -> t[b] > t[a] && n[b] > 0 }
        if (pairs.isEmpty()) return null
        val middle = pairs.map { (a, b) -> (t[a] + t[b]) / 2 / scale.time }
        // Every collision is one of each of its two spheres.
        val rate = pairs.map { (a, b) -> 2 * (collisions[b] - collisions[a]) / n[b] / (t[b] - t[a]) * scale.time }
        return Curve("collisions", middle.toDoubleArray(), rate.toDoubleArray())
    }

    fun temperaturePlot(curves: List<Curve>): Figure =
        plot(curves, if (curves.size == 1) TEMPERATURE else "temperature", scale.temperatureName)

    fun ratePlot(curve: Curve): Figure = plot(listOf(curve), RATE, scale.rateName)

    fun energyPlot(curves: List<Curve>): Figure {
        val quantity = if (curves.size == 1) "${curves[0].name} energy" else "energy"
        return plot(curves, quantity, scale.units.energy)
    }

    private fun plot(curves: List<Curve>, quantity: String, unit: String): Figure {
        // Spins that begin at rest would be the one point for which an axis is not logarithmic.
        val spinning = curves.filter { "rotational" in it.name }
        val log = Chart.isWide(curves.flatMap { c -> if (c in spinning) c.y.filter { it != 0.0 } else c.y.asList() })
        return Chart.lines(
            curves,
            timeLabel,
            UnitNames.axis(quantity, unit),
            logY = log,
            vertical = from?.let { it / scale.time },
            across = across,
        )
    }

    private fun column(column: Column, shown: String, unit: Double): Curve? {
        if (column !in series) return null
        val values = series[column]
        val drawn = DoubleArray(rows.size) { values[rows[it]] / unit }
        return if (drawn.count { it.isFinite() } >= 2) Curve(shown, time, drawn) else null
    }

    /** More points than pixels only cost: every k-th, and the last. */
    private fun thinned(): List<Int> {
        val stride = maxOf(1, series.size / MOST_POINTS)
        return (0 until series.size).filter { it % stride == 0 || it == series.size - 1 }
    }

    companion object {
        const val TEMPERATURE = "granular temperature"
        const val RATE = "collisions per particle"

        /** Of a plot, which is of one quantity. */
        const val HEIGHT = 280
        private const val MOST_POINTS = 2000
        private const val MOST_BINS = 150
    }
}
