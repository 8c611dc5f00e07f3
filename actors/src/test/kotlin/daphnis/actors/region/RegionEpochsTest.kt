package daphnis.actors.region

import daphnis.actors.FaultKit
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
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
    private fun advance(engine: CollisionEngine, told: Map<Phase, Set<Int>>, isShared: Boolean, make: Make) {
        val serial = make.simulation(SerialEngine())
        make.simulation(engine).use { s ->
            while (s.step < STEPS || isShared && told[Phase.SHARE] != setOf(0, 1)) {
                s.advance()
                serial.advance()
            }
            assertEquals(stateDigest(serial.population), stateDigest(s.population)) { engine.name }
        }
    }

    private fun interface Make {
        fun simulation(engine: CollisionEngine): Simulation
    }

    /** Phases in which each region was told something, while a gas at filling factor [phi] is carried on. */
    private fun phasesOf(engine: CollisionEngine, told: Map<Phase, Set<Int>>, phi: Double, dt: Double): Set<Phase> {
        val n = 5000
        val edge = Math.cbrt(n * Math.PI / 6 / phi)
        val boundary = Periodic(Box.centred(edge, edge, edge))
        fun simulation(e: CollisionEngine) =
            simulationOf(randomSpheres(n, boundary, 1, 1.0) { 0.5 }, boundary, dt, ConstantRestitution(1.0), engine = e)
        advance(engine, told, isShared = true, make = ::simulation)
        return told.keys
    }

    private fun forEachEngine(layout: RegionLayout? = null, test: (CollisionEngine, Map<Phase, Set<Int>>) -> Unit) {
        val told = ConcurrentHashMap<Phase, MutableSet<Int>>()
        val probe = { c: RegionCommand ->
            told.getOrPut(c.phase) { ConcurrentHashMap.newKeySet() } += c.region
            Unit
        }
        test(RegionActorEngine(2, layout).also { it.probe = probe }, told)
        told.clear()
        test(PekkoEngine(2, layout).also { it.probe = probe }, told)
    }

    @Test
    fun `as users have it, a dilute gas goes in epochs, of which every region has its share`() {
        forEachEngine { engine, told ->
            assertEquals(setOf(Phase.SHARE), phasesOf(engine, told, phi = 0.02, dt = 0.1)) { engine.name }
            assertEquals(setOf(0, 1), told[Phase.SHARE]) { engine.name }
        }
    }

    @Test
    fun `a dense gas of few spheres goes by neighbour lists, of which no region is told`() {
        assertEquals(List(2) { emptySet<Phase>() }, phasesOfCrowd(17, isShared = false))
    }

    @Tag("thorough")
    @Test
    fun `regions have shares of what is measured of a dense gas of more spheres`() {
        assertEquals(List(2) { setOf(Phase.SHARE) }, phasesOfCrowd(22, isShared = true))
    }

    /** Phases of each engine in a dense gas of [edge]³ spheres. */
    private fun phasesOfCrowd(edge: Int, isShared: Boolean): List<Set<Phase>> {
        val (crowd, boundary) = FaultKit.crowd(edge)
        fun simulation(e: CollisionEngine) =
            simulationOf(crowd.copy(), boundary, 0.05, ConstantRestitution(1.0), engine = e)
        val phases = ArrayList<Set<Phase>>()
        forEachEngine { engine, told ->
            advance(engine, told, isShared, ::simulation)
            phases += told.keys.toSet()
        }
        return phases
    }

    @Test
    fun `few spheres go by islands where somebody wants regions, else one thread has them all and asks none`() {
        forEachEngine { engine, told ->
            engine.use { it.advance(FaultKit.step()) }
            assertEquals(emptySet<Phase>(), told.keys) { engine.name }
        }
        forEachEngine(RegionLayout.Stretches(2)) { engine, told ->
            val step = FaultKit.step()
            when (engine) {
                is RegionActorEngine -> engine.fewest = step.population.size + 1
                is PekkoEngine -> engine.fewest = step.population.size + 1
            }
            engine.use { it.advance(step) }
            assertFalse(Phase.SHARE in told) { engine.name }
            assertTrue(Phase.SEARCH in told) { engine.name }
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
