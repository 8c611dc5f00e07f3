package daphnis.analysis.report

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.MaterialGroups
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.profile.DispersionBySize
import daphnis.analysis.profile.RotationByGroup
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.core.run.SeriesColumns

/**
 * What particles of each material do, where there is more than one: their partial temperatures, how these compare, and
 * who is beside whom. Materials of bodies alone are left out.
 */
internal class MaterialSection(private val study: Study) : Section {
    private val units = study.units
    private val groups = MaterialGroups.of(study.last)
    private val names = study.last.population.materials

    /** Numbers of the materials of particles. */
    private val there: List<Int> = names.indices.filter { number ->
        (0 until study.last.population.size).any {
            study.last.isParticle(it) && groups!!.of(study.last, it) == number
        }
    }
    private val pairs = if (there.size > 1 && there.size <= MOST && !study.isRoomCut) correlation() else null
    private val besides = pairs?.let { Averages(it) }
    private val motions = groups?.let { Averages(DispersionBySize(it)) }
    private val ratios = groups?.let { Averages(ratios(DispersionBySize(it))) }
    private val spins = study.motion.rotation?.let { r ->
        groups?.let { Averages(RotationByGroup(it, r.momentFactor)) }
    }
    private val series = study.input.series?.takeIf { s -> there.all { SeriesColumns.temperatureOf(names[it]) in s } }
    private val rows = series?.let { s ->
        s[SeriesColumns.TIME].indices.filter { s[SeriesColumns.TIME][it] >= study.from }
    }
        ?.takeIf { it.size >= 2 }

    override val heading = "Materials"
    override val over get() =
        "Particles by material, around the mean flow and the centre of mass of all. ${study.overAverages} " +
            study.judgement.bars()
    override val applies = there.size > 1 && study.input.hasVelocities
    override val leftOut get() = study.tooFew()

    private fun correlation(): PairCorrelation {
        val room = study.boxes.boundaries.minOf { PairCorrelation.farthest(it) }
        return PairCorrelation(minOf(room, RADII * 2 * study.bulk.typicalRadius), BINS, 0.0, groups!!)
    }

    /** The temperature of the first material over each in the same state. */
    private fun ratios(motion: DispersionBySize) = Measure { state ->
        val all = motion.of(state)
        fun temperature(k: Int) = all[k * DispersionBySize.COLUMNS.size + TEMPERATURE]
        DoubleArray(names.size) { temperature(there[0]) / temperature(it) }
    }

    override fun add(state: State) {
        motions?.add(state)
        ratios?.add(state)
        spins?.add(state)
        besides?.add(state)
    }

    /** From the rows of series.csv where there are any, else from the states. */
    private fun temperature(k: Int): BlockAverage = rows?.let { r ->
        val all = series!![SeriesColumns.temperatureOf(names[k])]
        BlockAverage.of(DoubleArray(r.size) { all[r[it]] })
    } ?: motion(k, "temperature")

    private fun ratio(k: Int): BlockAverage = rows?.let { r ->
        val all = series!![SeriesColumns.temperatureOf(names[k])]
        val first = series[SeriesColumns.temperatureOf(names[there[0]])]
        BlockAverage.of(DoubleArray(r.size) { first[r[it]] / all[r[it]] })
    } ?: ratios!!.average(k)

    override fun numbers(): List<NumberRow> {
        val rows = NumberRows()
        val first = names[there[0]]
        for (k in there) {
            val name = "partial temperature of ${names[k]}"
            rows.average(
                "partial_temperature_${names[k]}",
                name,
                temperature(k),
                units.energy,
                "m ⟨c²⟩/${study.last.dimensions}, an energy",
            )
        }
        for (k in there.drop(1)) {
            val key = "temperature_ratio_${first}_${names[k]}"
            rows.average(
                key,
                "temperature of $first over that of ${names[k]}",
                ratio(k),
                "",
                "mean of the ratio at each time",
            )
        }
        return rows.list()
    }

    override fun write(page: ReportPage) {
        table()
        val pairs = pairs ?: return
        val x = DoubleArray(pairs.bins) { pairs.centre(it) }
        val curves = ArrayList<Curve>()
        val columns = arrayListOf(Column("r", units.length, x))
        for ((i, a) in there.withIndex()) {
            for (b in there.drop(i)) {
                val all = List(pairs.bins) { besides!!.average(pairs.first(a, b) + it) }
                if (all.all { it.mean.isNaN() }) continue
                val label = "${names[a]}-${names[b]}"
                val mean = DoubleArray(all.size) { all[it].mean }
                val error = DoubleArray(all.size) { study.judgement.error(all[it]) }
                curves += Curve(label, x, mean)
                columns += listOf(Column("g_$label", "", mean), Column("g_${label}_error", "", error))
            }
        }
        if (curves.isEmpty()) return
        Table("pair-correlation-by-material", columns).write(study.tables)
        val inPlane = PairCorrelation.isInPlane(study.last.boundary)
        val argument = if (inPlane) "distance in the plane" else "distance r"
        val figure = Chart.lines(curves, study.lengthAxis(argument), "pair correlation g")
        val caption = "Pairs of each two materials at a distance, over those of particles without correlation."
        study.draw(page, figure, "pair-correlation-by-material", "pair correlation by material", caption)
    }

    private fun table() {
        val columns = arrayListOf(
            Column("material", "", DoubleArray(there.size) { there[it].toDouble() }),
            column("count", "") { motion(it, "count") }[0],
            column("mean_radius", units.length) { motion(it, "mean_radius") }[0],
        )
        columns += column("temperature", units.energy) { temperature(it) }
        if (spins != null) {
            columns += column("rotational_temperature", units.energy) { spin(it, "temperature") }
            for (axis in "xyz") columns += column("mean_spin_$axis", units.rate) { spin(it, "mean_w$axis") }
        }
        Table("materials", columns).write(study.tables)
    }

    private fun column(name: String, unit: String, value: (Int) -> BlockAverage): List<Column> {
        val all = there.map(value)
        return listOf(
            Column(name, unit, DoubleArray(all.size) { all[it].mean }),
            Column("${name}_error", unit, DoubleArray(all.size) { study.judgement.error(all[it]) }),
        )
    }

    private fun motion(k: Int, column: String): BlockAverage =
        motions!!.average(k * DispersionBySize.COLUMNS.size + DispersionBySize.COLUMNS.indexOf(column))

    private fun spin(k: Int, column: String): BlockAverage =
        spins!!.average(k * RotationByGroup.COLUMNS.size + RotationByGroup.COLUMNS.indexOf(column))

    private companion object {
        /** Materials up to which each pair has a curve. */
        const val MOST = 3
        const val RADII = 8.0
        const val BINS = 80
        val TEMPERATURE = DispersionBySize.COLUMNS.indexOf("temperature")
    }
}
