package daphnis.core.swap

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.merging.MergeRule
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Conserved
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.search.Overlap
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What a swap moves and what stays, and how a step with swaps is taken back. */
class SwapMovesTest {
    private val boundary = Periodic(Box.centred(7.0, 6.0, 5.0))

    private fun gas(): Population {
        val plain = randomSpheres(300, boundary, 4, 1.0) { it.nextDouble(0.2, 0.45) }
        val n = plain.size
        val spun = plain.withSpin(DoubleArray(n) { 0.1 * it }, DoubleArray(n) { 1.0 - it }, DoubleArray(n))
        return spun.withMaterial(IntArray(n) { it % 3 }, listOf("a", "b", "c"))
    }

    /** All that a sphere is but where it is, in the order of ids. */
    private fun bodies(p: Population) = p.indicesById().map { k -> (3..11).map { p.column(it)[k] } }

    private fun places(p: Population) = p.indicesById().map { k -> listOf(p.x[k], p.y[k], p.z[k]) }

    private fun compare(a: List<Double>, b: List<Double>) =
        a.indices.map { a[it].compareTo(b[it]) }.firstOrNull { it != 0 } ?: 0

    @Test
    fun `spheres go as a whole, places stay, no sum changes a bit, and nothing overlaps`() {
        val population = gas()
        val before = population.copy()
        val counters = CollisionCounters()
        val moves = SwapMoves(SwapRule(50.0, 9))
        moves.carryOut(population, boundary, Partition.Whole, 0.0, 1.0, counters)
        assertTrue(counters.swaps > 1000) { "${counters.swaps} of ${counters.swapAttempts}" }
        val moved = bodies(population).zip(bodies(before)).count { it.first != it.second }
        assertTrue(moved > population.size / 2) { "$moved" }
        assertEquals(bodies(before).sortedWith(::compare), bodies(population).sortedWith(::compare))
        assertEquals(places(before), places(population))
        val (sums, then) = Conserved.of(population) to Conserved.of(before)
        assertEquals(then.mass to then.kineticEnergy, sums.mass to sums.kineticEnergy)
        assertEquals(
            listOf(then.momentumX, then.momentumY, then.momentumZ),
            listOf(sums.momentumX, sums.momentumY, sums.momentumZ),
        )
        assertEquals(0.0, Overlap.deepest(population, boundary, 0.0).depth)
    }

    @Test
    fun `equal spheres that differ in mass or material swap too, and alike ones do not`() {
        fun count(mass: Double, material: Int): CollisionCounters {
            val p = Population(
                doubleArrayOf(-1.0, 1.0),
                DoubleArray(2),
                DoubleArray(2),
                doubleArrayOf(0.3, -0.4),
                DoubleArray(2),
                DoubleArray(2),
                doubleArrayOf(0.5, 0.5),
                doubleArrayOf(1.0, mass),
            ).withMaterial(intArrayOf(0, material), listOf("a", "b"))
            return CollisionCounters().also {
                SwapMoves(SwapRule(10.0)).carryOut(p, boundary, Partition.Whole, 0.0, 10.0, it)
                val first = if (it.swaps % 2 == 0L) 0.3 else -0.4
                assertEquals(first, p.vx[0])
            }
        }
        for (differ in listOf(count(2.0, 0), count(1.0, 1))) {
            assertEquals(differ.swapAttempts, differ.swaps)
            // Half of 200 draws are of a sphere and itself.
            assertTrue(differ.swaps in 70..130) { "${differ.swaps}" }
        }
        assertEquals(0, count(1.0, 0).swapAttempts)
    }

    @Test
    fun `as many are drawn in a time, however it is divided into steps`() {
        fun tried(steps: Int): Long {
            val counters = CollisionCounters()
            val moves = SwapMoves(SwapRule(0.37))
            val p = gas()
            for (k in 0 until steps) {
                moves.carryOut(p, boundary, Partition.Whole, 40.0 * k / steps, 40.0 * (k + 1) / steps, counters)
            }
            return counters.swapAttempts
        }
        // 0.37 · 40 · N draws, one in N of them of a sphere and itself.
        val n = gas().size
        for (steps in listOf(1, 7, 100_000)) assertEquals(0.37 * 40 * n, tried(steps).toDouble(), 30.0) { "$steps" }
    }

    private fun simulation(engine: CollisionEngine, fails: (Simulation) -> Boolean = { false }): Simulation {
        val law = CollisionForcing.builder(ConstantRestitution(1.0))
        val forcing = law.swaps(SwapRule(3.0, 5)).engine(engine).build()
        val output = Output { if (fails(it)) throw IllegalStateException("as asked") }
        return Simulation(gas().copy(), boundary, forcing, FixedTimeStep(0.05), outputs = listOf(output))
    }

    @Test
    fun `a step that fails after swaps is taken back with them, and done again to the same bits`() {
        val whole = simulation(SerialEngine())
        var failures = 0
        val torn = simulation(HorizonEngine(FixedPool(1), 0, HorizonTuning(3))) { it.step > 0 && failures++ % 2 == 0 }
        repeat(20) {
            whole.advance()
            val before = torn.population.copy()
            val counted = torn.collisions!!.counters.swaps
            assertThrows(IllegalStateException::class.java) { torn.advance() }
            for (place in 0..11) {
                assertArrayEquals(before.column(place), torn.population.column(place)) {
                    "column $place"
                }
            }
            assertEquals(counted, torn.collisions!!.counters.swaps)
            torn.advance()
        }
        assertEquals(bodies(whole.population), bodies(torn.population))
        assertEquals(stateDigest(whole.population), stateDigest(torn.population))
        assertEquals(whole.collisions!!.counters.swaps, torn.collisions!!.counters.swaps)
        assertNotEquals(bodies(gas()).map { it[3] }, bodies(torn.population).map { it[3] })
        assertTrue(whole.collisions!!.counters.swaps > 100)
    }

    @Test
    fun `in a step that keeps the order, what steps do not change is taken back too`() {
        val population = gas()
        val before = population.copy()
        population.beginStep()
        population.drift(0.0)
        val counters = CollisionCounters()
        SwapMoves(SwapRule(5.0)).carryOut(population, boundary, Partition.Whole, 0.0, 1.0, counters)
        assertTrue(counters.swaps > 100)
        assertNotEquals(bodies(before), bodies(population))
        population.takeStepBack()
        for (place in 0..11) assertArrayEquals(before.column(place), population.column(place)) { "column $place" }
    }

    @Test
    fun `a rate that is none, mergers and a mean flow are refused`() {
        for (rate in listOf(0.0, -1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { SwapRule(rate) }
        }
        val builder = CollisionForcing.builder(ConstantRestitution(1.0)).swaps(SwapRule(1.0))
        val forcing = builder.build()
        assertThrows(IllegalArgumentException::class.java) { builder.merging(MergeRule.always()).build() }
        val sheared = LeesEdwards(boundary.box, 0.1)
        val simulation = Simulation(gas(), sheared, forcing, FixedTimeStep(0.01))
        assertThrows(IllegalArgumentException::class.java) { simulation.advance() }
    }
}
