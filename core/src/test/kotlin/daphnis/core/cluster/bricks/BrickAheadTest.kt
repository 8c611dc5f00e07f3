package daphnis.core.cluster.bricks

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.assertThrows

/** Epochs of bricks, while whose last spheres come and go. */
@Timeout(120)
class BrickAheadTest {
    private val box = Periodic(Box(0.0, -3.0, -3.0, 40.0, 3.0, 3.0))

    /** Sphere 0 at rest, and 1, which flies towards it and would touch it in step 8. */
    private fun flight(vararg more: Sphere) =
        populationOf(Sphere(x = 10.0, r = 0.5), Sphere(x = 14.0, vx = -4.0, r = 0.5), *more)

    private fun Population.put(id: Int, x: Double, y: Double, vx: Double) {
        val k = indexOf(id)
        this.x[k] = x
        this.y[k] = y
        this.vx[k] = vx
    }

    /** Sixteen steps of two slabs, before which [act] moves spheres by hand; all agree, and none is computed twice. */
    private fun assertSame(start: Population, act: (step: Int, spheres: Population) -> Unit): Long {
        val serial = simulationOf(start.copy(), box, DT, ConstantRestitution(0.9))
        val ahead = BrickAhead.Choice(0, HorizonTuning(16))
        val engine = BricksTogether(FixedPool(1), BrickDivision(2, 1, 1), ahead = ahead)
        simulationOf(start.copy(), box, DT, ConstantRestitution(0.9), engine = engine).use { bricks ->
            for (step in 1..16) {
                for (simulation in listOf(serial, bricks)) {
                    act(step, simulation.population)
                    simulation.advance()
                }
                assertSameStep(serial, bricks, "step $step")
            }
        }
        assertEquals(32L, engine.crew.stepsAhead)
        assertEquals(0L, engine.redone)
        return serial.collisions!!.counters.collisions
    }

    @Test
    fun `nobody meets a sphere that has left the brick, though the two were about to touch`() {
        assertEquals(1L, assertSame(flight()) { _, _ -> })
        assertEquals(0L, assertSame(flight()) { step, p -> if (step == 3) p.put(1, 30.0, 2.0, 0.0) })
    }

    @Test
    fun `nobody meets a sphere that has left the brick, though it was about to leave its line, too`() {
        // It is a bit faster than its line has it, and beyond the deviation in step 6; it would touch 0 in step 8.
        val collisions = assertSame(flight()) { step, p ->
            if (step == 2) p.vx[p.indexOf(1)] -= 0.1
            if (step == 3) p.put(1, 30.0, 2.0, 0.0)
        }
        assertEquals(0L, collisions)
    }

    @Test
    fun `nobody who looks around finds a sphere that has left the brick`() {
        // 2 strikes 0 in step 5, which then flies towards the place where 1 would be.
        val third = Sphere(x = 8.55, vx = 1.0, r = 0.5)
        assertEquals(1L, assertSame(flight(third)) { step, p -> if (step == 3) p.put(1, 30.0, 2.0, 0.0) })
    }

    @Test
    fun `a sphere that comes back meets those that it was about to touch, even on the path that it had`() {
        val collisions = assertSame(flight()) { step, p ->
            if (step == 3) p.put(1, 30.0, 2.0, 0.0)
            if (step == 5) p.put(1, 14.0 - 4.0 * 4 * DT, 0.0, -4.0)
        }
        assertEquals(1L, collisions)
    }

    @Test
    fun `a sphere that has grown while it was away is met as large as it is`() {
        // So many at rest beside that cells are small.
        val rest = Array(160) { Sphere(x = 0.5 + it / 4, y = -3.0, z = -3.0 + 1.5 * (it % 4), r = 0.45) }
        val start = populationOf(Sphere(x = 10.0, r = 0.5), Sphere(x = 12.51, r = 0.5), *rest)
        val collisions = assertSame(start) { step, p ->
            if (step == 3) p.put(1, 30.0, 2.0, 0.0)
            if (step == 5) p.put(1, 12.51, 0.0, 0.0)
            if (step == 5) p.radius[p.indexOf(1)] = 2.0
            // Now 0 looks around from a new line, only a little ahead.
            if (step == 6) p.vx[p.indexOf(0)] = 0.31
        }
        assertEquals(1L, collisions)
    }

