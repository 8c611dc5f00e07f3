package daphnis.analysis.neighbour

import daphnis.core.population.Population
import daphnis.core.potential.PairInteractions

/**
 * Which spheres are linked to a cluster: those whose centres are up to a ratio times the sum of their radii apart, 1 for
 * surfaces that touch, by pair of materials (Stillinger 1963, J. Chem. Phys. 38, 1486). Immutable.
 *
 * ```java
 * ClusterCriterion near = new ClusterCriterion(1.05);
 * ClusterCriterion bound = ClusterCriterion.of(interactions, 2);
 * ```
 */
public class ClusterCriterion private constructor(private val others: Double, private val rows: List<List<Double>>) {
    /**
     * Every pair has this [ratio], a pure number.
     *
     * @throws IllegalArgumentException unless it is ≥ 0 and finite
     */
    public constructor(ratio: Double) : this(ratio, emptyList()) {
        check(ratio)
    }

    /** The largest ratio. */
    public val reach: Double get() = maxOf(others, rows.flatten().maxOrNull() ?: 0.0)

    /**
     * The same, but [ratio] for spheres of the materials of the numbers [first] and [second], in either order; 0 for
     * pairs that are never linked.
     */
    public fun between(first: Int, second: Int, ratio: Double): ClusterCriterion {
        check(ratio)
        require(first >= 0 && second >= 0) { "materials are $first and $second; their numbers must be at least 0" }
        val size = maxOf(rows.size, maxOf(first, second) + 1)
        val table = List(size) { i ->
            List(size) { j -> if (i == first && j == second || i == second && j == first) ratio else get(i, j) }
        }
        return ClusterCriterion(others, table)
    }

    /** The ratio of the materials of the numbers [first] and [second]. */
    public operator fun get(first: Int, second: Int): Double =
        if (first in rows.indices && second in rows.indices) rows[first][second] else others

    private fun check(ratio: Double) = require(ratio >= 0 && ratio.isFinite()) {
        "spheres of a cluster are up to $ratio sums of radii apart; it must be at least 0"
    }

    /** The ratios of spheres of [p], by their index. */
    internal fun table(p: Population): Table = Table(p)

    internal inner class Table(private val p: Population) {
        private val byMaterial = rows.isNotEmpty() && p.hasMaterials

        fun of(i: Int, j: Int): Double = if (byMaterial) get(p.material[i].toInt(), p.material[j].toInt()) else others
    }

    override fun toString(): String = if (rows.isEmpty()) "$others" else "$others, by material $rows"

    public companion object {
        /**
         * Spheres that attract each other, up to the outermost edge of their interaction that does
         * ([daphnis.core.potential.PairInteraction.attractiveReach]); pairs without attraction are never linked.
         *
         * @param materials how many materials the spheres have; 0 where none is named
         * @return null where no spheres attract each other
         */
        @JvmStatic
        public fun of(interactions: PairInteractions, materials: Int): ClusterCriterion? {
            var all = ClusterCriterion(interactions.others?.attractiveReach ?: 0.0)
            for (i in 0 until materials) {
                for (j in i until materials) all = all.between(i, j, interactions[i, j]?.attractiveReach ?: 0.0)
            }
            return all.takeIf { it.reach > 0 }
        }
    }
}
