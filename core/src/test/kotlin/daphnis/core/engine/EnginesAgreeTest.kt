package daphnis.core.engine

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** The engines of this module, and the serial one itself against every pair asked. */
class EnginesAgreeTest : EnginesAgreeContract(CoreEngines) {
    override val oracle = BruteForceEngine()

    @Tag("thorough")
    @Test
    fun `islands of very many spheres give the digest of the serial engine over a hundred steps, either way`() {
        val random = SeededRandom(11)
        val n = 21_000
        fun drawn(at: (Int) -> Int) = DoubleArray(n) { 2.6 * at(it) + 0.2 * random.nextDouble(-1.0, 1.0) }
        val x = drawn { it % 28 }
        val y = drawn { it / 28 % 28 }
        val z = drawn { it / 28 / 28 }
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        val start = Population(x, y, z, gauss(), gauss(), gauss(), DoubleArray(n) { 1.0 }, DoubleArray(n) { 1.0 })
        val boundary = Periodic(Box(-1.3, -1.3, -1.3, 71.5, 71.5, 71.5))
        fun simulation(engine: CollisionEngine) =
            simulationOf(start.copy(), boundary, 0.02, ConstantRestitution(0.9), engine = engine)
        val serial = simulation(SerialEngine())
        simulation(IslandsEngine(FixedPool(3))).use { islands ->
            for (step in 1..100) {
                serial.advance()
                islands.advance()
                if (step % 10 == 0) {
                    assertEquals(stateDigest(serial.population), stateDigest(islands.population)) { "step $step" }
                }
            }
            assertEquals(serial.collisions!!.counters.collisions, islands.collisions!!.counters.collisions)
        }
    }
}
