package daphnis.actors.region

import daphnis.actors.FaultKit
import daphnis.actors.coroutine.CoroutineRegions
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.CollisionEngine
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.step.CollisionStep
import daphnis.core.surface.Restitution
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitAll
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CancellationException
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.atomic.AtomicInteger

/** Shares of loops at their limits: long loops, many regions, a coordinator that fails or does most of the work. */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RegionSharesTest {
    private val done = stateDigest(FaultKit.done.population)

    @Test
    fun `the shares of a long loop among many regions cover it once`() {
        val size = 4_000_000
        val coordinator = StepCoordinator(RegionMap(RegionLayout.Stretches(1000)))
        var end = 0
        coordinator.share(
            size,
            SharedLoop { _, from, to ->
                assertEquals(end, from)
                end = to
            },
        )
        while (true) {
            val command = coordinator.poll() ?: break
            coordinator.accept(coordinator.regions[command.region].handle(command))
        }
        assertEquals(size, end)
    }

    @Test
    fun `the most regions there can be share no more than memory allows`() {
        val told = ConcurrentHashMap.newKeySet<Int>()
        RegionActorEngine(2, RegionLayout.Stretches(RegionLayout.MOST)).use { engine ->
            engine.fewest = 0
            engine.probe = { if (it.phase == Phase.SHARE) told += it.region }
            val step = FaultKit.step()
            engine.advance(step)
            assertEquals(done, stateDigest(step.population))
        }
        assertEquals((0 until 32).toSet(), told)
    }

    @Test
    fun `what the coordinator throws in a loop comes out, when no region is at work any more`() {
        val error = OutOfMemoryError("on purpose")
        val begun = AtomicInteger()
        val ended = AtomicInteger()
        val regions = RegionLayout.Stretches(2)
        RegionSteps(regions, 2, InlineLoop, { r, a -> CoroutineRegions(Dispatchers.Default, r, a) }, {}).use { steps ->
            steps.fewest = 0
            steps.probe = {
                if (it.region == 1) {
                    begun.incrementAndGet()
                    Thread.sleep(50)
                    ended.incrementAndGet()
                }
            }
            val step = FaultKit.step()
            val isWanted = {
                if (begun.get() > 0) throw error
                true
            }
            assertSame(error, runCatching { steps.take(step, {}, isWanted) { it.awaitNews() } }.exceptionOrNull())
            assertEquals(1, ended.get())
            assertEquals(FaultKit.initial, stateDigest(step.population))
            steps.advance(step)
            assertEquals(done, stateDigest(step.population))
        }
    }

    private fun gas(spheres: Int, phi: Double): Pair<Population, BoundaryConditions> {
        val edge = Math.cbrt(spheres * Math.PI / 6 / phi)
        val boundary = Periodic(Box.centred(edge, edge, edge))
        return randomSpheres(spheres, boundary, 1, 1.0) { 0.5 } to boundary
    }

    /**
     * Ends a step from within its first collision, in gases where the coordinator's thread does all or much of it, at
     * last by neighbour lists.
     */
    private fun assertEnds(engine: () -> CollisionEngine, advance: (CollisionEngine, CollisionStep, Ender) -> Unit) {
        val gases = listOf(gas(300, 0.01), gas(300, 0.2), gas(1500, 0.2), gas(5000, 0.01), FaultKit.crowd())
        for ((population, boundary) in gases) {
            val ender = Ender()
            val law = Restitution {
                ender.end()
                1.0
            }
            val step = CollisionStep(population, boundary, CollisionLaw(law), CollisionCounters())
            step.duration = 0.3
            val before = stateDigest(population)
            engine().use { advance(it, step, ender) }
            assertEquals(before, stateDigest(population)) { "${population.size} spheres" }
            assertEquals(0, step.counters.collisions)
        }
    }

    private class Ender {
        @Volatile
        var end: () -> Unit = {}
    }

    @Test
    fun `closed from within a law, as users have it, a step leaves the population as before`() {
        for (make in listOf<() -> CollisionEngine>({ RegionActorEngine(2) }, { PekkoEngine(2) })) {
            assertEnds(make) { engine, step, ender ->
                ender.end = { engine.close() }
                assertEquals(
                    "the engine is closed",
                    assertThrows(CancellationException::class.java) { engine.advance(step) }.message,
                )
            }
        }
    }

    @Test
    fun `cancelled from within a law, as users have it, a step leaves the population as before`() {
        assertEnds({ RegionActorEngine(2) }) { engine, step, ender ->
            runBlocking {
                launch {
                    ender.end = { cancel() }
                    (engine as RegionActorEngine).advanceSuspending(step)
                }
            }
        }
    }

    @Test
    fun `coordinators take no thread of a dispatcher on which regions run`() {
        // As many as the dispatcher has threads. Each coordinator begins its own part when all of them have begun.
        val count = 64
        val together = CyclicBarrier(count)
        val engines = List(count) {
            RegionActorEngine(2, RegionLayout.Stretches(2), Dispatchers.IO).also { engine ->
                engine.fewest = 0
                engine.patience = 2_000_000_000
                val isFirst = AtomicInteger()
                engine.probe = { if (it.region == 0 && isFirst.getAndIncrement() == 0) together.await() }
            }
        }
        val digests = runBlocking {
            engines.map { engine ->
                async(Dispatchers.Default) {
                    engine.use {
                        FaultKit.step().also { step -> it.advanceSuspending(step) }
                    }
                }
            }.awaitAll().map { stateDigest(it.population) }
        }
        assertEquals(List(count) { done }, digests)
    }
}
