package daphnis.analysis.insitu

import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Random
import kotlin.math.hypot

class PairsOfStateTest {
    /** A layer in a sheet of [EDGE], of spheres of radius 0.1, whose first is at [height]. */
    private fun layer(height: Double): State {
        val random = Random(4)
        fun column(width: Double) = DoubleArray(SPHERES) { (random.nextDouble() - 0.5) * width }
        val z = column(0.2).also { it[0] = height }
        val same = DoubleArray(SPHERES) { 0.1 }
        val p = Population(column(EDGE), column(EDGE), z, column(1.0), column(1.0), column(1.0), same, same)
        return State(p, HillSheet(Box(-EDGE / 2, -EDGE / 2, -5.0, EDGE / 2, EDGE / 2, 5.0), 1.0), 0.0, 1.0)
    }

    private fun within(state: State): Pair<Int, Long> {
        var found = 0
        val looked = forEachPair(state, REACH, inPlane = true) { _, _, square -> if (square < REACH * REACH) found++ }
        return found to looked
    }

    @Test
    fun `one sphere high above does not make a search in the plane look at more pairs`() {
        val (found, looked) = within(layer(0.0))
        assertEquals(found to looked, within(layer(400.0)))
        // 17 cells of the size of the reach, or smaller ones, for π of its squares.
        assertTrue(looked < 8L * found) { "$looked looked at for $found" }
    }

    @Test
    fun `pairs in the plane are those by x and y alone, through sliding faces too`() {
        val state = layer(400.0)
        val p = state.population
        var expected = 0
        for (i in 0 until SPHERES) {
            for (j in 0 until i) {
                var dx = p.x[i] - p.x[j]
                var dy = p.y[i] - p.y[j]
                dx -= EDGE * Math.rint(dx / EDGE)
                dy -= EDGE * Math.rint(dy / EDGE)
                if (hypot(dx, dy) < REACH) expected++
            }
        }
        assertEquals(expected, within(state).first)
    }

    private companion object {
        const val EDGE = 40.0
        const val REACH = 1.0
        const val SPHERES = 3000
    }
}
