package daphnis.core.engine.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.stateDigest
import daphnis.core.search.Grid
import daphnis.core.search.GridExtent
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class BrickCrewTest {
    private val box = LongBox(5)
    private val p = box.population
    private val step =
        CollisionStep(p, box.boundary, CollisionLaw(ConstantRestitution(0.5)), CollisionCounters()).also {
            it.duration = 0.01
        }
    private val whole = PreparedStep().also { it.measure(step) }
    private val crew = BrickCrew(whole, HaloMargins(0.0, 0.0))

    private fun compute(isLate: () -> Boolean): BrickCrew.End {
        val long = if (box.slabs(2).x == 2) 0 else 1
        val middle = box.boundary.box.lower(long) + box.boundary.box.length(long) / 2
        val planes = List(3) { if (it == long) doubleArrayOf(box.boundary.box.lower(it), middle) else DoubleArray(0) }
        crew.settle(Territory(Cuts(planes, box.boundary), box.boundary, 1))
        val extent = GridExtent().also { it.measure(p, box.boundary, Grid.WHOLE, InlineLoop) }
        return crew.compute(Bodies(), extent, InlineLoop, isLate)
    }

    @Test
    fun `a step that is late is called late, which no replay is counted for, and touches no sphere`() {
        val before = stateDigest(p)
        assertEquals(BrickCrew.End.LATE, compute { true })
        assertEquals(before, stateDigest(p))
        assertEquals(BrickCrew.End.AGREED, compute { false })
        assertEquals(before, stateDigest(p))
    }
}
