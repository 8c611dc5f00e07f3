package daphnis.core.engine.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.QuickerWay
import daphnis.core.engine.SerialEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.search.Grid
import daphnis.core.search.GridExtent
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

@Timeout(120)
class BrickCrewTest {
    private val box = LongBox(5)

    private fun stepOf(p: Population) =
        CollisionStep(p, box.boundary, CollisionLaw(ConstantRestitution(0.5)), CollisionCounters()).also {
            it.duration = 0.01
        }

    private fun halves(): Territory {
        val long = if (box.slabs(2).x == 2) 0 else 1
        val middle = box.boundary.box.lower(long) + box.boundary.box.length(long) / 2
        val planes = List(3) { if (it == long) doubleArrayOf(box.boundary.box.lower(it), middle) else DoubleArray(0) }
        return Territory(Cuts(planes, box.boundary), box.boundary, 1)
    }

    @Test
    fun `a step that is late touches no sphere, and what it has left behind does not disturb the next`() {
        val p = box.population.copy()
        val whole = PreparedStep().also { it.measure(stepOf(p)) }
        val crew = BrickCrew(whole, HaloMargins())
        crew.settle(halves())
        val extent = GridExtent().also { it.measure(p, box.boundary, Grid.WHOLE, InlineLoop) }
        val before = stateDigest(p)
        for (rounds in 0..1) {
            var left = rounds
            assertEquals(BrickCrew.End.LATE, crew.compute(p.size, Bodies(), extent, InlineLoop) { left-- == 0 })
            assertEquals(before, stateDigest(p))
        }
        assertEquals(BrickCrew.End.AGREED, crew.compute(p.size, Bodies(), extent, InlineLoop) { false })
        crew.collect(null)
        crew.store(InlineLoop)
        val serial = box.population.copy().also { SerialEngine().advance(stepOf(it)) }
        assertEquals(stateDigest(serial), stateDigest(p))
    }

    @Test
    fun `a step that was late is taken serially and is no replay, since that depends on the machine`() {
        var now = 0L
        var perLook = 0L
        val quicker = QuickerWay {
            now += perLook
            now
        }
        val engine = BricksEngine(FixedPool(1), 1, box.slabs(2), HaloMargins(), quicker)
        val bricks = simulationOf(box.population.copy(), box.boundary, 0.01, engine = engine)
        val serial = simulationOf(box.population.copy(), box.boundary, 0.01)
        bricks.use {
            for (step in 0..QuickerWay.TRIAL + 1) {
                if (step > QuickerWay.TRIAL) perLook = 10 * QuickerWay.LEAST_PATIENCE
                bricks.advance()
                serial.advance()
                assertEquals(if (step < QuickerWay.TRIAL) 2 else 1, engine.bricks) { "step $step" }
            }
            assertEquals(stateDigest(serial.population), stateDigest(bricks.population))
            assertEquals(0L, bricks.collisions!!.counters.causalityReplays)
            assertTrue(bricks.collisions.counters.collisions > 0)
        }
    }
}
