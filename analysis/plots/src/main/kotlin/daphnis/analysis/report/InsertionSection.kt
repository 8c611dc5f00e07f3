package daphnis.analysis.report

import daphnis.analysis.correlation.Insertion
import daphnis.analysis.insitu.Averages
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSphereMixture
import daphnis.analysis.theory.HardSpheres
import daphnis.core.format.Snapshot
import kotlin.math.hypot

/**
 * The chemical potential of elastic spheres or discs at rest, by spheres put at random places. In more states than others
 * take: what fits into one differs from what fits into the next by more than its places leave open.
 */
internal class InsertionSection(private val study: Study) : Section {
    private val input = study.input
    private val last = study.last
    private val chosen = chosen()
    private var seen = 0
    private val isPlane = last.boundary.space.isPlane
    private val filling = study.bulk.fillingFactor
    private val insertion = Insertion(2 * study.bulk.largestRadius, BINS)
    private val averages = Averages(insertion)
    private val isEqual = study.physics?.let { ElasticGas.isSeen(it, last) } == true

    override val heading = "Insertion"
    override val over = "${if (isPlane) "Discs" else "Spheres"} put at random places in " +
        "${ReportText.count(chosen.size, "state")} from time ${study.time(study.from)} on."
    override val applies: Boolean =
        study.physics?.let { ElasticGas.isAtRest(it, last) && it.forces.isEmpty() } == true &&
            last.boundary.shear == null &&
            !study.isRoomCut &&
            !study.isGrowing &&
            study.tooFew() == null

    override val followed = if (applies) chosen else emptyList()

    override fun follow(snapshot: Snapshot) = averages.add(input.state(chosen[seen++], snapshot))

    private fun chosen(): List<Int> {
        val late = input.times.indices.filter { input.times[it] >= study.from }
        val every = maxOf(1, (late.size + MOST_STATES - 1) / MOST_STATES)
        return late.filterIndexed { k, _ -> k % every == 0 }
    }

    override fun numbers(): List<NumberRow> {
        if (!isEqual || averages.size == 0) return emptyList()
        val rows = NumberRows(references())
        val found = averages.average(BINS)
        if (found.mean.isNaN()) return emptyList()
        rows.average(KEY, "excess chemical potential μ_ex/kT", found, "", "by insertion (Widom 1963)")
        return rows.list()
    }

    private fun references(): Map<String, Reference> {
        if (filling > (if (isPlane) HardDiscs.MOST_FILLED else HardSpheres.FREEZING)) return emptyMap()
        val value = if (isPlane) {
            HardDiscs.hendersonChemicalPotential(filling)
        } else {
            HardSpheres.carnahanStarlingChemicalPotential(filling)
        }
        val source = if (isPlane) EquationOfState.HENDERSON else EquationOfState.CARNAHAN
        return mapOf(KEY to Reference(value, hypot(BOUND, FEW / study.bulk.particles) * value, source))
    }

    override fun write(page: ReportPage) {
        val x = DoubleArray(BINS + 1) { insertion.diameter(it) }
        val all = x.indices.map { averages.average(it) }
        val found = Curve(
            "−ln p",
            x,
            DoubleArray(x.size) { all[it].mean },
            DoubleArray(x.size) { study.judgement.error(all[it]) },
        )
        val theory = theory()?.let { t -> Curve("BMCSL", x, DoubleArray(x.size) { t.excessChemicalPotential(x[it]) }) }
        val beside = if (theory == null) "" else " Theory of mixtures (BMCSL) stands beside it."
        val one = if (isPlane) "disc" else "sphere"
        study.draw(
            page,
            Chart.lines(
                listOfNotNull(found, theory),
                study.lengthAxis("diameter"),
                "excess chemical potential μ_ex/kT",
            ),
            "insertion",
            "excess chemical potential",
            "−ln of the probability p that a $one of a diameter fits in at a random place: its excess chemical " +
                "potential over kT. A point fits with 1 less the filling factor.$beside ${study.judgement.bars()}",
        )
        val columns = listOf(
            Column("diameter", study.units.length, x),
            Column("mu_ex_over_kT", "", found.y),
            Column("mu_ex_over_kT_error", "", found.error!!),
        )
        Table("insertion", columns + listOfNotNull(theory?.let { Column("theory", "", it.y) })).write(study.tables)
    }

    /** Of spheres, of several sizes too. */
    private fun theory(): HardSphereMixture? {
        if (isPlane || filling > HardSpheres.FREEZING) return null
        val p = last.population
        val kinds = (0 until p.size).groupingBy { p.radius[it] }.eachCount().entries.toList()
        val volume = last.boundary.volume
        return HardSphereMixture(
            DoubleArray(kinds.size) { 2 * kinds[it].key },
            DoubleArray(kinds.size) { kinds[it].value / volume },
        )
    }

    private companion object {
        const val KEY = "chemical_potential"
        const val BINS = 20
        const val MOST_STATES = 200

        /** Of the equation of state, and of N spheres instead of many, relative, the latter over N. */
        const val BOUND = 0.005
        const val FEW = 3.0
    }
}
