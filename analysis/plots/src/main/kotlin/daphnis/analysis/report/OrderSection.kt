package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.neighbour.BondOrder
import daphnis.analysis.neighbour.Clusters
import daphnis.analysis.neighbour.HexaticOrder
import daphnis.analysis.neighbour.NeighbourLists
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/**
 * Order of neighbours in dense boxes: q₄, q₆ and solid-like spheres, of discs ψ₆. From every n-th of the averaged
 * states where particles are many.
 */
internal class OrderSection(private val study: Study) : Section {
    private val isPlane = study.last.boundary.space.isPlane
    private val every = maxOf(1L, (study.bulk.particles.toLong() * study.averaged.size + MOST_WORK - 1) / MOST_WORK)
    private var seen = 0L
    private val averages = Averages(Measure { if (isPlane) ofDiscs(it) else ofSpheres(it) })

    override val heading = "Order of neighbours"
    override val over get() = "Neighbours fill the solid angle around a ${if (isPlane) "disc" else "sphere"} " +
        "(van Meel & al. 2012). ${study.overAverages}"
    override val applies = !study.isRing &&
        (0 until study.last.dimensions).all { axis -> study.last.boundary.hasImages(axis) } &&
        study.bulk.fillingFactor >= (if (isPlane) LEAST_OF_DISCS else LEAST_OF_SPHERES) &&
        // Neighbours are sought as far as those of the largest may be: too many of small ones.
        study.bulk.largestRadius <= MOST_UNEQUAL * study.bulk.meanRadius
    override val leftOut get() = study.tooFew(FEWEST)

    override fun add(state: State) {
        if (seen++ % every == 0L && leftOut == null) averages.add(state)
    }

    private fun ofSpheres(state: State): DoubleArray {
        val lists = NeighbourLists.of(state)
        val order = BondOrder(state, lists)
        val solid = order.solidLike()
        val particles = order.q6.count { !it.isNaN() }.toDouble()
        val largest = Clusters.ofNeighbours(state, lists, solid).sizes.firstOrNull() ?: 0
        val numbers = doubleArrayOf(
            mean(order.q4),
            mean(order.q6),
            mean(order.averagedQ6),
            mean(order.w6),
            solid.count { it } / particles,
            largest / particles,
        )
        return numbers + shares(order.q6, particles) + shares(order.q4, particles) +
            shares(order.averagedQ6, particles)
    }

    private fun ofDiscs(state: State): DoubleArray {
        val order = HexaticOrder(state, NeighbourLists.of(state))
        val discs = order.modulus.count { !it.isNaN() }.toDouble()
        return doubleArrayOf(mean(order.modulus), order.ofAll) + shares(order.modulus, discs)
    }

    private fun mean(all: DoubleArray) = all.filter { !it.isNaN() }.average()

    /** Density of [values] by bin. */
    private fun shares(values: DoubleArray, particles: Double): DoubleArray {
        val bins = DoubleArray(BINS)
        val reach = reach()
        for (q in values) if (!q.isNaN()) bins[(q / reach * BINS).toInt().coerceIn(0, BINS - 1)]++
        return DoubleArray(BINS) { bins[it] / particles * BINS / reach }
    }

    private fun reach() = if (isPlane) 1.0 else REACH

    override fun numbers(): List<NumberRow> {
        if (averages.size == 0) return emptyList()
        val rows = NumberRows()
        for ((k, row) in (if (isPlane) OF_DISCS else OF_SPHERES).withIndex()) {
            val note = if (row.first == "solid_like_share") SOLID else ""
            rows.average(row.first, row.second, averages.average(k), "", note)
        }
        return rows.list()
    }

    override fun write(page: ReportPage) {
        val names = if (isPlane) {
            listOf("psi_6" to "|ψ₆|")
        } else {
            listOf(
                "q6" to "q₆",
                "q4" to "q₄",
                "average_q6" to "q̄₆",
            )
        }
        val from = (if (isPlane) OF_DISCS else OF_SPHERES).size
        val x = DoubleArray(BINS) { (it + 0.5) * reach() / BINS }
        val columns = arrayListOf(Column(if (isPlane) "psi" else "q", "", x))
        val curves = names.mapIndexed { k, (name, label) ->
            val all = List(BINS) { averages.average(from + k * BINS + it) }
            val y = DoubleArray(BINS) { all[it].mean }
            val error = DoubleArray(BINS) { study.judgement.error(all[it]) }
            columns += listOf(Column("density_$name", "", y), Column("density_${name}_error", "", error))
            Curve(label, x, y, error)
        }
        Table("bond-order", columns).write(study.tables)
        val figure = Chart.lines(curves, if (isPlane) "six-fold order |ψ₆|" else "bond order", "density")
        val caption = if (isPlane) DISCS else SPHERES
        study.draw(
            page,
            figure,
            "bond-order",
            "distribution of the order of neighbours",
            "$caption ${study.judgement.bars()}",
        )
    }

    private companion object {
        const val MOST_WORK = 400_000L

        /** Largest radius over the mean. */
        const val MOST_UNEQUAL = 3.0
        const val LEAST_OF_SPHERES = 0.45
        const val LEAST_OF_DISCS = 0.6
        const val FEWEST = 30
        const val BINS = 50
        const val REACH = 0.65
        const val SOLID = "of seven neighbours or more with q₆·q₆ above 0.7"
        const val SPHERES =
            "Bond order of spheres; q̄₆ is averaged over each with its neighbours (Lechner & Dellago 2008). At " +
                "rest a perfect face-centred cubic crystal has q₄ = 0.191 and q₆ = 0.575, a hexagonal one 0.097 and " +
                "0.485, a body-centred cubic one 0.036 and 0.511."
        const val DISCS = "Six-fold order of discs: 1 in a hexagonal lattice."
        val OF_SPHERES = listOf(
            "bond_order_q4" to "bond order q₄",
            "bond_order_q6" to "bond order q₆",
            "bond_order_average_q6" to "averaged bond order q̄₆",
            "bond_order_w6" to "bond order w₆",
            "solid_like_share" to "part of solid-like spheres",
            "largest_solid_share" to "part of spheres in the largest solid cluster",
        )
        val OF_DISCS = listOf(
            "hexatic_order_local" to "six-fold order ⟨|ψ₆|⟩ of a disc",
            "hexatic_order" to "six-fold order |⟨ψ₆⟩| of all discs",
        )
    }
}
