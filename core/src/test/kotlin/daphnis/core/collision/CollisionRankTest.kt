package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.boundary.prepare
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Newton's cradle: spheres in a row that touch, of which the first is struck. */
class CollisionRankTest {
    private val images = Images().apply { prepare(Open, 0.0) }

    @Test
    fun `a collision that another led to at the same time has the next rank, for both spheres, from either side`() {
        for (back in listOf(false, true)) {
            val rows = StepRows()
            val spheres = Array(4) { Sphere(x = 2.0 * it, vx = if (it == 0) 1.0 else 0.0) }
            rows.load(populationOf(*spheres), IntArray(4) { it }, 1.0, false)
            val law = CollisionLaw(ConstantRestitution(1.0))
            val outcome = CollisionOutcome()
            fun collide(a: Int, b: Int, time: Double): Int {
                law.collide(rows, if (back) b else a, if (back) a else b, 0, images, time, outcome)
                return outcome.rank
            }
            assertEquals(listOf(1, 2, 3), (0..2).map { collide(it, it + 1, 0.0) })
            assertEquals(listOf(1, 2, 3, 3), (0..3).map { rows.rank(it) })
            // Once the last is caught up later, it counts from the start again.
            rows.state[2 * StepRows.STRIDE + StepRows.VX] = 2.0
            assertEquals(1, collide(2, 3, 0.5))
        }
    }
}
