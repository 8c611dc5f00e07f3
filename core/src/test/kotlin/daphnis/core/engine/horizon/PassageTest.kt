package daphnis.core.engine.horizon

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.assertSameStep
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Collections
import java.util.IdentityHashMap

class PassageTest {
    private val boundary = Periodic(Box.centred(24.0, 24.0, 24.0))
    private val gas = randomSpheres(600, boundary, 3, 1.0) { 0.4 + 0.1 * it.nextDouble() }

    private fun simulation(engine: HorizonEngine) = simulationOf(gas.copy(), boundary, DT, engine = engine)

    @Test
    fun `two sets of arrays take turns, also where epochs are broken and begun anew`() {
        val engine = HorizonEngine(FixedPool(2), 0, HorizonTuning(5, deviation = 0.01))
        val simulation = simulation(engine)
        simulation.advance()
        simulation.advance()
        val places = Collections.newSetFromMap(IdentityHashMap<Any, Boolean>())
        val radii = Collections.newSetFromMap(IdentityHashMap<Any, Boolean>())
        for (step in 3..40) {
            // All have left their lines: in the middle of an epoch.
            if (step % 3 == 0) simulation.population.run { for (k in 0 until size) vx[k] = -vx[k] }
            simulation.advance()
            places += simulation.population.x
            radii += simulation.population.radius
        }
        assertEquals(2, places.size)
        assertEquals(2, radii.size)
        assertTrue(engine.epochs in 13..26) { "${engine.epochs} epochs" }
        assertTrue(simulation.collisions!!.counters.collisions > 100)
        engine.close()
    }

    @Test
    fun `a step that is refused in the middle of an epoch has changed nothing, and the next ones are right`() {
        val wrongs = listOf<Pair<String, Population.(k: Int) -> Unit>>(
            "outside the box" to { k -> x[k] += 24.0 },
            "vy of particle 7 is NaN" to { k -> vy[k] = Double.NaN },
            "mass of particle 7 is Infinity" to { k -> mass[k] = Double.POSITIVE_INFINITY },
            "radius of particle 7 is -Infinity" to { k -> radius[k] = Double.NEGATIVE_INFINITY },
            "x" to { k -> vx[k] = 1e9 },
        )
        for (threads in listOf(1, 3)) {
            val engine = HorizonEngine(FixedPool(threads), 0, HorizonTuning(6))
            val serial = simulationOf(gas.copy(), boundary, DT)
            val horizon = simulation(engine)
            for ((said, spoil) in wrongs) {
                repeat(3) {
                    serial.advance()
                    horizon.advance()
                    assertSameStep(serial, horizon, "before $said")
                }
                val p = horizon.population
                val good = p.copy()
                p.spoil(p.indexOf(7))
                val failure = assertThrows(IllegalArgumentException::class.java) { horizon.advance() }
                assertTrue(said in failure.message!!) { failure.message }
                val k = p.indexOf(7)
                p.x[k] = good.x[k]
                p.vx[k] = good.vx[k]
                p.vy[k] = good.vy[k]
                p.mass[k] = good.mass[k]
                p.radius[k] = good.radius[k]
            }
            repeat(3) {
                serial.advance()
                horizon.advance()
                assertSameStep(serial, horizon, "at the end")
            }
            assertTrue(engine.epochSteps > engine.epochs + 4)
            engine.close()
        }
    }

    @Test
    fun `a piece is known to be finite just where all of its spheres and their bodies are, on their lines or not`() {
        val space = EpochSpace(InlineLoop)
        val p = gas.copy()
        space.measure(p, boundary, DT)
        val tuning = HorizonTuning(4)
        assertTrue(space.frame.begin(tuning))
        space.cells.sort(p, tuning, 0.0)
        val passage = Passage(space, InlineLoop)
        val columns = p.columnsToWrite(false)
        passage.first(p, space.cells, columns)
        p.take(columns)
        space.frame.step = 1
        val look = passage.next(p, p.columnsToWrite(false))
        assertTrue(look.look(0, 0, p.size))
        // Left its line, and finite.
        p.vx[20] += 1.0
        assertTrue(look.look(0, 0, p.size))
        for (column in listOf(p.x, p.y, p.z, p.vx, p.vy, p.vz, p.radius, p.mass)) {
            for (bad in listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)) {
                val good = column[9]
                column[9] = bad
                assertFalse(passage.next(p, p.columnsToWrite(false)).look(0, 5, 10))
                column[9] = good
                assertTrue(passage.next(p, p.columnsToWrite(false)).look(0, 5, 10))
            }
        }
        // A radius and a mass whose sum is too large for a double are finite, and somebody else may say so.
        p.mass[9] = Double.MAX_VALUE
        p.radius[9] = Double.MAX_VALUE
        assertFalse(passage.next(p, p.columnsToWrite(false)).look(0, 5, 10))
        // So many are off their lines, or one has grown, that nobody looks further.
        val over = passage.next(p, p.columnsToWrite(false))
        over.look(0, 5, 10)
        assertFalse(over.look(0, 10, 11))
        assertFalse(passage.hasNext())
    }

    @Test
    fun `a deviation whose square is too large for a double is refused`() {
        assertThrows(IllegalArgumentException::class.java) { HorizonTuning(4, deviation = 1e155) }
        assertThrows(IllegalArgumentException::class.java) { HorizonTuning(4, deviation = Double.POSITIVE_INFINITY) }
        HorizonTuning(4, deviation = 1e3)
    }

    private companion object {
        const val DT = 0.05
    }
}
