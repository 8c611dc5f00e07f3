package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import kotlin.math.sqrt

/** What happens in the course of a period of a perturbed sheet. */
internal class PerturbedSection(private val study: Study) : Section {
    private val transport = study.motion.perturbed

    override val heading = "Perturbation"
    override val over get() = "Means by phase over ${ReportText.count(transport?.periods ?: 0, "period")} from time " +
        "${study.time(study.from)} on; the patch is narrowest at phase 0."
    override val applies = PerturbedSheet.isSeen(study.last)
    override val leftOut: String? = when {
        study.input.transport == null -> "the run wrote no transport.csv; it does with output.transportEvery"
        transport == null -> "there is no whole period to average over"
        else -> null
    }

    override fun write(page: ReportPage) {
        val omega = study.input.omega!!
        val speed = study.bulk.meanRadius * omega
        val (phase, density, squares, flux) = transport!!.byPhase(BINS)
        val dispersion = DoubleArray(BINS) { sqrt(squares[it]) / speed }
        val carried = DoubleArray(BINS) { flux[it] / (speed * speed) }
        val curves = listOf(
            Curve("surface density over its mean", phase, density),
            Curve("dispersion, r Ω", phase, dispersion),
            Curve("flux of angular momentum, Σ r² Ω²", phase, carried),
        )
        study.draw(
            page,
            Chart.lines(curves, "phase κt/2π", ""),
            "perturbation",
            "surface density, velocity dispersion and flux of angular momentum by phase",
            "Surface density, velocity dispersion around the flow of streamlines, and flux of angular momentum in " +
                "the course of a period; the flux is outward where it is positive.",
        )
        Table(
            "perturbation",
            listOf(
                Column("phase", "", phase),
                Column("surface_density", "", density),
                Column("dispersion", "r Omega", dispersion),
                Column("angular_momentum_flux", "Sigma r^2 Omega^2", carried),
            ),
        ).write(study.tables)
    }

    private companion object {
        const val BINS = 25
    }
}
