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

    override val heading = "Profiles"
    override val over = "Averages in equal bins over ${study.averagedStates}. Bars are one standard error."
    override val leftOut = study.tooFew(LEAST)

    override fun write(page: ReportPage) {
        profile(
            page,
            "radial",
            measures.radial,
            measures.ofRadial,
            radialName,
            "optical_depth",
            "Optical depth across the patch.",
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
    private fun profile(page: ReportPage, name: String, profile: Profile, averages: Averages, label: String, drawn: String, caption: String) {
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

    private fun dispersions(page: ReportPage) {
        val first = Profile.COLUMNS.indexOf("c_xx")
        val scale = study.scale
        val curves = listOf("σ_x", "σ_y", "σ_z").mapIndexed { c, name ->
            val all = (0 until measures.radial.bins).map {
                measures.ofRadial.average(
                    it * Profile.COLUMNS.size + first + c,
                )
            }
            Curve(
                name,
                DoubleArray(all.size) { measures.radial.centre(it) },
                DoubleArray(all.size) { sqrt(all[it].mean) / scale.speed },
                DoubleArray(all.size) { all[it].error / (2 * sqrt(all[it].mean)) / scale.speed },
            )
        }
        val figure = Chart.lines(
            curves,
            study.lengthAxis(radialName),
            UnitNames.axis("velocity dispersion", scale.speedName),
        )
        study.draw(
            page,
            figure,
            "radial-dispersion",
            "velocity dispersions across the patch",
            "Velocity dispersions across the patch, around the mean flow of each bin.",
        )
    }

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
