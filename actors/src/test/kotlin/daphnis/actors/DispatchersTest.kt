package daphnis.actors

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.region.RegionLayout
import daphnis.core.boundary.Open
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import kotlin.coroutines.ContinuationInterceptor

/** Regions on whatever dispatcher there is, both ways of taking a step, one region to more than there are threads. */
@Timeout(120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class DispatchersTest {
    private val start = gas(600, 2).first
    private val expected = start.copy().also { p -> repeat(STEPS) { SerialEngine().advance(step(p)) } }

    private fun step(p: Population) =
        CollisionStep(p, Open, CollisionLaw(ConstantRestitution(0.9)), CollisionCounters()).also { it.duration = 0.1 }

    private fun engine(layout: RegionLayout, dispatcher: CoroutineDispatcher, shares: Boolean) =
        RegionActorEngine(2, layout, dispatcher).also {
            it.fewest = if (shares) 0 else Int.MAX_VALUE
            it.tuning =
                HorizonTuning(steps = 3, classBound = 3.0, deviation = 0.0, cellsAlong = 2.0, cellsAcross = 1.0)
        }

    private val layouts = listOf(RegionLayout.Stretches(1), RegionLayout.Stretches(7), RegionLayout.Blocks(2, 3, 2))

    @Test
    fun `any dispatcher, by steps that block and that suspend`() {
        val dispatchers =
            listOf(Dispatchers.Unconfined, Dispatchers.Default, Dispatchers.Default.limitedParallelism(1))
        for (layout in layouts) {
            for (dispatcher in dispatchers) {
                for (shares in listOf(false, true)) {
                    val p = start.copy()
                    engine(layout, dispatcher, shares).use { engine ->
                        engine.advance(step(p))
                        runBlocking { repeat(STEPS - 1) { engine.advanceSuspending(step(p)) } }
                    }
                    assertEquals(stateDigest(expected), stateDigest(p)) { "$layout, $dispatcher, shares: $shares" }
                }
            }
        }
    }

    @Test
    fun `the thread of the coroutine that waits for the step`() {
        for (layout in layouts) {
            for (shares in listOf(false, true)) {
                val p = start.copy()
                runBlocking {
                    val own = coroutineContext[ContinuationInterceptor] as CoroutineDispatcher
                    engine(layout, own, shares).use { engine -> repeat(STEPS) { engine.advanceSuspending(step(p)) } }
                }
                assertEquals(stateDigest(expected), stateDigest(p)) { "$layout, shares: $shares" }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `a hundred simulations on two threads of the default dispatcher`() {
        val two = Dispatchers.Default.limitedParallelism(2)
        runBlocking {
            for (k in 0 until 100) {
                launch {
                    val p = start.copy()
                    engine(layouts[1], two, shares = k % 2 == 0).use { engine ->
                        repeat(STEPS) { engine.advanceSuspending(step(p)) }
                    }
                    assertEquals(stateDigest(expected), stateDigest(p))
                }
            }
        }
    }

    private companion object {
        const val STEPS = 4
    }
}
