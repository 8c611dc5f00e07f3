package daphnis.core.engine.lists

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.growth.IntList
import daphnis.core.population.Population
import daphnis.core.search.CellAxes.Companion.AXES
import kotlin.math.abs

/**
 * Compares the spheres at the start of a step with the ends of their paths in the step before, and puts in order what
 * belongs to those that are elsewhere: kicked, wrapped at a face, or moved by hand.
 */
internal class Comparison(private val field: ListField, private val regions: ListRegions) {
    private val rows = field.rows
    private val space = field.space
    private val lists = field.lists

    /** What has been found of the spheres of a region. */
    private class Found {
        /** Spheres that are not where they were expected, or have grown; and those that are due to leave their shells. */
        val strange = IntList()
        val leaving = IntList()

        /** Number of spheres that are there, but fly elsewhere. */
        var bent = 0
    }

    private val ofRegion = ArrayList<Found>()

    /** Strange ones that have another path, and those of them that need another list. */
    private val found = IntList()
    private val moved = IntList()
    private val boxes = IntArray(AXES)

    var changes = 0L
        private set
    var wraps = 0L
        private set

    /**
     * Compares the [population] with the rows at the end of a step of [past], and makes times count from there.
     *
     * @return false when so many are elsewhere that everything is to be made anew
     */
    fun compare(population: Population, past: Double): Boolean {
        while (ofRegion.size < field.regions) ofRegion.add(Found())
        regions.each { compare(it, ofRegion[field.regionOf(it.sight.first)], population, past) }
        found.clear()
        moved.clear()
        val most = rows.size / PART + FEW
        for (r in 0 until field.regions) {
            val strange = ofRegion[r].strange
            for (k in 0 until strange.size) {
                look(population, strange[k], past)
                if (moved.size > most) return false
            }
        }
        return true
    }

    private fun compare(region: ListRegion, found: Found, population: Population, past: Double) {
        val state = rows.state
        val x = population.x
        val y = population.y
        val z = population.z
        val vx = population.vx
        val vy = population.vy
        val vz = population.vz
        val radius = population.radius
        val events = region.events
        found.strange.clear()
        found.leaving.clear()
        found.bent = 0
        for (k in region.sight.first until region.sight.end) {
            events.shift(k, past)
            if (events.isDue(k) && events.isExit(k)) found.leaving.add(k)
            val p = k * STRIDE
            val rest = past - state[p + TIME]
            val u = state[p + VX]
            val v = state[p + VX + 1]
            val w = state[p + VX + 2]
            val isThere =
                x[k] == state[p] + u * rest && y[k] == state[p + 1] + v * rest && z[k] == state[p + 2] + w * rest
            if (!isThere || radius[k] != state[p + RADIUS]) {
                found.strange.add(k)
            } else if (u != vx[k] || v != vy[k] || w != vz[k]) {
                found.bent++
                field.events.bend(k)
                field.events.settle(k)
                region.pending.add(k)
            }
        }
    }

    private fun look(population: Population, k: Int, past: Double) {
        val state = rows.state
        val p = k * STRIDE
        val v = p + VX
        val isThere = isThere(population, k, past - state[p + TIME])
        val isSame = state[v] == population.vx[k] &&
            state[v + 1] == population.vy[k] &&
            state[v + 2] == population.vz[k] &&
            population.radius[k] == state[p + RADIUS]
        if (isSame && isThere) return
        found.add(k)
        val isInShell = lists.isInShell(k, population.x[k], population.y[k], population.z[k])
        if (population.radius[k] != state[p + RADIUS] || !isInShell) moved.add(k)
    }

    /**
     * Takes over by how many boxes the sphere [k] is elsewhere than expected.
     *
     * @return whether it is where it was expected then
     */
    private fun isThere(population: Population, k: Int, rest: Double): Boolean {
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
            field.events.wrap(k)
        }
        return isThere
    }

    /** Finds the next events of those that were found, and of those that are due, from the rows of the new step. */
    fun settle() {
        changes += found.size + ofRegion.sumOf { it.bent }
        for (k in 0 until found.size) field.events.bend(found[k])
        for (r in 0 until field.regions) {
            val strange = ofRegion[r].strange
            for (k in 0 until strange.size) field.events.settle(strange[k])
        }
        // Those may have been put anywhere.
        regions.renewal.renewAlone(moved, 0.0)
        for (r in 0 until field.regions) regions.renewal.renew(ofRegion[r].leaving, 0.0)
        if (lists.isLost) return
        for (k in 0 until found.size) regions[field.regionOf(found[k])].pending.add(found[k])
        regions.each { region ->
            val events = region.events
            for (k in region.sight.first until region.sight.end) {
                if (events.isDue(
                        k,
                    )
                ) {
                    events.scan(k, 0.0)
                } else {
                    events.goOn(k)
                }
            }
        }
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
