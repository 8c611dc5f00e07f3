package daphnis.core.engine.bricks

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import org.junit.jupiter.api.Assertions.assertNotSame
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

class TerritoryPlanTest {
    private val box = Box.centred(20.0, 20.0, 20.0)
    private val boundary = Periodic(box)
    private val whole = PreparedStep()
    private val plan = TerritoryPlan(whole, HaloMargins(), 2, BrickDivision(2, 1, 1))

    private fun territory(count: Int, boundary: BoundaryConditions = this.boundary): Territory {
        val p: Population = randomSpheres(count, boundary, 3, 1.0) { 0.3 }
        val step = CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(0.5)), CollisionCounters())
        step.duration = 0.01
        whole.measure(step)
        plan.prepare(InlineLoop)
        return plan.territory!!
    }

    /** The steps after which space is not divided anew for their number alone. */
    private fun begun(): Territory {
        territory(80)
        return territory(80)
    }

    @Test
    fun `space stays as it is divided while little changes`() {
        val first = begun()
        assertSame(first, territory(80))
        assertSame(first, territory(71))
    }

    @Test
    fun `space is divided anew when many spheres have gone or come`() {
        val first = begun()
        val fewer = territory(69)
        assertNotSame(first, fewer)
    }

    @Test
    fun `space is divided anew in another box`() {
        val first = begun()
        assertNotSame(first, territory(80, Periodic(box)))
    }
}
