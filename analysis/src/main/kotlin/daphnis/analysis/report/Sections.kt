package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.PatchState
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.plot.PatchPicture
import daphnis.analysis.profile.Profile
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/** The sections of a report, each with its table and plots. */
internal class Sections(
    private val input: AnalysisInput,
    private val measures: Measures,
    private val numbers: Numbers,
    directory: Path,
    private val options: AnalysisOptions,
) {
    private val plots = directory.resolve("plots")
    private val tables = directory.resolve("tables")
    private val units = input.units
    private val structure = StructureSections(input, measures, numbers, plots, tables)

    fun write(page: ReportPage, last: PatchState, from: Double, states: Int) {
        val diffusion = DiffusionSection(input, from, numbers.meanRadius)
        numbers(page, from, states, diffusion.rows())
        pictures(page, last)
        if (input.omega != null) StreamlineSection(input, plots, tables, options).write(page, last)
        evolution(page)
        profiles(page)
        ellipsoid(page)
        if (measures.sizes != null && measures.ofSizes != null) SizeClassSection(input, measures.sizes.classes, measures.ofSizes).write(page, plots, tables)
        diffusion.write(page, plots, tables)
        if (measures.isCompact) {
            if (input.omega == null && last.boundary.meanFlow != null) flow(page)
            structure.correlations(page)
        }
        if (measures.isSlab) structure.occultation(page)
        structure.impacts(page)
        reproduce(page, last)
    }

    private fun numbers(page: ReportPage, from: Double, states: Int, further: List<NumberRow>) {
        page.section("Numbers")
        val rows = numbers.rows() + further
        val origin = if (input.transport !=
            null
        ) {
            "the rows of transport.csv from time ${ReportText.short(from)} ${units.time}${orbits(from)} on, and $states snapshots"
        } else {
            "$states snapshots"
        }
        page.paragraph("Averages over $origin. ± is one standard error from block averaging; numbers without it follow from the particles themselves.")
        for (line in numbers.steadiness()) page.paragraph(line)
        page.numbers(rows)
        Files.createDirectories(tables)
        val lines = rows.map {
            "${it.what.replace(',', ';')},${it.value},${if (it.error.isNaN()) "" else it.error},${it.unit},${it.reference?.value ?: ""}," +
                if (it.isUncertain) "too few independent states" else ""
        }
        Files.write(tables.resolve("numbers.csv"), listOf("quantity,value,standard_error,unit,reference,remark") + lines)
    }

    private fun snapshots(n: Int) = if (n == 1) "one snapshot" else "$n snapshots"

    private fun orbits(time: Double) = input.omega?.let { " (${ReportText.short(time * it / (2 * PI))} orbits)" }.orEmpty()

    private fun pictures(page: ReportPage, last: PatchState) {
        page.section("The patch")
        val picture = PatchPicture(last, units.length)
        val part = if (last.boundary.box.length(1) > 4 * last.boundary.box.length(0)) " The first part of its length." else ""
        val axes = if (input.omega != null) "orbital motion to the right, outward up" else "y to the right, x up"
        page.png(picture.writeAbove(plots, "patch-above"), "the patch from above", "From above at the end, to scale; $axes; higher spheres are brighter.$part")
        page.png(picture.writeSide(plots, "patch-side"), "the patch from the side", "From the side, to scale; nearer spheres are brighter.$part")
    }

    private fun evolution(page: ReportPage) {
        val t = input.transport ?: return
        if (t.size < 2) return
        page.section("Evolution")
        val omega = input.omega
        val unit = if (omega != null) 2 * PI / omega else 1.0
        val time = DoubleArray(t.size) { t["time"][it] / unit }
        val scale = if (omega != null) numbers.meanRadius * omega else 1.0
        fun thin(x: DoubleArray) = x.filterIndexed { k, _ -> k % maxOf(1, x.size / MOST_POINTS) == 0 }.toDoubleArray()
        val names = listOf("xx" to "σ_x", "yy" to "σ_y", "zz" to "σ_z")
        val curves = names.map { (component, name) -> Curve(name, thin(time), thin(DoubleArray(t.size) { sqrt(t["c_$component"][it]) / scale })) }
        val xLabel = if (omega != null) "time [orbits]" else "time [${units.time}]"
        val speed = if (omega != null) "r Ω" else units.speed
        page.svg(
            Figures.write(Chart.lines(curves, xLabel, "velocity dispersion [$speed]"), plots, "dispersion", Chart.WIDTH, Chart.HEIGHT),
            "velocity dispersions over time",
            "Velocity dispersions over time; steady where they no longer drift.",
        )
        Table(
            "evolution",
            listOf(Column("time", if (omega != null) "orbits" else units.time, time)) +
                names.map { (c, _) -> Column("sigma_$c", speed, DoubleArray(t.size) { sqrt(t["c_$c"][it]) / scale }) },
        )
            .write(tables)
    }

    private fun profiles(page: ReportPage) {
        page.section("Profiles")
        val radialName = if (input.omega != null) "radial position x" else "x"
        profile(page, "radial", measures.radial, measures.ofRadial, radialName, listOf("optical_depth" to "optical depth"), "Optical depth across the patch.")
        profile(page, "azimuthal", measures.azimuthal, measures.ofAzimuthal, if (input.omega != null) "azimuth y" else "y", emptyList(), "")
        profile(page, "vertical", measures.vertical, measures.ofVertical, "height z", listOf("filling_factor" to "filling factor"), "Filling factor over height.")
        val flow = Profile.COLUMNS.indexOf("c_xx")
        val curves = listOf("σ_x", "σ_y", "σ_z").mapIndexed { c, name ->
            val all = (0 until measures.radial.bins).map { measures.ofRadial.average(it * Profile.COLUMNS.size + flow + c) }
            Curve(
                name,
                DoubleArray(all.size) { measures.radial.centre(it) },
                DoubleArray(all.size) { sqrt(all[it].mean) },
                DoubleArray(all.size) { all[it].error / (2 * sqrt(all[it].mean)) },
            )
        }
        page.svg(
            Figures.write(
                Chart.lines(curves, "$radialName [${units.length}]", "velocity dispersion [${units.speed}]"),
                plots,
                "radial-dispersion",
                Chart.WIDTH,
                Chart.HEIGHT,
            ),
            "velocity dispersions across the patch",
            "Velocity dispersions across the patch, around the mean flow of each bin.",
        )
    }

    private fun profile(page: ReportPage, name: String, profile: Profile, averages: Averages, label: String, drawn: List<Pair<String, String>>, caption: String) {
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
            val yLabel = drawn.find { it.first == column }?.second ?: continue
            val figure = Chart.lines(listOf(Curve(yLabel, x, y, error)), "$label [${units.length}]", yLabel)
            page.svg(
                Figures.write(figure, plots, "$name-${column.replace('_', '-')}", Chart.WIDTH, Chart.HEIGHT),
                "$yLabel over $label",
                "$caption Bars are one standard error.",
            )
        }
        Table("profile-$name", columns).write(tables)
    }

    private fun unitOf(column: String, axis: Int): String = when {
        column == "surface_density" && axis == 2 -> "${units.mass}/${units.length}^3"
        column == "surface_density" -> units.surfaceDensity
        column.startsWith("mean_v") -> units.speed
        column.startsWith("c_") -> "(${units.speed})^2"
        else -> ""
    }

    private fun ellipsoid(page: ReportPage) {
        page.section("Velocity ellipsoid")
        val e = numbers.ellipsoid
        val omega = input.omega
        val scale = if (omega != null) numbers.meanRadius * omega else 1.0
        fun curve(name: String, a: Double, b: Double, turned: Double): Curve {
            val angle = DoubleArray(ELLIPSE_POINTS + 1) { 2 * PI * it / ELLIPSE_POINTS }
            return Curve(
                name,
                DoubleArray(angle.size) { (a * cos(angle[it]) * cos(turned) - b * sin(angle[it]) * sin(turned)) / scale },
                DoubleArray(angle.size) { (a * cos(angle[it]) * sin(turned) + b * sin(angle[it]) * cos(turned)) / scale },
            )
        }
        val curves = listOf(curve("v_x, v_y", e.major, e.minor, e.orientation), curve("v_x, v_z", sqrt(xx(e)), e.vertical, 0.0))
        val unit = if (omega != null) "r Ω" else units.speed
        page.svg(
            Figures.write(Chart.ellipses(curves, "v_x [$unit]", "v_y, v_z [$unit]"), plots, "velocity-ellipsoid", Chart.WIDTH, ELLIPSE_HEIGHT),
            "sections of the velocity ellipsoid",
            "Sections of the velocity ellipsoid, one standard deviation; in the plane its long axis is turned by ${ReportText.short(
                Math.toDegrees(e.orientation),
            )}° from x toward y.",
        )
    }

    private fun xx(e: daphnis.analysis.profile.VelocityEllipsoid): Double =
        e.major * e.major * cos(e.orientation) * cos(e.orientation) + e.minor * e.minor * sin(e.orientation) * sin(e.orientation)

    private fun flow(page: ReportPage) {
        page.section("Mean flow")
        val f = measures.flow
        val vx = f.mean(measures.flowSums, 0)
        val vy = f.mean(measures.flowSums, 1)
        val backX = DoubleArray(vx.size) { -vx[it] }
        val backY = DoubleArray(vy.size) { -vy[it] }
        val box = input.state(input.size - 1).boundary.box
        val lines = (0 until f.ny).map { j ->
            // Forward and backward from the middle.
            val ahead = f.line(vx, vy, f.nx / 2.0, j + 0.5, 2 * f.nx)
            val behind = f.line(backX, backY, f.nx / 2.0, j + 0.5, 2 * f.nx)
            val line = DoubleArray(behind.size) { behind[(behind.size / 2 - 1 - it / 2) * 2 + it % 2] } + ahead
            Curve(
                "$j",
                DoubleArray(line.size / 2) { box.lowerX + line[2 * it] / f.nx * box.length(0) },
                DoubleArray(line.size / 2) { box.lowerY + line[2 * it + 1] / f.ny * box.length(1) },
            )
        }
        page.svg(
            Figures.write(Chart.paths(lines, "x [${units.length}]", "y [${units.length}]"), plots, "flow-lines", Chart.WIDTH, FLOW_HEIGHT),
            "lines of the mean flow",
            "Lines of the mean flow through the middle of the box, averaged over the states and over z; where the flow is slow the scatter of few particles turns them.",
        )
        val cells = f.nx * f.ny
        Table(
            "flow",
            listOf(
                Column("x", units.length, DoubleArray(cells) { box.lowerX + (it / f.ny + 0.5) / f.nx * box.length(0) }),
                Column("y", units.length, DoubleArray(cells) { box.lowerY + (it % f.ny + 0.5) / f.ny * box.length(1) }),
                Column("vx", units.speed, vx),
                Column("vy", units.speed, vy),
            ),
        ).write(tables)
    }

    private fun reproduce(page: ReportPage, last: PatchState) {
        page.section("Run")
        page.parameters(ReportText.parameters(input, last))
        if (input.directory == null) return
        page.paragraph(
            "To do it again: the scenario as it was resolved is in the run directory; it gives the same state digest on any machine, with any engine and number of threads.",
        )
        val name = input.directory.path.fileName
        page.commands(listOf("daphnis run $name/scenario.json --out again", "daphnis compare $name again", "daphnis analyze again"))
    }

    private companion object {
        const val MOST_POINTS = 800
        const val ELLIPSE_POINTS = 120
        const val ELLIPSE_HEIGHT = 420
        const val FLOW_HEIGHT = 420
    }
}
