package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.SeriesPlots
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.core.run.SeriesColumns
import daphnis.core.run.TransportColumns
import kotlin.math.sqrt

/**
 * How the run went over time: from `series.csv` temperature, collision rate and energy, from `transport.csv` the
 * velocity dispersions, and with self-gravity what [GravityEvolution] shows.
 */
internal class EvolutionSection(private val study: Study) : Section {
    private val input = study.input
    private val series = input.series?.takeIf { it.size >= 2 }
    private val transport = input.transport?.takeIf { it.size >= 2 }
    private val scale = study.scale

    /** First and last time of the whole run, of which series may tell more than states. */
    private val ends = listOfNotNull(
        input.times,
        series?.get(SeriesColumns.TIME),
        transport?.get(TransportColumns.TIME),
    )
        .let { all -> listOf(all.minOf { it.first() }, all.maxOf { it.last() }) }

    /** Where averages begin, when that is within the run. */
    private val mark = study.from.takeIf { it > ends[0] && !study.isGrowing }

    /** What every chart shows, so that they can be compared. */
    private val across = ends.map { it / scale.time }

    override val heading = "Evolution"
    private val averaged = if (study.isGrowing) {
        "nothing is averaged over it."
    } else {
        mark?.let { "the dashed line is where averages begin, time ${study.time(it)}." }
            ?: "averages are over all of it."
    }
    override val over: String = "The whole run; $averaged"
    override val leftOut: String? = when {
        series != null || transport != null -> null
        input.directory == null -> "a file of states has no time series"
        else -> "the run has written no time series of two rows; see output.seriesEvery"
    }

    override fun write(page: ReportPage) {
        if (series != null) series(page, SeriesPlots(series, scale, mark, across))
        if (study.isGrowing) Growth.write(page, study)
        if (transport == null) return
        dispersions(page)
        val constant = study.bulk.selfGravity ?: return
        val orbits = input.frequencies ?: return
        GravityEvolution(study, transport, orbits, mark?.let { it / scale.time }, across).write(page, constant)
    }

    private fun series(page: ReportPage, plots: SeriesPlots) {
        val temperatures = listOfNotNull(plots.temperature(), plots.rotationalTemperature())
        val rate = plots.collisionRate()
        val energies = plots.energies()
        if (temperatures.isNotEmpty()) {
            val haff = CoolingReferences.line(study, temperatures[0])
            val ofSpins = if (temperatures.size ==
                1
            ) {
                ""
            } else {
                ", and that of rotation, Σ I ω²/3M, in which the mean spin is"
            }
            study.draw(
                page,
                plots.temperaturePlot(temperatures + listOfNotNull(haff)),
                "temperature",
                "granular temperature over time",
                "Granular temperature$ofSpins" + if (haff == null) {
                    "."
                } else {
                    "; Haff's law begins at the first row, with the rate of Enskog (Garzó & Dufty 1999)."
                },
                SeriesPlots.HEIGHT,
            )
        }
        if (rate != null) {
            study.draw(
                page,
                plots.ratePlot(rate),
                "collision-rate",
                "collisions per particle over time",
                "Collisions per particle.",
                SeriesPlots.HEIGHT,
            )
        }
        if (energies.isNotEmpty()) {
            val ofRing =
                " The kinetic energy is of all motion in the rotating frame, mostly the shear of the orbits; " +
                    "Hill's is the sum of kinetic, rotational, tidal and potential energy."
            val shear = if (study.isRing) ofRing else ""
            study.draw(
                page,
                plots.energyPlot(energies),
                "energy",
                "energy over time",
                "Energy of all ${study.bodies}.$shear",
                SeriesPlots.HEIGHT,
            )
        }
        val ofTemperature = temperatures.map { it to scale.temperatureName }
        table("time-series", ofTemperature + energies.map { it to study.units.energy })
        table("collision-rate", listOfNotNull(rate).map { it to scale.rateName })
    }

    /** Curves over one time, with their units. */
    private fun table(name: String, curves: List<Pair<Curve, String>>) {
        if (curves.isEmpty()) return
        val time = Column("time", scale.timeName, curves[0].first.x)
        val columns = curves.map { (curve, unit) -> Column(curve.name.replace(' ', '_'), unit, curve.y) }
        Table(name, listOf(time) + columns).write(study.tables)
    }

    private fun dispersions(page: ReportPage) {
        val t = transport!!
        val time = DoubleArray(t.size) { t[TransportColumns.TIME][it] / scale.time }
        val names = listOf("xx" to "σ_x", "yy" to "σ_y", "zz" to "σ_z").take(study.last.dimensions)
        val sigma = names.map { (component, _) ->
            val moment = t[TransportColumns.moment(component)]
            DoubleArray(t.size) { sqrt(moment[it]) / scale.speed }
        }
        val curves = names.indices.map { Curve(names[it].second, thinned(time), thinned(sigma[it])) }
        val plot = Chart.lines(
            curves,
            UnitNames.axis("time", scale.timeName),
            UnitNames.axis("velocity dispersion", scale.speedName),
            vertical = mark?.let { it / scale.time },
            across = across,
        )
        study.draw(
            page,
            plot,
            "dispersion",
            "velocity dispersions over time",
            "Velocity dispersions, from transport.csv.",
        )
        val columns = names.indices.map { Column("sigma_${names[it].first}", scale.speedName, sigma[it]) }
        Table("evolution", listOf(Column("time", scale.timeName, time)) + columns).write(study.tables)
    }

    private fun thinned(x: DoubleArray): DoubleArray {
        val stride = maxOf(1, x.size / MOST_POINTS)
        return x.filterIndexed { k, _ -> k % stride == 0 }.toDoubleArray()
    }

    private companion object {
        const val MOST_POINTS = 800
    }
}
