package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.profile.Profile
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import kotlin.math.sqrt

/** Profiles across the patch, along it and over height; all columns in `tables/profile-*.csv`. */
internal class ProfilesSection(private val study: Study) : Section {
    private val units = study.units
    private val radialName = if (study.isRing) "radial position x" else "x"
    private val box = study.boxes.common

    private val radial = Averaged(Profile(0, box.lowerX, box.upperX, bins(box.length(0))))
    private val azimuthal = Averaged(Profile(1, box.lowerY, box.upperY, bins(box.length(1))))
    private val vertical = Averaged(if (study.isRing) overHeight() else overBox())

    private val height = if (study.isRing || DrivenWalls.isUnderGravity(study)) "height z" else "z"
    private val overHeight = if (height == "z") "along z" else "over height"

    private val isOfDiscs = study.last.boundary.space.isPlane
    private val isAcrossY = study.last.boundary.meanFlow?.normalAxis == 1
    private val across = if (isAcrossY) azimuthal else radial
    private val acrossAxis = study.lengthAxis(if (isAcrossY) "y" else radialName)

    override val heading = "Profiles"
    override val over get() = "Averages in equal bins over ${study.averagedStates}. ${study.judgement.bars()}" +
        study.boxes.ifChanging("bins are where every box is.")
    override val leftOut = study.tooFew()

    /** A profile with its averages. */
    private class Averaged(val profile: Profile) {
        val averages = Averages(profile)

        /** Column [c] by bin. */
        fun column(c: Int) = (0 until profile.bins).map { averages.average(it * Profile.COLUMNS.size + c) }

        fun centres() = DoubleArray(profile.bins) { profile.centre(it) }
    }

    /** Bins of the largest diameter, not too many. */
    private fun bins(length: Double): Int = (length / (2 * study.bulk.largestRadius)).toInt().coerceIn(1, MOST_BINS)

    private fun overHeight(): Profile {
        val z = study.last.population.z
        val height = z.maxOf { Math.abs(it) } + study.bulk.largestRadius
        return Profile(2, -height, height, bins(4 * 2 * height))
    }

    private fun overBox() = Profile(2, box.lowerZ, box.upperZ, bins(box.length(2)))

    override fun add(state: State) {
        for (one in listOf(radial, azimuthal, vertical)) one.averages.add(state)
    }

    override fun write(page: ReportPage) {
        val across = table("radial", radial)
        table("azimuthal", azimuthal)
        val overHeight = if (isOfDiscs) null else table("vertical", vertical)
        if (study.isRoomCut) {
            page.paragraph("No densities over bins of the box: ${Study.ROOM_CUT}.")
        } else {
            densities(page, across, overHeight)
        }
        if (study.input.hasVelocities) {
            if (!isOfDiscs && !study.isRing && !study.last.boundary.hasImages(2)) temperature(page)
            dispersions(page)
        }
    }

    private fun densities(page: ReportPage, across: Table, overHeight: Table?) {
        val (column, caption) = when {
            study.isLit -> "optical_depth" to "Optical depth across the ${study.place}."
            // Of a bed the filling factor of the whole height would be a number of the roof.
            DrivenWalls.isUnderGravity(study) -> "surface_density" to "Surface density along x."
            else -> "filling_factor" to "${if (isOfDiscs) "Area fraction" else "Filling factor"} along x."
        }
        val planes = if (study.mayFreeze) PLANES else ""
        drawn(page, radial, across, column, radialName, caption + planes)
        if (overHeight == null) return
        drawn(page, vertical, overHeight, "filling_factor", height, "Filling factor ${this.overHeight}.$planes")
    }

    /** Writes the table of a profile. */
    private fun table(name: String, of: Averaged): Table {
        val columns = arrayListOf(Column("centre", units.length, of.centres()))
        for ((c, column) in Profile.COLUMNS.withIndex()) {
            if (!study.input.hasVelocities && isOfMotion(column)) continue
            if (study.isRoomCut && column in OF_BOX) continue
            val all = of.column(c)
            val unit = unitOf(column, of.profile.axis)
            columns += Column(column, unit, DoubleArray(all.size) { all[it].mean })
            val key = KEYS[column]
            columns += Column("${column}_error", unit, DoubleArray(all.size) { study.judgement.error(all[it], key) })
        }
        return Table("profile-$name", columns).also { it.write(study.tables) }
    }

    /** Draws a [column] of a [table] over its bins. */
    private fun drawn(page: ReportPage, of: Averaged, table: Table, column: String, label: String, caption: String) {
        fun values(name: String) = table.columns.first { it.name == name }.values
        val quantity = if (isOfDiscs && column == "filling_factor") "area fraction" else column.replace('_', ' ')
        val figure = Chart.lines(
            listOf(Curve(quantity, values("centre"), values(column), values("${column}_error"))),
            study.lengthAxis(label),
            UnitNames.axis(quantity, unitOf(column, of.profile.axis)),
        )
        val name = "${table.name.removePrefix("profile-")}-${column.replace('_', '-')}"
        study.draw(page, figure, name, "$quantity over $label", caption)
    }

