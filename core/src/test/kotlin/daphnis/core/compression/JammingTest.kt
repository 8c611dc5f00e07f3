package daphnis.core.compression

import daphnis.core.Engines
import daphnis.core.Simulation
import daphnis.core.TimeStep
import daphnis.core.boundary.Box
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.physics.fullPhysics
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

/**
 * Random close packing, by the growth of Lubachevsky & Stillinger (1990): equal spheres from a fluid at the filling factor
 * 0.5 to the reduced pressure 5000, with the diameter 1 and the thermal speed 1 at the start.
 */
class JammingTest {
    /** Filling factor in the middle of a step and the reduced pressure in it: at first, and at the end. */
    private class Jam(private val early: Pair<Double, Double>, private val last: Pair<Double, Double>) {
        /** Where the pressure diverges, by Z = 3/(1 − φ/φ_J). */
        val end = last.first / (1 - 3 / last.second)
        val three = early.second * (1 - early.first / end)
    }

    private fun jam(count: Int, rate: Double, seed: Long): Jam {
        val radii = DoubleArray(count) { 0.5 }
        val edge = Math.cbrt(count * Math.PI / 6 / 0.5)
        val box = Box.centred(edge, edge, edge)
        val random = SeededRandom(seed)
        val p = GrownPlacement().place(radii, box, BooleanArray(3), random)
        val v = List(3) { DoubleArray(count) { random.nextGaussian() } }
        val spheres = Population(p.x, p.y, p.z, v[0], v[1], v[2], radii, DoubleArray(count) { 1.0 })
        val growing = GrowingSpheres(box, rate)
        var dt = 0.02
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = Engines.horizon(1))
        var early: Pair<Double, Double>? = null
        var last = 0.5 to 1.0
        Simulation(spheres, growing, forcing, TimeStep { dt }).use { simulation ->
            while (last.second < PRESSURE) {
                val before = growing.fillingFactor(spheres)
                simulation.advance()
                val z = growing.reducedPressure
                last = (before + growing.fillingFactor(spheres)) / 2 to z
                dt = minOf(0.05, 0.2 / (rate * z))
                if (early == null && z > EARLY) {
                    assertTrue(Overlap.deepest(spheres, growing, 0.0).depth < 1e-12)
                    early = last
                }
            }
            assertTrue(Overlap.deepest(spheres, growing, 0.0).depth < 1e-12)
        }
        return Jam(early!!, last)
    }

    @Test
    fun `equal spheres jam at random close packing, and the pressure diverges with three over the distance from it`() {
        val rates = if (fullPhysics) listOf(1e-1, 1e-2, 1e-3) else listOf(2e-2)
        val seeds = if (fullPhysics) 1L..4L else 1L..1L
        for (rate in rates) {
            val seen = seeds.map { jam(if (fullPhysics) 2000 else 500, rate, it) }
            val ends = seen.map { it.end }
            val mean = ends.average()
            val scatter = sqrt(ends.sumOf { (it - mean) * (it - mean) } / maxOf(1, ends.size - 1) / ends.size)
            val three = seen.map { it.three }.average()
            println("growth $rate: jammed at %.4f ± %.4f, Z (1 − φ/φ_J) = %.3f".format(mean, scatter, three))
            // Slower growth makes denser packings: 0.621, 0.644 and 0.650.
            assertEquals(
                if (rate > 5e-2) {
                    0.621
                } else if (rate > 5e-3) {
                    0.642
                } else {
                    0.650
                },
                mean,
                0.007,
            )
            assertEquals(3.0, three, 0.35)
        }
    }

    private companion object {
        const val EARLY = 500.0
        const val PRESSURE = 5000.0
    }
}
