package daphnis.analysis.report

import daphnis.analysis.correlation.VelocitySpectra
import daphnis.analysis.insitu.State
import daphnis.analysis.neighbour.Clusters
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.analysis.theory.ShearInstability

/** Vortices and clusters of a gas that cools by itself: spectra of the last state, and clusters over time. */
internal class CoolingSection(private val study: Study) : Section {
    private val last = study.last
    private val gap = GAP * 2 * study.bulk.meanRadius
    private val times = ArrayList<Double>()
    private val sizes = ArrayList<Double>()
    private val largest = ArrayList<Double>()

    override val heading = "Vortices and clusters"
    override val over =
        "Spectra are of the last state, time ${study.time(last.time)}. Clusters are of the averaged states: " +
            "${study.bodies} whose surfaces are up to ${UnitNames.amount(
                ReportText.short(gap),
                study.units.length,
            )} apart, " +
            "a tenth of the mean diameter."
    override val applies = !study.isRing &&
        !study.isGrowing &&
        study.input.hasVelocities &&
        (0 until last.dimensions).all { last.boundary.hasImages(it) } &&
        FreeCooling.isSeen(study.input)
    override val leftOut = study.tooFew(FEWEST)

    override fun add(state: State) {
        if (leftOut != null) return
        val found = Clusters.byGap(state, gap)
        times += state.time / study.scale.time
        sizes += found.meanSize
        largest += found.sizes[0].toDouble() / found.particles
    }

    override fun write(page: ReportPage) {
        spectra(page)
        clusters(page)
    }

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

    private fun clusters(page: ReportPage) {
        val found = Clusters.byGap(last, gap)
        val edges = generateSequence(1) { 2 * it }.takeWhile { it <= found.sizes[0] }.toList()
        val number =
            DoubleArray(edges.size) { k -> found.sizes.count { it >= edges[k] && it < 2 * edges[k] }.toDouble() }
        val share = DoubleArray(edges.size) { k ->
            found.sizes.filter { it >= edges[k] && it < 2 * edges[k] }.sum().toDouble() / found.particles
        }
        val columns = listOf(
            Column("size_from", "", DoubleArray(edges.size) { edges[it].toDouble() }),
            Column("clusters", "", number),
            Column("share_of_particles", "", share),
        )
        Table("clusters", columns).write(study.tables)
        val over = "xyz".toList().filterIndexed { k, _ -> found.spans[k] }
        val spans = if (over.isEmpty()) "No cluster of it" else "A cluster of it"
        val along = if (over.isEmpty()) "" else " along ${over.joinToString(" and ")}"
        if (times.size >= 2) {
            val x = times.toDoubleArray()
            val curve = Curve("mean size", x, sizes.toDoubleArray())
            val figure = Chart.lines(
                listOf(curve),
                UnitNames.axis("time", study.scale.timeName),
                "mean size of a cluster",
                logY = Chart.isWide(sizes),
            )
            val caption =
                "Size of the cluster of a particle, on average: Σ s²/Σ s. In the last state the largest has " +
                    "${ReportText.count(found.sizes[0], "particle")}. $spans goes on through the faces$along."
            study.draw(page, figure, "clusters", "mean size of clusters over time", caption)
            val history = listOf(
                Column("time", study.scale.timeName, x),
                Column("mean_size", "", sizes.toDoubleArray()),
                Column("largest_share", "", largest.toDoubleArray()),
            )
            Table("cluster-history", history).write(study.tables)
        }
    }

    private companion object {
        const val GAP = 0.1
        const val FEWEST = 30
        const val BINS = 40

        /** In the longest edge. Bins then have no edge at a wave number of a cube. */
        const val MOST_WAVES = 21
        const val SPECTRA =
            "Spectra of the last state: S_⊥ of vorticity, S_∥ of compression, each over what velocities " +
                "without correlation have, and the structure factor S of the density."
    }
}
