package daphnis.core.cluster.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.search.Grid
import daphnis.core.search.GridExtent
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

@Timeout(120)
class BrickCrewTest {
    private val box = LongBox(5)

    private fun stepOf(p: Population, law: Restitution) =
        CollisionStep(p, box.boundary, CollisionLaw(law), CollisionCounters()).also { it.duration = 0.15 }

    private fun halves(): Territory {
        val long = if (box.slabs(2).x == 2) 0 else 1
        val middle = box.boundary.box.lower(long) + box.boundary.box.length(long) / 2
        val planes = List(3) { if (it == long) doubleArrayOf(box.boundary.box.lower(it), middle) else DoubleArray(0) }
        return Territory(Cuts(planes, box.boundary), box.boundary, 1)
    }

    @Test
    fun `a step that fails touches no sphere, and what it has left behind does not disturb the next`() {
        for (ahead in listOf(BrickAhead.Choice.NEVER, BrickAhead.Choice(0, HorizonTuning(4)))) {
            val p = box.population.copy()
            var impacts = 0
            var most = 5
            val law = Restitution { if (++impacts > most) throw ArithmeticException("on purpose") else 0.5 }
            val step = stepOf(p, law)
            val whole = PreparedStep()
            val crew = BrickCrew(whole, HaloMargins(), ahead = ahead)
            crew.settle(halves())
            for (round in 1..4) {
                val before = stateDigest(p)
                val serial = p.copy().also { SerialEngine().advance(stepOf(it, ConstantRestitution(0.5))) }
                repeat(2) {
                    impacts = 0
                    most = 5
                    val e = assertThrows(ArithmeticException::class.java) { advance(crew, whole, step) }
                    assertEquals("on purpose", e.message)
                    assertEquals(before, stateDigest(p))
                }
                most = Int.MAX_VALUE
                advance(crew, whole, step)
                assertEquals(stateDigest(serial), stateDigest(p)) { "round $round" }
                box.boundary.endStep(p, 0.0)
            }
        }
    }

    private fun advance(crew: BrickCrew, whole: PreparedStep, step: CollisionStep) {
        whole.measure(step)
        val extent = GridExtent().also { it.measure(step.population, box.boundary, Grid.WHOLE, InlineLoop) }
        crew.compute(step.population.size, Bodies(), extent, InlineLoop)
        crew.collect(null)
        crew.store(InlineLoop)
    }
}
