package daphnis.actors.region

import daphnis.actors.FaultKit
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger

/** Steps that regions take in epochs. */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RegionEpochsTest {
    /**
     * Takes steps with [engine] and with the serial one: [STEPS], and on until regions have shares, if these are
     * awaited: at first the coordinator is alone, until it tries whether that is quicker.
     */
    private fun advance(engine: CollisionEngine, told: Set<Int>, isShared: Boolean, make: Make) {
        val serial = make.simulation(SerialEngine())
        make.simulation(engine).use { s ->
            while (s.step < STEPS || isShared && told != setOf(0, 1)) {
                s.advance()
                serial.advance()
            }
            assertEquals(stateDigest(serial.population), stateDigest(s.population)) { engine.name }
        }
    }

    private fun interface Make {
        fun simulation(engine: CollisionEngine): Simulation
    }

    @Test
    fun `as users have it, a dilute gas goes in epochs, of which every region has its share`() {
        val n = 5000
        val edge = Math.cbrt(n * Math.PI / 6 / 0.02)
        val boundary = Periodic(Box.centred(edge, edge, edge))
        fun simulation(e: CollisionEngine) = simulationOf(
            randomSpheres(n, boundary, 1, 1.0) {
                0.5
            },
            boundary,
            0.1,
            ConstantRestitution(1.0),
            engine = e,
        )
        forEachEngine { engine, told ->
            advance(engine, told, isShared = true, make = ::simulation)
            assertEquals(setOf(0, 1), told) { engine.name }
        }
    }

    private fun forEachEngine(regions: Int = 0, test: (CollisionEngine, Set<Int>) -> Unit) {
        val told = ConcurrentHashMap.newKeySet<Int>()
        val probe = { region: Int ->
            told += region
        }
        test(RegionActorEngine(2, regions).also { it.probe = probe }, told)
        told.clear()
        test(PekkoEngine(2, regions).also { it.probe = probe }, told)
    }

    @Test
    fun `a dense gas of few spheres goes by neighbour lists, of which no region is told`() {
        assertEquals(List(2) { emptySet<Int>() }, toldOfCrowd(17, isShared = false))
    }

    @Test
    fun `regions have shares of what is measured of a dense gas of more spheres`() {
        assertEquals(List(2) { setOf(0, 1) }, toldOfCrowd(22, isShared = true))
    }

    /** Regions of each engine that have had shares of a dense gas of [edge]³ spheres. */
    private fun toldOfCrowd(edge: Int, isShared: Boolean): List<Set<Int>> {
        val (crowd, boundary) = FaultKit.crowd(edge)
        fun simulation(e: CollisionEngine) =
            simulationOf(crowd.copy(), boundary, 0.05, ConstantRestitution(1.0), engine = e)
        return buildList {
            forEachEngine { engine, told ->
                advance(engine, told, isShared, ::simulation)
                add(told.toSet())
            }
        }
    }

    @Test
    fun `of few spheres one region has all, and the coordinator is that region`() {
        forEachEngine { engine, told ->
            engine.use { it.advance(FaultKit.step()) }
            assertEquals(emptySet<Int>(), told) { engine.name }
        }
    }

    @Test
    fun `a share of a loop for which nobody waits any more does nothing`() {
        val runs = AtomicInteger()
        val loop = SharedLoop { _, from, to -> runs.addAndGet(to - from) }
        Share(loop, 3, 10).run(0)
        assertEquals(7, runs.get())
        loop.isAbandoned = true
        assertThrows(IllegalStateException::class.java) { Share(loop, 3, 10).run(0) }
        assertEquals(7, runs.get())
    }

    private companion object {
        const val STEPS = 12
    }
}
