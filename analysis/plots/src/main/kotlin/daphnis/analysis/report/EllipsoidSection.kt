package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.profile.VelocityEllipsoid
import daphnis.analysis.table.UnitNames
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/** Two sections through the velocity ellipsoid. */
internal class EllipsoidSection(private val study: Study) : Section {
    private val e by lazy { study.motion.ellipsoid }

    override val heading = "Velocity ellipsoid"
    override val over = study.overMotion
    override val applies = study.input.hasVelocities
    override val leftOut get() =
        study.tooFew() ?: WallDrive.remark(study).ifEmpty {
            when {
                !(e.dispersion > 0) -> "no particle moves against the mean flow"
                isAlikeInAll && !isTurned -> "nothing prefers a direction there, and $EQUAL"
                else -> null
            }
        }
    private val isTurned by lazy { AxesInPlane.isSeen(study.motion, study.bulk.particles) }

    /** Whether no direction differs from another by what moves the spheres: a box alike along all axes, at rest. */
    private val isAlikeInAll: Boolean
        get() = study.input.scenario?.let { scenario ->
            val boundary = study.last.boundary
            scenario.frame == null && scenario.forces.isEmpty() && boundary.meanFlow == null &&
                !scenario.boundary.drives && boundary.walls.surfaces.isEmpty() &&
                (0 until study.last.dimensions).distinctBy { boundary.contactFaces(it) }.size == 1
        } == true

    override fun write(page: ReportPage) {
        val isOfDiscs = study.last.boundary.space.isPlane
        val inPlane = curve("v_x, v_y", e.major, e.minor, e.orientation)
        val curves = if (isOfDiscs) {
            listOf(
                inPlane,
            )
        } else {
            listOf(inPlane, curve("v_x, v_z", sqrt(xx(e)), e.vertical, 0.0))
        }
        val unit = study.scale.speedName
        study.draw(
            page,
            Chart.ellipses(
                curves,
                UnitNames.axis("v_x", unit),
                UnitNames.axis(if (isOfDiscs) "v_y" else "v_y, v_z", unit),
            ),
            "velocity-ellipsoid",
            if (isOfDiscs) "the velocity ellipse" else "sections of the velocity ellipsoid",
            "${if (isOfDiscs) "The velocity ellipse" else "Sections of the velocity ellipsoid"}, one standard deviation${study.bulk.byMass}; ${direction()}.",
            HEIGHT,
        )
    }

    /** Of the long axis in the plane, if there is one. */
    private fun direction(): String {
        if (!isTurned) return "in the plane $EQUAL, so they have no direction"
        val degrees = study.motion.orientation * Math.toDegrees(1.0)
        // The same number as in the table, where it stands, and judged as there.
        val rows = NumberRows()
        rows.average("ellipsoid_orientation", "", degrees, "degrees")
        val row = study.judgement.shown(rows.list()).single()
        val turned = ReportText.withError(row.value, row.error)
        val mark = row.unknown?.let { " (${it.remark})" }.orEmpty()
        return "in the plane its long axis is turned by $turned degrees$mark from x toward y"
    }

    private fun curve(name: String, a: Double, b: Double, turned: Double): Curve {
        val angle = DoubleArray(POINTS + 1) { 2 * PI * it / POINTS }
        val unit = study.scale.speed
        return Curve(
            name,
            DoubleArray(angle.size) { (a * cos(angle[it]) * cos(turned) - b * sin(angle[it]) * sin(turned)) / unit },
            DoubleArray(angle.size) { (a * cos(angle[it]) * sin(turned) + b * sin(angle[it]) * cos(turned)) / unit },
        )
    }

    private fun xx(e: VelocityEllipsoid): Double = e.major * e.major * cos(e.orientation) * cos(e.orientation) +
        e.minor * e.minor * sin(e.orientation) * sin(e.orientation)

    private companion object {
        const val POINTS = 120
        const val HEIGHT = 420
        const val EQUAL = "its axes are no more unequal than chance makes them"
    }
}
