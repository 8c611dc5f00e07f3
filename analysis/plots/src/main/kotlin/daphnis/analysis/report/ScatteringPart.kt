package daphnis.analysis.report

import daphnis.analysis.diffusion.SelfScattering
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames

/** F_s(k, t) at the [waveNumber] of the peak of S(k), and α₂(t), of particles that are free along all axes of a box at rest. */
internal class ScatteringPart(
    private val study: Study,
    private val trajectories: Trajectories,
    private val waveNumber: Double,
) {
    private val units = study.units

    fun write(page: ReportPage) {
        val found = SelfScattering(trajectories, waveNumber)
        val unit = study.scale.timeName
        val axis = UnitNames.axis("lag", unit)
        val bars = study.judgement.bars("Bars are one standard error.")
        val time = found.relaxationTime()
        val falls = if (time.isNaN()) "" else " It falls to 1/e in ${UnitNames.amount(ReportText.short(time), unit)}."
        val scattering = Curve("F_s", found.lag, found.scattering, study.judgement.errors(found.scatteringError))
        val k = UnitNames.amount(ReportText.short(waveNumber), units.waveNumber)
        if (isNoise(found)) {
            val first = UnitNames.amount(ReportText.short(found.lag[0]), unit)
            page.paragraph(
                "No self-intermediate scattering function at k = $k: it has fallen to noise within $first, $DENSER",
            )
        } else {
            study.draw(
                page,
                Chart.lines(
                    listOf(scattering),
                    axis,
                    "self-intermediate scattering F_s(k, t)",
                    logX = true,
                    horizontal = 0.0,
                ),
                "self-scattering",
                "self-intermediate scattering function",
                "Self-intermediate scattering function at k = $k, near the peak of S(k) of the last state.$falls $bars",
            )
        }
        val parameter = Curve("α₂", found.lag, found.nonGaussian, study.judgement.errors(found.nonGaussianError))
        study.draw(
            page,
            Chart.lines(listOf(parameter), axis, "non-Gaussian parameter α₂(t)", logX = true, horizontal = 0.0),
            "non-gaussian",
            "non-Gaussian parameter",
            "Non-Gaussian parameter of the same displacements; 0 where they are Gaussian. $bars",
        )
        val columns = listOf(
            Column("lag", unit, found.lag),
            Column("F_s", "", scattering.y),
            Column("F_s_error", "", scattering.error!!),
            Column("alpha_2", "", parameter.y),
            Column("alpha_2_error", "", parameter.error!!),
        )
        Table("self-scattering", columns).write(study.tables)
    }

    /** Whether F_s is nothing but noise from its shortest lag on. */
    private fun isNoise(found: SelfScattering): Boolean {
        val error = found.scatteringError[0].takeIf { it.isFinite() } ?: 0.0
        return !(found.scattering[0] > maxOf(NOISE, 3 * error))
    }

    private companion object {
        /** F_s below which nothing of it is left. */
        const val NOISE = 0.05
        const val DENSER = "the shortest time between two states. More states would show it (output.snapshotEvery)."
    }
}
