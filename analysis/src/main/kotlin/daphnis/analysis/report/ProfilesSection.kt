package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.profile.Profile
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import kotlin.math.sqrt

/** Profiles across the patch, along it and over height; all columns in `tables/profile-*.csv`. */
internal class ProfilesSection(private val study: Study) : Section {
    private val measures = study.measures
    private val units = study.units
    private val radialName = if (study.isRing) "radial position x" else "x"

    private val isAcrossY = study.last.boundary.meanFlow?.normalAxis == 1
    private val across = if (isAcrossY) measures.azimuthal else measures.radial
    private val acrossAverages = if (isAcrossY) measures.ofAzimuthal else measures.ofRadial
    private val acrossAxis = study.lengthAxis(if (isAcrossY) "y" else radialName)

    override val heading = "Profiles"
    override val over = "Averages in equal bins over ${study.averagedStates}. Bars are one standard error; bins " +
        "that are filled in fewer than 16 states have none."
    override val leftOut = study.tooFew(LEAST)

    override fun write(page: ReportPage) {
        profile(
            page,
            "radial",
            measures.radial,
            measures.ofRadial,
            radialName,
            if (measures.isSlab) "optical_depth" else "filling_factor",
            if (measures.isSlab) "Optical depth across the patch." else "Filling factor along x.",
        )
        profile(page, "azimuthal", measures.azimuthal, measures.ofAzimuthal, "", "", "")
        profile(
            page,
            "vertical",
            measures.vertical,
            measures.ofVertical,
            "height z",
            "filling_factor",
            "Filling factor over height.",
        )
        dispersions(page)
    }

    /** Writes the table of a profile and draws the column [drawn] of it, unless that is empty. */
    private fun profile(
        page: ReportPage,
        name: String,
        profile: Profile,
        averages: Averages,
        label: String,
        drawn: String,
        caption: String,
    ) {
        val x = DoubleArray(profile.bins) { profile.centre(it) }
        val columns = ArrayList<Column>()
        columns += Column("centre", units.length, x)
        for ((c, column) in Profile.COLUMNS.withIndex()) {
            val all = x.indices.map { averages.average(it * Profile.COLUMNS.size + c) }
            val y = DoubleArray(x.size) { all[it].mean }
            val error = DoubleArray(x.size) { all[it].error }
            val unit = unitOf(column, profile.axis)
            columns += Column(column, unit, y)
            columns += Column("${column}_error", unit, error)
            if (column != drawn) continue
            val quantity = column.replace('_', ' ')
            val figure = Chart.lines(
                listOf(Curve(quantity, x, y, error)),
                study.lengthAxis(label),
                UnitNames.axis(quantity, unit),
            )
            study.draw(page, figure, "$name-${column.replace('_', '-')}", "$quantity over $label", caption)
        }
        Table("profile-$name", columns).write(study.tables)
    }

    /** Across the flow: along x in Hill's frame, along y in a sheared box. */
    private fun dispersions(page: ReportPage) {
        val first = Profile.COLUMNS.indexOf("c_xx")
        val scale = study.scale
        val curves = listOf("σ_x", "σ_y", "σ_z").mapIndexed { c, name ->
            val all = column(first + c)
            Curve(
                name,
                DoubleArray(all.size) { across.centre(it) },
                DoubleArray(all.size) { sqrt(all[it].mean) / scale.speed },
                DoubleArray(all.size) { all[it].error / (2 * sqrt(all[it].mean)) / scale.speed },
            )
        }
        val label = UnitNames.axis("velocity dispersion", scale.speedName)
        val where = if (isAcrossY) "across the flow" else "across the patch"
        val said = "velocity dispersions $where"
        val caption = "Velocity dispersions $where, around the mean of each bin, by number."
        study.draw(page, Chart.lines(curves, acrossAxis, label), "radial-dispersion", said, caption)
        if (isAcrossY) meanFlow(page)
    }

    /** The flow of a sheared box as it is, beside the straight line that the boundary drives. */
    private fun meanFlow(page: ReportPage) {
        val rate = study.last.boundary.meanFlow?.rate ?: return
        val rest = column(Profile.COLUMNS.indexOf("mean_vx"))
        val y = DoubleArray(rest.size) { across.centre(it) }
        val driven = DoubleArray(rest.size) { rate * y[it] }
        val measured = DoubleArray(rest.size) { driven[it] + rest[it].mean }
        val curves = listOf(
            Curve("measured", y, measured, DoubleArray(rest.size) { rest[it].error }),
            Curve("straight", y, driven),
        )
        val figure = Chart.lines(curves, acrossAxis, UnitNames.axis("mean velocity u_x", units.speed))
        val caption = "Mean velocity along x over y, beside the straight line that the boundary drives."
        study.draw(page, figure, "flow-profile", "mean velocity across the flow", caption)
    }

    private fun column(c: Int) = (0 until across.bins).map { acrossAverages.average(it * Profile.COLUMNS.size + c) }

    private fun unitOf(column: String, axis: Int): String = when {
        column == "surface_density" && axis == 2 -> units.density
        column == "surface_density" -> units.surfaceDensity
        column.startsWith("mean_v") -> units.speed
        column.startsWith("c_") -> units.temperature
        else -> ""
    }

    companion object {
        /** Particles below which averages over them mean nothing. */
        const val LEAST = 10
    }
}