    @Test
    fun `after memory was too little for a step, nobody meets a sphere that has left the brick`() {
        val all = flight()
        val step = CollisionStep(all, box, CollisionLaw(ConstantRestitution(0.9)), CollisionCounters())
        val whole = PreparedStep()
        val brick = Brick(BrickAhead.Choice(0, HorizonTuning(16)))
        fun advance(number: Int, vararg ids: Int, end: () -> Unit = {}) {
            step.start = number * DT
            step.duration = DT
            whole.measure(step)
            val gathering = object : Gathering {
                override val count = 2

                override fun into(spheres: BrickSpheres) {
                    spheres.add(all, IndexRuns().also { runs -> ids.forEach(runs::add) }, true)
                    end()
                }
            }
            brick.solve(whole, DoubleArray(3), Halt(), isAgain = false, gathering)
        }
        advance(0, 0, 1)
        assertThrows<OutOfMemoryError> { advance(1, 0) { throw OutOfMemoryError("a test") } }
        for (number in 1..9) {
            advance(number, 0)
            assertEquals(0L, brick.counted.collisions)
        }
        assertEquals(10L, brick.stepsAhead)
    }

    @Test
    fun `when all spheres leave their lines, the next epoch begins without those that have left the brick`() {
        val row = Array(60) { Sphere(x = 0.5 + 0.6 * it, y = -2.5, r = 0.1) }
        val collisions = assertSame(flight(*row)) { step, p ->
            if (step == 3) p.put(1, 38.0, 2.0, 0.0)
            if (step == 5) for (k in 0 until p.size) if (p.id[k] > 1) p.vz[k] += 1.0
        }
        assertEquals(0L, collisions)
    }

    @Test
    fun `a gas whose spheres cross halos all the time is computed in epochs, and hardly twice`() {
        val start = randomSpheres(400, box, 3, 1.0) { 0.3 }
        val serial = simulationOf(start.copy(), box, 0.05, ConstantRestitution(0.9))
        val ahead = BrickAhead.Choice(0, HorizonTuning(12))
        val engine = BricksTogether(FixedPool(2), BrickDivision(3, 1, 1), ahead = ahead)
        simulationOf(start.copy(), box, 0.05, ConstantRestitution(0.9), engine = engine).use { bricks ->
            for (step in 1..60) {
                serial.advance()
                bricks.advance()
                assertSameStep(serial, bricks, "step $step")
            }
        }
        assertTrue(serial.collisions!!.counters.collisions > 300)
        assertTrue(engine.crew.stepsAhead > 150) { "${engine.crew.stepsAhead} of 180 steps ahead" }
        assertTrue(engine.redone < 5) { "${engine.redone} computed twice" }
    }

    @Test
    fun `when more than a part of the spheres are new, places are given anew`() {
        val spheres = BrickSpheres()
        val all = populationOf(*Array(40) { Sphere(x = it.toDouble()) })
        fun gather(range: IntRange) = spheres.add(all, IndexRuns().also { runs -> for (k in range) runs.add(k) }, true)
        spheres.begin(20)
        gather(0..<20)
        spheres.goOn()
        gather(4..<24)
        spheres.settle()
        assertEquals(listOf(20, 24), listOf(spheres.own, spheres.size))
        assertEquals(listOf(0, 1, 2, 3), spheres.left.toArray().asList())
        assertEquals(listOf(20, 21, 22, 23), spheres.entered.toArray().asList())
        assertEquals(false, spheres.areTooMany)
        spheres.goOn()
        gather(0..<40)
        assertEquals(true, spheres.areTooMany)
    }

    private companion object {
        const val DT = 0.1
    }
}
