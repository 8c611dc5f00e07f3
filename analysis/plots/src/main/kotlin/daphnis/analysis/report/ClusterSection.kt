package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.neighbour.Cluster
import daphnis.analysis.neighbour.ClusterCriterion
import daphnis.analysis.neighbour.ClusterSizes
import daphnis.analysis.neighbour.Clusters
import daphnis.analysis.plot.Chart
import daphnis.core.format.Snapshot
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import daphnis.core.scenario.Scenario

/**
 * Clusters of spheres that attract each other, of gases that cool, and where they are asked for: their sizes over the
 * averaged states, the largest over the whole run, and each of those in the last state.
 */
internal class ClusterSection(private val study: Study) : Section {
    private val last = study.last
    private val attraction = study.input.scenario?.let { attraction(it, last.population.materials) }
    private val asked = study.options.clusterRatio?.let { ClusterCriterion(it) }
    private val criterion = asked ?: attraction ?: ClusterCriterion(TOUCHING)
    private val isGas = !study.isGrowing &&
        study.input.hasVelocities &&
        (0 until last.dimensions).all { last.boundary.hasImages(it) } &&
        FreeCooling.isSeen(study.input)
    private val sizes = ClusterSizes(criterion)
    private val averages = Averages(sizes)
    private val history = ClusterHistory(study)
    private var next = 0

    override val heading = "Clusters"
    override val over get() =
        "Spheres are in one cluster where ${linked()}, by way of others too, and through faces. Each cluster is " +
            "measured in the last state. Sizes: ${study.overAverages.replaceFirstChar { it.lowercase() }}"
    override val applies = asked != null || study.input.scenario?.interactions?.isNotEmpty() == true || isGas
    override val leftOut: String? get() = study.tooFew(FEWEST) ?: tooFar ?: none()

    private val tooFar: String? = run {
        val p = last.population
        val farthest = 2 * criterion.reach * (0 until p.size).maxOf { p.radius[it] }
        val edges = study.boxes.boundaries.flatMap { b -> (0..2).filter { b.repeats(it) }.map { b.box.length(it) } }
        if (edges.all { farthest <= it }) null else "spheres of a cluster would be farther apart than the box is wide"
    }

    override val followed = if (study.input.size <= MOST_FOLLOWED) {
        study.input.times.indices.toList()
    } else {
        List(MOST_FOLLOWED) { (it.toLong() * (study.input.size - 1) / (MOST_FOLLOWED - 1)).toInt() }
    }

    override fun follow(snapshot: Snapshot) {
        val k = followed[next++]
        if (tooFar != null) return
        val state = study.input.state(k, snapshot)
        history.add(state.time, sizes.finish(sizes.sums(Clusters.of(state, criterion)), 1))
    }

    override fun add(state: State) {
        if (tooFar == null) averages.add(state)
    }

    private fun none(): String? = if (history.largest < 2) "in no state are there two where ${linked()}" else null

    private fun linked(): String {
        val apart = "their centres are up to ${Quantities.number(criterion.reach)} sums of their radii apart"
        return when {
            asked != null || attraction == null -> apart
            study.input.scenario!!.contacts.any { it.interaction != null } ->
                "they attract each other, as far as the interaction of their materials does"
            else -> "they attract each other: $apart"
        }
    }

    private fun average(name: String) = averages.average(ClusterSizes.NUMBERS.indexOf(name))

    override fun numbers(): List<NumberRow> {
        // A gas that cools has no steady state, and no number of it means more than its history does.
        if (averages.size == 0 || asked == null && attraction == null) return emptyList()
        val rows = NumberRows()
        for ((name, row) in WORDS) {
            val average = average(name)
            if (average.mean.isFinite()) rows.average(row.key, row.words, average, "", row.note)
        }
        return rows.list()
    }

    private fun distribution(): ClusterDistribution {
        val ofLast = sizes.sums(Clusters.of(last, criterion)).let { sizes.finish(it, 1) }
        val bins = (0 until ClusterSizes.bins).map { averages.average(ClusterSizes.NUMBERS.size + it) }
        val errors = DoubleArray(bins.size) { study.judgement.error(bins[it]) }
        return ClusterDistribution(
            DoubleArray(bins.size) {
                bins[it].mean
            },
            errors,
            ofLast.drop(ClusterSizes.NUMBERS.size),
        )
    }

    override fun write(page: ReportPage) {
        val found = Clusters.of(last, criterion)
        val several = Cluster.of(last, found, study.motion.rotation?.momentFactor ?: last.boundary.space.momentFactor)
        ClusterTable(study).write(several)
        val distribution = distribution()
        distribution.table().write(study.tables)
        val slope = average("slope").mean
        if (!distribution.isEmpty) {
            val curves = distribution.curves(slope, sizes.least)
            val figure = Chart.lines(curves, "members of a cluster s", "clusters n(s)", logX = true, logY = true)
            study.draw(page, figure, "cluster-sizes", "distribution of the sizes of clusters", sizesInWords(slope))
        }
        history.write(page, endless(found))
    }

    private fun sizesInWords(slope: Double): String {
        val line = if (slope.isNaN()) {
            ""
        } else {
            " The power law s^−τ, τ = ${ReportText.short(slope)}, is the likeliest from ${sizes.least} members on " +
                "(Clauset, Shalizi & Newman 2009), whether n is one or not."
        }
        return "Number of clusters of s members in a state; from 11 members on the mean over a bin of sizes. " +
            "Clusters that span the box are left out. " +
            "${study.judgement.bars()}$line"
    }

    private fun endless(found: Clusters): String {
        val along = "xyz".toList().filterIndexed { k, _ -> found.spans[k] }
        if (along.isEmpty()) return "No cluster of it goes on through the faces."
        return "A cluster of it goes on through the faces along ${along.joinToString(" and ")} without an end."
    }

    private class Row(val key: String, val words: String, val note: String = "")

    private companion object {
        /** Sums of radii for spheres that do not attract each other. */
        const val TOUCHING = 1.1
        const val FEWEST = 2
        const val MOST_FOLLOWED = 60
        val WORDS = mapOf(
            "clusters" to Row("cluster_count", "clusters of two spheres or more"),
            "share" to Row("cluster_share", "part of spheres in these"),
            "largest" to Row("largest_cluster", "spheres in the largest cluster"),
            "mean_size" to Row("cluster_size", "mean size of a cluster", "single spheres are clusters of one"),
            "mean_size_of_sphere" to Row(
                "cluster_size_of_sphere",
                "mean size of the cluster of a sphere",
                "Σ s²/Σ s over the clusters",
            ),
            "spanning_share" to Row("cluster_spanning_share", "part of spheres in clusters that span the box"),
            "slope" to Row("cluster_size_slope", "slope τ of the sizes of clusters", "of n(s) ∝ s^−τ, s ≥ 2"),
        )

        /** Null where no spheres attract each other. */
        fun attraction(scenario: Scenario, names: List<String>): ClusterCriterion? {
            if (scenario.interactions.isEmpty()) return null
            val check = ValueCheck("interaction")
            var all = ClusterCriterion(0.0)
            for (impact in scenario.impacts) {
                val ratio = impact.interaction?.interaction("interaction", check)?.attractiveReach ?: 0.0
                if (impact.between.isEmpty()) return ClusterCriterion(ratio).takeIf { ratio > 0 }
                val (i, j) = impact.between.map { names.indexOf(it) }
                if (i >= 0 && j >= 0) all = all.between(i, j, ratio)
            }
            return all.takeIf { it.reach > 0 }
        }
    }
}
