package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.profile.DispersionBySize
import daphnis.analysis.profile.RotationByGroup
import daphnis.analysis.profile.SpinDistribution
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames

/** How rough particles spin: the distribution beside a Maxwellian, and what each size does. */
internal class SpinSection(private val study: Study) : Section {
    private val space = study.last.boundary.space
    private val perAxis = if (space.isPlane) "" else "/${space.rotations}"
    private val units = study.units
    private val distribution = SpinDistribution()
    private val shape = Averages(distribution)
    private val sizes = SizeGroups.of(study.last)
    private val spins = study.motion.rotation?.let { r -> sizes?.let { Averages(RotationByGroup(it, r.momentFactor)) } }
    private val motions = sizes?.let { Averages(DispersionBySize(it)) }

    override val heading = "Spins"
    override val over: String get() {
        val frame = if (study.isRing) "Relative to the rotating frame. " else ""
        return "$frame${study.overAverages} ${study.judgement.bars()}"
    }
    override val applies = study.motion.rotation != null
    override val leftOut get() = study.tooFew()
        ?: if (shape.average(0).mean.isNaN()) "all particles spin alike" else null

    override fun add(state: State) {
        shape.add(state)
        spins?.add(state)
        motions?.add(state)
    }

    override fun write(page: ReportPage) {
        distribution(page)
        if (sizes != null && spins != null && motions != null) bySize(page, sizes.count, spins, motions)
    }

    private fun distribution(page: ReportPage) {
        val bins = distribution.bins
        val component = DoubleArray(bins) { distribution.component(it) }
        val modulus = DoubleArray(bins) { distribution.modulus(it) }
        fun curve(name: String, which: Int) = (0 until bins).map { shape.average(which * bins + it) }.let { all ->
            val x = if (which < 3) component else modulus
            Curve(name, x, means(all), DoubleArray(bins) { study.judgement.error(all[it]) })
        }
        val axes = (3 - space.rotations until 3).map { curve("s_${"xyz"[it]}", it) }
        val whole = curve("s", 3)
        val gauss = Curve(MAXWELLIAN, component, DoubleArray(bins) { SpinDistribution.ofComponent(component[it]) })
        val maxwell = Curve(MAXWELLIAN, modulus, DoubleArray(bins) { SpinDistribution.ofModulus(modulus[it]) })
        val words = "s = √(I/T) (ω − ⟨ω⟩), T = ⟨I (ω − ⟨ω⟩)²⟩$perAxis of the same state"
        val figure = Chart.lines(axes + gauss, "component of s", "density")
        val caption = "Components of the spins beside a Maxwellian; $words."
        study.draw(page, figure, "spin-components", "distribution of the components of spins", caption)
        if (!space.isPlane) modulus(page, whole, maxwell)
        val columns = (axes + whole).flatMap {
            listOf(Column(it.name, "", it.y), Column("${it.name}_error", "", it.error!!))
        }
        Table(
            "spin-distribution",
            listOf(Column("component", "", component)) + columns.dropLast(2) + Column("maxwellian", "", gauss.y) +
                if (space.isPlane) {
                    emptyList()
                } else {
                    listOf(Column("modulus", "", modulus)) + columns.takeLast(2) +
                        Column("maxwellian_modulus", "", maxwell.y)
                },
        ).write(study.tables)
    }

    private fun modulus(page: ReportPage, whole: Curve, maxwell: Curve) {
        val ofModulus = Chart.lines(listOf(whole, maxwell), "modulus s", "density")
        study.draw(page, ofModulus, "spin-modulus", "distribution of the modulus of spins", "The modulus of the same.")
    }

    private fun bySize(page: ReportPage, count: Int, spins: Averages, motions: Averages) {
        fun spin(group: Int, column: String) =
            spins.average(group * RotationByGroup.COLUMNS.size + RotationByGroup.COLUMNS.indexOf(column))
        fun motion(group: Int, column: String) =
            motions.average(group * DispersionBySize.COLUMNS.size + DispersionBySize.COLUMNS.indexOf(column))
        val filled = (0 until count).filter { !spin(it, "w2").mean.isNaN() && !motion(it, "temperature").mean.isNaN() }
        if (filled.isEmpty()) return
        val radius = means(filled.map { spin(it, "mean_radius") })
        fun curve(name: String, all: List<BlockAverage>) =
            Curve(name, radius, means(all), DoubleArray(all.size) { study.judgement.error(all[it]) })
        val rms = curve("rms spin", filled.map { spin(it, "w2").root() })
        val translational = curve("translational", filled.map { motion(it, "temperature") })
        val rotational = curve("rotational", filled.map { spin(it, "temperature") })
        val one = study.scale.spin
        val level = rms.y[0] * radius[0]
        val shown = Curve("rms spin", radius, scaled(rms.y, one), scaled(rms.error!!, one))
        val inverse = Curve("∝ 1/r", radius, DoubleArray(radius.size) { level / radius[it] / one })
        val axis = study.lengthAxis("radius")
        val figure = Chart.lines(
            listOf(shown, inverse),
            axis,
            UnitNames.axis("rms spin", study.scale.spinName),
            logX = true,
            logY = true,
        )
        study.draw(page, figure, "spin-by-size", "rms spin by size", "√⟨ω²⟩ of particles by size, the mean spin in it.")
        val temperatures = listOf(translational, rotational)
        val log = Chart.isWide(temperatures.flatMap { it.y.asList() })
        val label = UnitNames.axis("partial temperature", units.energy)
        val both = Chart.lines(temperatures, axis, label, logX = true, logY = log)
        val which = "m⟨c²⟩/${space.dimensions} and I⟨ω²⟩$perAxis"
        val caption = "Partial temperatures $which of particles by size, energies; c as under Sizes."
        study.draw(page, both, "temperature-by-size", "partial temperatures by size", caption)
        val columns = listOf(
            Column("count", "", means(filled.map { spin(it, "count") })),
            Column("mean_radius", units.length, radius),
        )
        val means = listOf("x", "y", "z").map { name ->
            curve("mean_spin_$name", filled.map { spin(it, "mean_w$name") })
        }
        val named = listOf(
            "rms_spin" to rms,
            "translational_temperature" to translational,
            "rotational_temperature" to rotational,
        ) + means.map { it.name to it }
        val further = named.flatMap { (name, c) ->
            val dimension = if ("temperature" in name) units.energy else units.rate
            listOf(Column(name, dimension, c.y), Column("${name}_error", dimension, c.error!!))
        }
        Table("spins-by-size", columns + further).write(study.tables)
    }

    private fun means(all: List<BlockAverage>) = DoubleArray(all.size) { all[it].mean }

    private fun scaled(values: DoubleArray, one: Double) = DoubleArray(values.size) { values[it] / one }

    private companion object {
        const val MAXWELLIAN = "Maxwellian"
    }
}
