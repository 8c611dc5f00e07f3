package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.analysis.insitu.forEachVector
import kotlin.math.sqrt

/**
 * The neighbours of each particle of a state, with the vectors to them, nearest first: entries [start]`[i]` until
 * [start]`[i + 1]` of the sphere at index i of the population. Bodies have none and are none.
 */
public class NeighbourLists private constructor(
    private val start: IntArray,
    private val other: IntArray,
    private val vector: Array<DoubleArray>,
) {
    /** Number of spheres of the population, bodies included. */
    public val size: Int get() = start.size - 1

    /** Number of neighbours of the sphere at [index]. */
    public fun count(index: Int): Int = start[index + 1] - start[index]

    /** Index in the population of neighbour [k], from 0 on, of the sphere at [index]. */
    public fun neighbour(index: Int, k: Int): Int = other[start[index] + k]

    /** Component along [axis] of the vector from the sphere at [index] to its neighbour [k]. */
    public fun component(index: Int, k: Int, axis: Int): Double = vector[axis][start[index] + k]

    public companion object {
        private const val MOST_ATTEMPTS = 4

        /**
         * Of [state], by the rule [neighbours]. Where it takes more candidates than are near, the search goes farther,
         * up to three times as far; a particle that then still lacks some has all that were found. In a thin box a
         * particle may be a neighbour several times, by its images, and by them its own.
         *
         * @throws IllegalArgumentException where a box with images is less than a sixteenth as wide as the rule reaches
         */
        @JvmStatic
        @JvmOverloads
        public fun of(state: State, neighbours: Neighbours = Neighbours.SolidAngle): NeighbourLists {
            var reach = neighbours.reach(state)
            var attempt = 1
            while (true) {
                val found = Candidates(state, reach)
                val counts = found.counts(neighbours)
                if (counts.none { it < 0 } || attempt == MOST_ATTEMPTS) return found.lists(counts)
                reach *= 1.4
                attempt++
            }
        }
    }

    /** All pairs up to [reach] apart, by particle and distance. */
    private class Candidates(private val state: State, private val reach: Double) {
        private val p = state.population
        private val start = IntArray(p.size + 1)
        private val other: IntArray
        private val vector: Array<DoubleArray>
        private val distance: DoubleArray

        init {
            each { i, j, _, _, _ ->
                start[i + 1]++
                start[j + 1]++
            }
            for (i in 0 until p.size) start[i + 1] += start[i]
            val next = start.copyOf()
            val to = IntArray(start[p.size])
            val v = Array(3) { DoubleArray(to.size) }
            each { i, j, dx, dy, dz ->
                val a = next[i]++
                val b = next[j]++
                to[a] = j
                to[b] = i
                v[0][a] = dx
                v[1][a] = dy
                v[2][a] = dz
                v[0][b] = -dx
                v[1][b] = -dy
                v[2][b] = -dz
            }
            val length = DoubleArray(to.size) { sqrt(v[0][it] * v[0][it] + v[1][it] * v[1][it] + v[2][it] * v[2][it]) }
            // By distance, and of equal ones by index: whatever the order in which pairs were found.
            val order = IntArray(to.size) { it }
            for (i in 0 until p.size) sort(order, start[i], start[i + 1], length, to)
            other = IntArray(to.size) { to[order[it]] }
            vector = Array(3) { axis -> DoubleArray(to.size) { v[axis][order[it]] } }
            distance = DoubleArray(to.size) { length[order[it]] }
        }

        /** By insertion: there are some tens. */
        private fun sort(order: IntArray, from: Int, until: Int, length: DoubleArray, to: IntArray) {
            for (k in from + 1 until until) {
                val one = order[k]
                var at = k
                while (at > from) {
                    val before = order[at - 1]
                    val isLater = length[one] > length[before] || length[one] == length[before] && to[one] > to[before]
                    if (isLater) break
                    order[at--] = before
                }
                order[at] = one
            }
        }

        private inline fun each(action: (Int, Int, Double, Double, Double) -> Unit) {
            val square = reach * reach
            forEachVector(state, reach) { i, j, dx, dy, dz ->
                if (dx * dx + dy * dy + dz * dz <= square) action(i, j, dx, dy, dz)
            }
        }

        fun counts(rule: Neighbours): IntArray {
            var own = DoubleArray(64)
            return IntArray(p.size) { i ->
                val n = start[i + 1] - start[i]
                if (own.size < n) own = DoubleArray(2 * n)
                distance.copyInto(own, 0, start[i], start[i + 1])
                if (state.isParticle(i)) rule.count(own, n, state.dimensions) else 0
            }
        }

        /** With the first [counts] of each; all where it is −1. */
        fun lists(counts: IntArray): NeighbourLists {
            val first = IntArray(p.size + 1)
            for (i in 0 until p.size) {
                first[i + 1] = first[i] + if (counts[i] < 0) start[i + 1] - start[i] else counts[i]
            }
            val from = IntArray(first[p.size])
            for (i in 0 until p.size) for (k in first[i] until first[i + 1]) from[k] = start[i] + k - first[i]
            return NeighbourLists(
                first,
                IntArray(from.size) { other[from[it]] },
                Array(3) { axis -> DoubleArray(from.size) { vector[axis][from[it]] } },
            )
        }
    }
}
