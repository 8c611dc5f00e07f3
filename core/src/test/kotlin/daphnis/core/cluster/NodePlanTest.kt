package daphnis.core.cluster

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.cluster.bricks.HaloMargins
import daphnis.core.cluster.bricks.Territory
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.hill.HillSheet
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.Random
import java.util.concurrent.Callable
import java.util.concurrent.Executors

@Timeout(60)
class NodePlanTest {
    private val random = Random(1)

    /** [count] spheres at rest in a long box, at places that [place] makes of numbers in 0..1. */
    private fun spheres(count: Int, place: (Double) -> Double): Population = Population(
        DoubleArray(count) { place(random.nextDouble()) },
        DoubleArray(count) { random.nextDouble() },
        DoubleArray(count) { random.nextDouble() },
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count) { 0.01 },
        DoubleArray(count) { 1.0 },
    )

    /**
     * The territories on which nodes with [threads] decide one after the other, when node k holds the spheres
     * `parts[k]` and computes for `busy[k]` seconds per step.
     */
    private fun plans(
        parts: List<Population>,
        boundary: BoundaryConditions,
        threads: IntArray,
        busy: DoubleArray,
    ): List<List<Territory>> {
        val room = MailRoom(parts.size)
        val pool = Executors.newFixedThreadPool(parts.size)
        val each = parts.indices.map { node ->
            Callable {
                val turns = Turns(room.mail(node))
                val whole = PreparedStep()
                val step =
                    CollisionStep(parts[node], boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
                step.duration = 0.01
                val plan = NodePlan(turns, whole, HaloMargins(), threads)
                List(2) {
                    whole.measure(step, InlineLoop) { all -> all.take(all.numbers().also { turns.max(it) }) }
                    plan.prepare(step.population, boundary, it * busy[node])
                    plan.territory
                }
            }
        }
        return try {
            pool.invokeAll(each).map { it.get() }
        } finally {
            pool.shutdownNow()
        }
    }

    private fun Territory.share(brick: Int, parts: List<Population>): Double {
        val total = parts.sumOf { it.size }
        return parts.sumOf { p -> (0 until p.size).count { ownerOf(p.x[it], p.y[it], p.z[it]) == brick } } / 1.0 / total
    }

    @Test
    fun `each brick gets as many spheres, however they are clumped, and all nodes decide the same`() {
        val boundary = Periodic(Box(0.0, 0.0, 0.0, 50.0, 1.0, 1.0))
        val parts = listOf(spheres(4000) { 50 * it * it * it }, spheres(2000) { 50 * it }, spheres(1000) { 20 + it })
        val all = plans(parts, boundary, intArrayOf(1, 2, 1), doubleArrayOf(0.0, 0.0, 0.0))
        for (territory in all.map { it[0] }) {
            assertEquals(4, territory.size)
            assertEquals(all[0][0].lower(0, 2), territory.lower(0, 2))
            for (brick in 0 until 4) assertEquals(0.25, territory.share(brick, parts), 0.01)
        }
    }

    @Test
    fun `a node whose spheres cost more gets fewer`() {
        val boundary = Periodic(Box(0.0, 0.0, 0.0, 50.0, 1.0, 1.0))
        val parts = listOf(spheres(4000) { 25 * it }, spheres(4000) { 25 + 25 * it })
        val before = plans(parts, boundary, intArrayOf(1, 1), doubleArrayOf(1.0, 1.0))[0][1]
        assertEquals(0.5, before.share(0, parts), 0.01)
        val after = plans(parts, boundary, intArrayOf(1, 1), doubleArrayOf(3.0, 1.0))[0][1]
        // Three times the cost is 1.5 of the mean; half of the way to it is 1.25 against 0.75.
        assertEquals(0.4, after.share(0, parts), 0.01)
        // Too short to say anything.
        val noise = plans(parts, boundary, intArrayOf(1, 1), doubleArrayOf(3e-4, 1e-4))[0][1]
        assertEquals(0.5, noise.share(0, parts), 0.01)
    }

    @Test
    fun `there are as many bricks as threads, wherever the spheres are`() {
        for (x in listOf(0.0, 1e17, -3e-300)) {
            for (count in listOf(0, 1, 2, 40)) {
                val parts = listOf(spheres(count) { x }, spheres(0) { x }, spheres(0) { x })
                val all = plans(parts, Open, intArrayOf(2, 1, 2), doubleArrayOf(1.0, 1.0, 1.0))
                for (territory in all.flatten()) assertEquals(5, territory.size) { "$count spheres at $x" }
            }
        }
    }

    @Test
    fun `a sheared box is cut into slabs across the shear, however many they are`() {
        val boundary = HillSheet(Box(0.0, 0.0, 0.0, 50.0, 1.0, 1.0), 0.31)
        val parts = List(2) { spheres(4000) { it * 50 } }
        for (territory in plans(parts, boundary, intArrayOf(32, 32), DoubleArray(2)).flatten()) {
            assertEquals(listOf(64, 1, 1), List(3) { territory.parts(it) })
        }
    }
}
