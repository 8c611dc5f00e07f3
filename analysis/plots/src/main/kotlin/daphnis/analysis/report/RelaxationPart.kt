package daphnis.analysis.report

import daphnis.analysis.diffusion.IntermediateScattering
import daphnis.analysis.diffusion.MeanSquareDisplacement
import daphnis.analysis.diffusion.Overlap
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames

/**
 * F(k, t) of all particles together, their overlap Q(t) and its fluctuations χ₄(t).
 *
 * @param isOfAll whether the [trajectories] are those of all particles
 */
internal class RelaxationPart(
    private val study: Study,
    private val trajectories: Trajectories,
    private val diameter: Double,
    private val isOfAll: Boolean,
) {
    private val unit = study.scale.timeName
    private val axis = UnitNames.axis("lag", unit)
    private val bars = study.judgement.bars("Bars are one standard error.")

    fun write(page: ReportPage, scattering: IntermediateScattering?) {
        if (scattering != null &&
            scattering.vectorCount > 0 &&
            scattering.size >= MeanSquareDisplacement.FEWEST_TIMES
        ) {
            waves(page, scattering)
        }
        val found = Overlap(trajectories, REACH * diameter)
        val overlap = Curve("Q", found.lag, found.overlap, study.judgement.errors(found.overlapError))
        val reach = UnitNames.amount(ReportText.short(found.reach), study.units.length)
        study.draw(
            page,
            Chart.lines(listOf(overlap), axis, "overlap Q(t)", logX = true, horizontal = 0.0),
            "overlap",
            "overlap",
            "Overlap Q: the part of the particles that are no farther than $reach from where they were. $bars",
        )
        val columns = arrayListOf(
            Column("lag", unit, found.lag),
            Column("Q", "", overlap.y),
            Column("Q_error", "", overlap.error!!),
        )
        if (isOfAll) {
            val error = study.judgement.errors(found.susceptibilityError)
            val chi = Curve("χ₄", found.lag, found.susceptibility, error)
            val single =
                Curve("Q (1 − Q)", found.lag, DoubleArray(found.lag.size) { overlap.y[it] * (1 - overlap.y[it]) })
            study.draw(
                page,
                Chart.lines(listOf(chi, single), axis, "dynamic susceptibility χ₄(t)", logX = true, horizontal = 0.0),
                "dynamic-susceptibility",
                "dynamic susceptibility",
                "Dynamic susceptibility χ₄ = N (⟨Q²⟩ − ⟨Q⟩²), at constant number${energy()}. Particles that move " +
                    "independently have Q (1 − Q). $bars",
            )
            columns += listOf(Column("chi_4", "", chi.y), Column("chi_4_error", "", error))
        }
        Table("overlap", columns).write(study.tables)
    }

    /** Of elastic spheres that nothing drives. */
    private fun energy(): String {
        val scenario = study.input.scenario ?: return ""
        val isKept = scenario.forces.isEmpty() && ElasticGas.isAtRest(scenario, study.last)
        return if (isKept) " and energy" else ""
    }

    private fun waves(page: ReportPage, scattering: IntermediateScattering) {
        val f = scattering.function()
        val curve = Curve("F", f.lag, f.scattering, study.judgement.errors(f.error))
        val k = UnitNames.amount(ReportText.short(scattering.waveNumber), study.units.waveNumber)
        study.draw(
            page,
            Chart.lines(listOf(curve), axis, "intermediate scattering F(k, t)", logX = true, horizontal = 0.0),
            "intermediate-scattering",
            "intermediate scattering function",
            "Intermediate scattering function of all particles, averaged over ${scattering.vectorCount} wave vectors " +
                "of mean |k| = $k; at the lag 0 it is S(k) = ${ReportText.short(f.scattering[0])}. $bars",
        )
        val columns = listOf(
            Column("lag", unit, f.lag),
            Column("F", "", curve.y),
            Column("F_error", "", curve.error!!),
        )
        Table("intermediate-scattering", columns).write(study.tables)
    }

    private companion object {
        /** Of the overlap, in diameters. */
        const val REACH = 0.3
    }
}
