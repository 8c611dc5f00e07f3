package daphnis.core.engine

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

@Timeout(60)
class SignsOfZeroTest {
    /** A layer of spheres whose z and v_z are zeros of both signs. */
    private fun layer(seed: Long): Population {
        val random = SeededRandom(seed)
        val n = 100
        val wide = if (seed % 2 == 0L) 2.5 else 2.1
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        fun zeros() = DoubleArray(n) { if (random.nextInt(2) == 0) 0.0 else -0.0 }
        val x = DoubleArray(n) { it % 10 * wide }
        val y = DoubleArray(n) { it / 10 * wide }
        return Population(x, y, zeros(), gauss(), gauss(), zeros(), DoubleArray(n) { 1.0 }, DoubleArray(n) { 1.0 })
    }

    @Tag("thorough")
    @Test
    fun `a flat layer with zeros of both signs has one digest and one record from every engine and in every order`() {
        val box = Box(-1.25, -1.25, -10.0, 25.0, 25.0, 10.0)
        for (seed in 1L..30L) {
            val start = layer(seed)
            val boundary = listOf(Open, Periodic(box), Walls(box, 0.0))[(seed % 3).toInt()]
            val engines =
                listOf(
                    SerialEngine(),
                    SerialEngine(),
                    IslandsEngine(FixedPool(3), fewest = 0),
                    ThreadPoolEngine(3),
                    BruteForceEngine(),
                )
            val ends = engines.mapIndexed { k, engine ->
                val p = if (k == 0) start.copy() else start.permuted(seed + k)
                simulationOf(p, boundary, 0.5, engine = engine).use { simulation ->
                    repeat(2) { _ -> simulation.advance() }
                    val record = simulation.collisions!!.record!!
                    val bits = (0 until record.size).map { k -> (0..2).map { record.separation(k, it).toRawBits() } }
                    stateDigest(p) to bits.hashCode()
                }
            }
            for (k in 1 until ends.size) assertEquals(ends[0], ends[k]) { "seed $seed, ${engines[k].name}" }
        }
    }
}
