package daphnis.core.cluster

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.cluster.bricks.Bodies
import daphnis.core.cluster.bricks.BrickDivision
import daphnis.core.cluster.bricks.CutPlaces
import daphnis.core.cluster.bricks.Cuts
import daphnis.core.cluster.bricks.Cuts.Companion.AXES
import daphnis.core.cluster.bricks.HaloMargins
import daphnis.core.cluster.bricks.Territory
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.search.GridExtent
import daphnis.core.step.PreparedStep
import kotlin.math.ceil

/**
 * Decides how space is divided among the nodes of a crew: in the first steps, and every [STEPS] steps after that, since
 * spheres move. Cuts lie so that all bricks take the same time, as far as it was measured. All nodes decide the same,
 * from a sample of each one's spheres.
 *
 * @param whole the step, measured for all spheres
 * @param threads by rank; so many bricks each node has
 */
internal class NodePlan(
    private val turns: Turns,
    private val whole: PreparedStep,
    private val margins: HaloMargins,
    private val threads: IntArray,
) {
    private val bricks = threads.sum()

    /** The large ones among the spheres of all nodes. */
    val bodies = Bodies()

    /** Where the spheres of all nodes are. */
    val extent = GridExtent()

    /** The present territory. */
    lateinit var territory: Territory
        private set

    private var steps = 0
    private var due = 0
    private var interval = 1
    private var epoch = 0
    private var meanRadius = 0.0
    private var busyBefore = 0.0

    /**
     * Looks at the step that [whole] has measured, and decides on its [territory].
     *
     * @param busy seconds that this node has computed since the start
     * @throws IllegalArgumentException when spheres are too far apart, see [GridExtent.requireComputable]
     */
    fun prepare(population: Population, boundary: BoundaryConditions, busy: Double) {
        extent.take(whole.reach.measured, boundary)
        extent.requireComputable(whole.reach.largestRadius)
        if (steps++ < due) {
            findBodies(population)
            if (!territory.cuts.areOf(boundary)) {
                territory =
                    Territory(territory.cuts.within(boundary), boundary, ++epoch)
            }
            return
        }
        due = steps - 1 + interval
        interval = minOf(interval * MORE, STEPS)
        val sample = sample(population, busy)
        var sum = 0.0
        for (k in 0 until sample.size) sum += sample.radius[k]
        meanRadius = if (sample.size == 0) 0.0 else sum / sample.size
        margins.diameter = 2 * meanRadius
        findBodies(population)
        territory = Territory(cuts(sample, boundary), boundary, ++epoch)
    }

    /**
     * Some spheres of each node, the same on all nodes: the more of them, the longer it has computed for each since the
     * last time.
     */
    private fun sample(population: Population, busy: Double): SphereColumns {
        val all = turns.gather(doubleArrayOf(population.size.toDouble(), busy - busyBefore))
        busyBefore = busy
        val heaviest = all.indices.maxOf { weight(it, all) }
        val step = maxOf(1.0, all.sumOf { it[0] } / SAMPLE) * heaviest / weight(turns.rank, all)
        val count = ceil(population.size / step).toInt()
        return joined(population, IntArray(count) { minOf((it * step).toInt(), population.size - 1) })
    }

    /** Cost of a sphere of the node of [rank] over that of all, damped; 1 as long as too little was measured. */
    private fun weight(rank: Int, all: Array<DoubleArray>): Double {
        if (all.any { it[0] == 0.0 || it[1] < LEAST_SECONDS }) return 1.0
        val cost = all.indices.sumOf { all[it][1] * threads[it] } / all.sumOf { it[0] }
        val mine = all[rank][1] * threads[rank] / all[rank][0]
        return ((1 + mine / cost) / 2).coerceIn(1 / MOST_WEIGHT, MOST_WEIGHT)
    }

    /** The spheres of all nodes at their indices [mine], by rank. */
    private fun joined(population: Population, mine: IntArray): SphereColumns {
        val block = PopulationColumns.picked(population, mine)
        val parts = arrayOfNulls<SphereColumns>(turns.size)
        parts[turns.rank] = block
        turns.tell({ SphereBlock.write(this, block, 0, block.size) }) { from, message ->
            parts[from] = SphereBlock.read(message)
        }
        return PopulationColumns.joined(parts.filterNotNull())
    }

    /** See [Bodies.find]; asks the other nodes only when there may be some. */
    private fun findBodies(population: Population) {
        val largest = whole.reach.largestRadius
        val limit = meanRadius * Bodies.FACTOR
        if (largest <= limit) {
            bodies.take(NONE, largest)
            return
        }
        val large = (0 until population.size).filter { population.radius[it] > limit }
        var ordinary = 0.0
        for (k in 0 until population.size) {
            if (population.radius[k] <= limit) ordinary = maxOf(ordinary, population.radius[k])
        }
        val rest = doubleArrayOf(ordinary).also { turns.max(it) }
        val all = joined(population, large.take(Bodies.MOST + 1).toIntArray())
        if (all.size > Bodies.MOST) bodies.take(NONE, largest) else bodies.take(all, rest[0])
    }

    private fun cuts(sample: SphereColumns, boundary: BoundaryConditions): Cuts {
        val places = CutPlaces(sample, boundary)
        val clearance = DoubleArray(AXES) { 2 * whole.reach.bound[it] + bodies.ordinary + 2 * margins.least }
        val division = division(places, boundary)
        if (division != null) {
            val cuts = places.choose(division, bodies, clearance)
            if (Territory(cuts, boundary, 0).size == bricks) return cuts
        }
        return evenCuts(boundary)
    }

    /** The division into [bricks] bricks with the fewest copies of spheres; null when none is possible. */
    private fun division(places: CutPlaces, boundary: BoundaryConditions): BrickDivision? {
        if (places.count < 2) return null
        val shares = DoubleArray(AXES) { axis ->
            val width = 2 * (whole.reach.bound[axis] + bodies.ordinary) + margins.least
            if (places.canCut(axis) && extent.size[axis] > 0) width / extent.size[axis] else 0.0
        }

        // In how many bricks a sphere is on average, along one axis alone.
        fun copies(axis: Int, parts: Int): Double {
            if (parts == 1) return 1.0
            val planes = if (boundary.hasImages(axis)) parts else parts - 1
            return minOf(parts.toDouble(), 1 + 2 * planes * shares[axis])
        }
        val sides = (1..bricks).filter { bricks % it == 0 }
        return sides.flatMap { x -> sides.filter { bricks / x % it == 0 }.map { y -> Triple(x, y, bricks / x / y) } }
            .filter { (x, y, z) -> canCut(shares, x, y, z) }
            .map { (x, y, z) -> BrickDivision(x, y, z) }
            .minByOrNull { copies(0, it.x) * copies(1, it.y) * copies(2, it.z) }
    }

    private fun canCut(shares: DoubleArray, x: Int, y: Int, z: Int): Boolean =
        (x == 1 || shares[0] > 0) && (y == 1 || shares[1] > 0) && (z == 1 || shares[2] > 0)

    /** Parts of one width along the longest axis, wherever the spheres are. */
    private fun evenCuts(boundary: BoundaryConditions): Cuts {
        val axis = (0 until AXES).filter { it != boundary.shear?.slideAxis }.maxBy { extent.size[it] }
        val from = extent.from[axis]
        val least = Math.ulp(from) * 2 * bricks
        val length =
            maxOf(extent.size[axis], if (boundary.hasImages(axis)) 0.0 else maxOf(least, java.lang.Double.MIN_NORMAL))
        // Along an open axis the first of n parts has no plane below it.
        val first = if (boundary.hasImages(axis)) 0 else 1
        val planes = DoubleArray(bricks - first) { from + length * (it + first) / bricks }
        return Cuts(List(AXES) { if (it == axis) planes else DoubleArray(0) }, boundary)
    }

    private companion object {
        const val STEPS = 64
        const val MORE = 4
        const val SAMPLE = 8192.0

        /** Shorter times say little. */
        const val LEAST_SECONDS = 0.002
        const val MOST_WEIGHT = 4.0
        val NONE = PopulationColumns.joined(emptyList())
    }
}
