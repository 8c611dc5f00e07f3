package daphnis.analysis.report

import daphnis.analysis.correlation.VelocitySpectra
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.analysis.theory.ShearInstability

/** Vortices of a gas that cools by itself: spectra of the last state. */
internal class CoolingSection(private val study: Study) : Section {
    private val last = study.last

    override val heading = "Vortices"
    override val over = study.overLast
    override val applies = !study.isRing &&
        !study.isGrowing &&
        study.input.hasVelocities &&
        (0 until last.dimensions).all { last.boundary.hasImages(it) } &&
        FreeCooling.isSeen(study.input)
    override val leftOut = study.tooFew(FEWEST)

    override fun write(page: ReportPage) = spectra(page)

    private fun spectra(page: ReportPage) {
        val longest = (0 until last.dimensions).maxOf { last.boundary.box.length(it) }
        val shortest = (0 until last.dimensions).minOf { last.boundary.box.length(it) }
        val reach = minOf(MOST_WAVES * 2 * Math.PI / longest, 2 * Math.PI / study.bulk.typicalRadius)
        val spectra = VelocitySpectra(maxOf(reach, 2.5 * 2 * Math.PI / shortest), BINS)
        val all = spectra.of(last)
        val x = spectra.waveNumbers(last)
        val curves = listOf("S_⊥" to 0, "S_∥" to 1, "S" to 2).map { (name, k) ->
            Curve(name, x, all.copyOfRange(k * BINS, (k + 1) * BINS))
        }
        val critical = critical()
        val figure = Chart.lines(
            curves,
            UnitNames.axis("wave number |k|", study.units.waveNumber),
            "spectrum",
            logY = Chart.isWide(curves.flatMap { c -> c.y.filter { !it.isNaN() } }),
            horizontal = 1.0,
            vertical = critical?.let { 2 * Math.PI / it },
        )
        val line = if (critical == null) {
            ""
        } else {
            " The upright line is k_c = 2π/L_c, below which vortices grow beside the thermal speed; L_c is " +
                "${UnitNames.amount(ReportText.short(critical), study.units.length)} (Garzó 2005)" +
                if (critical > longest) ", more than this box is long: none grow in it." else "."
        }
        study.draw(page, figure, "velocity-spectra", "spectra of momentum and density", SPECTRA + line)
        val columns = listOf(
            Column("k", study.units.waveNumber, x),
            Column("S_transverse", "", curves[0].y),
            Column("S_longitudinal", "", curves[1].y),
            Column("S_density", "", curves[2].y),
        )
        Table("velocity-spectra", columns).write(study.tables)
    }

    /** Of equal spheres or discs that meet nothing else. */
    private fun critical(): Double? {
        val restitution = study.physics?.takeIf { References.isPlain(it, last) }?.restitutionAtRest ?: return null
        val isFree = (0 until last.dimensions).all { last.boundary.repeats(it) }
        val isKnown = restitution >= ShearInstability.LEAST_RESTITUTION &&
            restitution < 1 &&
            study.bulk.fillingFactor <= ShearInstability.MOST_FILLED
        if (!isFree || !isKnown) return null
        return 2 * study.bulk.meanRadius *
            ShearInstability.criticalLength(restitution, study.bulk.fillingFactor, last.boundary.space)
    }

    private companion object {
        const val FEWEST = 30
        const val BINS = 40

        /** In the longest edge. Bins then have no edge at a wave number of a cube. */
        const val MOST_WAVES = 21
        const val SPECTRA =
            "Spectra of the last state: S_⊥ of vorticity, S_∥ of compression, each over what velocities " +
                "without correlation have, and the structure factor S of the density."
    }
}
