package daphnis.core.swap

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.StepRows
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.SphereQuantity.Change
import daphnis.core.population.optional
import daphnis.core.random.CounterRandom
import daphnis.core.search.CellRuns
import daphnis.core.search.Grid
import daphnis.core.search.SearchStructure
import daphnis.core.wall.Wall
import kotlin.math.floor

/** Swaps places of spheres at the end of steps, one pair after the other. */
internal class SwapMoves(private val rule: SwapRule) {
    private val random = CounterRandom(rule.seed)

    // Positions stay, so the cells do while radii are swapped; of one class, whose largest radius stays too.
    private val grid = Grid()
    private val runs = CellRuns(grid)
    private val probe = DoubleArray(StepRows.STRIDE)

    /**
     * The draws of the step from [start] to [end], at its end. Where nodes hold the spheres each of them does all of it, for
     * the spheres of all, and counts the pairs of which it has the first.
     */
    fun carryOut(
        population: Population,
        boundary: BoundaryConditions,
        partition: Partition,
        start: Double,
        end: Double,
        counters: CollisionCounters,
    ) {
        val count = doubleArrayOf(population.size.toDouble())
        partition.add(count)
        val draws = (floor(rule.rate * count[0] * end) - floor(rule.rate * count[0] * start)).toLong()
        if (draws <= 0 || count[0] < 2) return
        val there = SphereQuantity.present(population.optional).filter { it in MOVED || it in POSITIONS }.toIntArray()
        population.sets.separateFixed()
        val all = partition.everyone(population, there)
        val then = boundary.at(end)
        grid.build(all, then, end, 0.0, NOWHERE, structure = SearchStructure.GRID)
        val series = Series(all, byId(population, all), there, then.walls.toList(), end)
        for (draw in 0 until draws) {
            random.draw(draw.toInt(), start, STREAM + (draw ushr Int.SIZE_BITS).toInt())
            val first = series.drawn(random.uniform(0))
            val second = series.drawn(random.uniform(1))
            if (series.areAlike(first, second)) continue
            val isOwn = first < population.size
            if (isOwn) counters.swapAttempts++
            if (!series.swap(first, second)) continue
            if (isOwn) counters.swaps++
        }
        if (all === population) return
        for (place in series.moved) all.column(place).copyInto(population.column(place), 0, 0, population.size)
    }

    /** The indices of [all] in the order of their ids. */
    private fun byId(population: Population, all: SphereColumns): IntArray {
        val places = population.idPlaces
        val at = IntArray(places.count) { -1 }
        for (k in 0 until all.size) at[places.of(all.id[k])] = k
        return if (all.size == at.size) at else at.filter { it >= 0 }.toIntArray()
    }

    /** The draws of one step among the spheres [all], of which there are the columns [there]. */
    private inner class Series(
        private val all: SphereColumns,
        private val byId: IntArray,
        there: IntArray,
        private val walls: List<Wall>,
        private val time: Double,
    ) {
        val moved = there.filter { it in MOVED }.toIntArray()
        private val columns = Array(moved.size) { all.column(moved[it]) }
        private val kinds = there.filter { it in KINDS }.map { all.column(it) }.toTypedArray()
        private val radius = all.radius

        fun drawn(uniform: Double): Int = byId[(uniform * byId.size).toInt()]

        fun areAlike(a: Int, b: Int): Boolean {
            for (kind in kinds) if (kind[a] != kind[b]) return false
            return true
        }

        /** @return false for two of which the larger has no room at the place of the other; then nothing has changed */
        fun swap(a: Int, b: Int): Boolean {
            val isFree = if (radius[a] > radius[b]) hasRoom(a, b) else radius[a] == radius[b] || hasRoom(b, a)
            if (isFree) for (column in columns) column[a] = column[b].also { column[b] = column[a] }
            return isFree
        }

        /** Whether the sphere [large] would touch nothing at the place of [small]; of these two the sum of radii stays. */
        private fun hasRoom(large: Int, small: Int): Boolean {
            val r = radius[large]
            val x = all.x[small]
            val y = all.y[small]
            val z = all.z[small]
            for (wall in walls) if (wall.distance(x, y, z, time) < r) return false
            probe[0] = x
            probe[1] = y
            probe[2] = z
            probe[StepRows.RADIUS] = r
            val images = grid.images
            for (run in 0 until runs.around(probe, 0, 0.0)) {
                val image = runs.image[run]
                for (slot in runs.from[run] until runs.to[run]) {
                    val other = grid.order[slot]
                    if (other == large || other == small) continue
                    val dx = all.x[other] - x + images.shift(image, 0)
                    val dy = all.y[other] - y + images.shift(image, 1)
                    val dz = all.z[other] - z + images.shift(image, 2)
                    val s = r + radius[other]
                    if (dx * dx + dy * dy + dz * dz < s * s) return false
                }
            }
            return true
        }
    }

    private companion object {
        /** Of random numbers, apart from those of others with the seed of a scenario. */
        const val STREAM = 0x53574150
        val NOWHERE = DoubleArray(3)

        /** What does not stay where it is; times of collisions, by which guards know two spheres that stay close, do. */
        val MOVED = SphereQuantity.places { it.change == Change.KICKED || it.change == Change.NEVER }.toSet()
        val KINDS = SphereQuantity.places { it.change == Change.NEVER }.toSet()
        val POSITIONS = SphereQuantity.POSITION.places
    }
}
