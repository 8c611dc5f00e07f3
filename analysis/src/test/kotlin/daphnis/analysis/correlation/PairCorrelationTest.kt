package daphnis.analysis.correlation

import daphnis.analysis.insitu.Averages
import daphnis.analysis.uniform
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionForcing
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI

class PairCorrelationTest {
    @Test
    fun `an elastic gas has the contact value of Carnahan and Starling, and no bin spans both sides of contact`() {
        // 1000 spheres of diameter 1 at φ = 0.3, from a lattice.
        val edge = Math.cbrt(1000 * PI / 6 / 0.3)
        val random = SeededRandom(4)
        fun place(k: Int) = -edge / 2 + (k + 0.5) * edge / 10
        val population = Population(
            DoubleArray(1000) { place(it % 10) },
            DoubleArray(1000) { place(it / 10 % 10) },
            DoubleArray(1000) { place(it / 100) },
            DoubleArray(1000) { random.nextGaussian() },
            DoubleArray(1000) { random.nextGaussian() },
            DoubleArray(1000) { random.nextGaussian() },
            DoubleArray(1000) { 0.5 },
            DoubleArray(1000) { 1.0 },
        )
        val pairs = PairCorrelation(2.0, 25, nearest = 1.0)
        val averages = Averages(pairs, from = 2.0, every = 10)
        val box = Periodic(Box.centred(edge, edge, edge))
        val simulation =
            Simulation(
                population,
                box,
                CollisionForcing(ConstantRestitution(1.0)),
                FixedTimeStep(0.02),
                outputs = listOf(averages),
            )
        repeat(600) { simulation.advance() }
        val contact = (1 - 0.15) / (0.7 * 0.7 * 0.7)
        // On to contact from the middles of the first two bins.
        val measured = 1.5 * averages.average(0).mean - 0.5 * averages.average(1).mean
        assertEquals(contact, measured, 0.03 * contact)
        assertEquals(1.02, pairs.centre(0), 1e-12)
    }

    @Test
    fun `few particles have g = 1 on average, in each bin, within its error, in whatever box`() {
        val box = Box.centred(10.0, 12.0, 8.0)
        val boundaries =
            listOf<BoundaryConditions>(
                Periodic(box),
                LeesEdwards(box, 0.5),
                HillSheet(box, 1.0),
                HillSheet(box, 1.0, true),
                Periodic(box, false, true, true),
            )
        for (boundary in boundaries + listOf(Periodic(box, false, false, true), Periodic(box, false, false, false))) {
            val averages = Averages(PairCorrelation(4.0, 4))
            for (seed in 1L..1500L) averages.add(uniform(5, boundary, seed))
            for (bin in 0 until 4) {
                val g = averages.average(bin)
                assertEquals(1.0, g.mean, 4 * g.error) { "${boundary.javaClass.simpleName}, bin $bin" }
                assertTrue(g.error < 0.2)
            }
        }
    }

    @Test
    fun `distances reach half the shortest edge of the axes that are used, and no farther`() {
        val flat = Box.centred(10.0, 12.0, 3.0)
        assertEquals(1.5, PairCorrelation.farthest(Periodic(flat)))
        assertEquals(5.0, PairCorrelation.farthest(HillSheet(flat, 1.0)))
        assertTrue(PairCorrelation.isInPlane(HillSheet(flat, 1.0)))
        assertFalse(PairCorrelation.isInPlane(LeesEdwards(flat, 1.0)))
        val message = assertThrows(IllegalArgumentException::class.java) {
            PairCorrelation(2.0, 3).of(uniform(10, Periodic(flat)))
        }.message!!
        assertTrue("1.5" in message) { message }
        PairCorrelation(5.0, 3).of(uniform(10, HillSheet(flat, 1.0)))
        for (nearest in listOf(-1.0, 2.0, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) {
                PairCorrelation(2.0, 3, nearest)
            }
        }
    }
}