    /** Across the flow: along x in Hill's frame, along y in a sheared box. */
    private fun dispersions(page: ReportPage) {
        val first = Profile.COLUMNS.indexOf("c_xx")
        val scale = study.scale
        val curves = listOf("σ_x", "σ_y", "σ_z").take(study.last.dimensions).mapIndexed { c, name ->
            val all = across.column(first + c)
            Curve(
                name,
                across.centres(),
                DoubleArray(all.size) { sqrt(all[it].mean) / scale.speed },
                DoubleArray(all.size) {
                    study.judgement.error(all[it], "sigma_${"xyz"[c]}") / (2 * sqrt(all[it].mean)) / scale.speed
                },
            )
        }
        val label = UnitNames.axis("velocity dispersion", scale.speedName)
        val where = if (isAcrossY) "across the flow" else "along ${if (study.isRing) "the radius" else "x"}"
        val said = "velocity dispersions $where"
        val caption = "Velocity dispersions $where, around the mean of each bin, by number."
        study.draw(page, Chart.lines(curves, acrossAxis, label), "radial-dispersion", said, caption)
        if (isAcrossY) meanFlow(page)
    }

    /** Of a bed between floor and roof, of which the floor may heat. */
    private fun temperature(page: ReportPage) {
        val first = Profile.COLUMNS.indexOf("c_xx")
        val parts = (0 until 3).map { vertical.column(first + it) }
        val count = vertical.column(Profile.COLUMNS.indexOf("count"))
        val isSeen = BooleanArray(count.size) { count[it].mean * vertical.averages.size >= FEWEST_IN_BIN }
        if (isSeen.none { it }) {
            page.paragraph("No mean square velocities $overHeight: no bin has $FEWEST_IN_BIN particles in all states.")
            return
        }
        val unit = study.scale.speed * study.scale.speed
        val curves = listOf("⟨c_x²⟩", "⟨c_y²⟩", "⟨c_z²⟩").mapIndexed { c, name ->
            val all = parts[c]
            Curve(
                name,
                vertical.centres(),
                DoubleArray(all.size) { if (isSeen[it]) all[it].mean / unit else Double.NaN },
                DoubleArray(all.size) { study.judgement.error(all[it], "sigma_${"xyz"[c]}") / unit },
            )
        }
        val label = UnitNames.axis("mean square velocity", study.scale.temperatureName)
        val flow = WallDrive.remark(study)
        val streams = if (DrivenWalls.isUnderGravity(study)) STREAMS else ""
        val caption = "Mean square velocities $overHeight by component, around the mean of each bin, by number" +
            (if (flow.isEmpty()) "." else "; $flow within a bin.") +
            " Bins with fewer than $FEWEST_IN_BIN particles in all states are left out.$streams"
        val figure = Chart.lines(curves, study.lengthAxis(height), label)
        study.draw(page, figure, "vertical-temperature", "mean square velocities $overHeight", caption)
    }

    /** The flow of a sheared box as it is, beside the straight line that the boundary drives. */
    private fun meanFlow(page: ReportPage) {
        val rate = study.last.boundary.meanFlow?.rate ?: return
        val rest = across.column(Profile.COLUMNS.indexOf("mean_vx"))
        val y = across.centres()
        val driven = DoubleArray(rest.size) { rate * y[it] }
        val measured = DoubleArray(rest.size) { driven[it] + rest[it].mean }
        val curves = listOf(
            Curve("measured", y, measured, DoubleArray(rest.size) { study.judgement.error(rest[it]) }),
            Curve("straight", y, driven),
        )
        val figure = Chart.lines(curves, acrossAxis, UnitNames.axis("mean velocity u_x", units.speed))
        val caption = "Mean velocity along x over y, beside the straight line that the boundary drives."
        study.draw(page, figure, "flow-profile", "mean velocity across the flow", caption)
    }

    private fun unitOf(column: String, axis: Int): String = when {
        column == "surface_density" && axis == 2 -> units.density
        column == "surface_density" -> units.surfaceDensity
        column.startsWith("mean_v") -> units.speed
        column.startsWith("c_") -> units.temperature
        else -> ""
    }

    private fun isOfMotion(column: String) = column.startsWith("mean_v") || column.startsWith("c_")

    companion object {
        /** Of what is as dense as a crystal, behind a caption of densities over bins. */
        const val PLANES = " In a crystal these bins beat with its planes, which makes waves that are not there."
        private const val MOST_BINS = 60

        /** Particles of all states together below which a mean square is noise. */
        private const val FEWEST_IN_BIN = 50
        private const val STREAMS =
            " Where grains stream through one another, as those that rise from a floor and those that fall " +
                "back, ⟨c_z²⟩ is no temperature."

        /** Columns that are over the volume or the area of bins of the box. */
        private val OF_BOX = setOf("surface_density", "optical_depth", "filling_factor")

        /** The numbers of the report that columns are parts of. */
        private val KEYS = mapOf("c_xx" to "sigma_x", "c_yy" to "sigma_y", "c_zz" to "sigma_z") +
            mapOf("filling_factor" to "midplane_filling_factor")
    }
}
