package daphnis.core.engine.lists

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.population.Population
import daphnis.core.search.CellAxes.Companion.AXES
import kotlin.math.abs

/**
 * Compares the spheres at the start of a step with the ends of their paths in the step before, and puts in order what
 * belongs to those that are elsewhere: kicked, wrapped at a face, or moved by hand.
 */
internal class Comparison(
    private val rows: StepRows,
    private val space: ListSpace,
    private val lists: NeighbourLists,
    private val events: NextEvents,
) {
    /** Spheres that have another path, and whether they need another list. */
    private var found = IntArray(0)
    private var needsList = BooleanArray(0)
    private var count = 0
    private val boxes = IntArray(AXES)

    var changes = 0L
        private set
    var wraps = 0L
        private set

    fun reserve(spheres: Int) {
        if (needsList.size >= spheres) return
        found = IntArray(spheres)
        needsList = BooleanArray(spheres)
    }

    /**
     * Compares the [population] with the rows at the end of a step of [past], and makes times count from there.
     *
     * @return false when so many are elsewhere that everything is to be made anew
     */
    fun compare(population: Population, past: Double): Boolean {
        count = 0
        var moved = 0
        val state = rows.state
        val x = population.x
        val y = population.y
        val z = population.z
        val vx = population.vx
        val vy = population.vy
        val vz = population.vz
        val radius = population.radius
        val most = rows.size / PART + FEW
        for (k in 0 until rows.size) {
            events.shift(k, past)
            val p = k * STRIDE
            val rest = past - state[p + TIME]
            val u = state[p + VX]
            val v = state[p + VX + 1]
            val w = state[p + VX + 2]
            val isThere =
                x[k] == state[p] + u * rest && y[k] == state[p + 1] + v * rest && z[k] == state[p + 2] + w * rest
            val isSame = u == vx[k] && v == vy[k] && w == vz[k] && radius[k] == state[p + RADIUS]
            if (isThere && isSame) continue
            val isWrapped = !isThere && wrap(population, k, rest)
            if (isSame && (isThere || isWrapped)) continue
            needsList[k] = radius[k] != state[p + RADIUS] || !lists.isInShell(k, x[k], y[k], z[k])
            if (needsList[k] && ++moved > most) return false
            found[count++] = k
        }
        return true
    }

    /**
     * Takes over by how many boxes the sphere [k] is elsewhere than expected.
     *
     * @return whether it is where it was expected then
     */
    private fun wrap(population: Population, k: Int, rest: Double): Boolean {
        val p = k * STRIDE
        var isThere = true
        var isWrapped = false
        for (axis in 0 until AXES) {
            boxes[axis] = 0
            val by = population.position(axis)[k] - (rows.state[p + axis] + rows.state[p + VX + axis] * rest)
            if (!space.isPeriodic[axis]) {
                if (by != 0.0) isThere = false
                continue
            }
            val number = Math.rint(by / space.length[axis])
            if (abs(by - number * space.length[axis]) > space.margin / ROUNDINGS) isThere = false
            // A sphere so far away gets another list in any case.
            if (number == 0.0 || abs(number) > FARTHEST) continue
            boxes[axis] = number.toInt()
            isWrapped = true
        }
        if (isWrapped) {
            wraps++
            lists.wrap(k, boxes[0], boxes[1], boxes[2])
            events.wrap(k)
        }
        return isThere
    }

    /** Finds the next events of those that were found, and of those that are due, from the rows of the new step. */
    fun settle() {
        changes += count
        for (c in 0 until count) {
            val k = found[c]
            if (needsList[k]) lists.refresh(k, 0.0)
            if (lists.isLost) return
            events.bend(k)
        }
        for (k in 0 until rows.size) {
            if (events.isDue(k)) {
                if (events.isExit(k)) lists.refresh(k, 0.0)
                if (lists.isLost) return
                events.scan(k, 0.0)
            } else {
                events.goOn(k)
            }
        }
        for (c in 0 until count) events.scan(found[c], 0.0)
    }

    private companion object {
        /** All is made anew when more than one in so many, and some more, have left their shells. */
        const val PART = 4
        const val FEW = 16
        const val FARTHEST = 16.0

        /** A wrap may be as wrong as this part of the margin. */
        const val ROUNDINGS = 1000.0
    }
}
