package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.engine.CollisionForcing
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.population.VelocityMoments
import daphnis.core.run.CollisionStatistics
import daphnis.core.search.Overlap
import daphnis.core.surface.BridgesRestitution
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Section 5 of the validation targets: steady states of ring patches in Hill's frame, measured by an independent code.
 * Ω = 1, r = 1, equal spheres, no gravity, 0.34 law with r Ω = 0.01948 cm/s.
 */
@Tag("physics")
class RingPatchTest {
    private class Case(
        val depth: Double,
        val dispersion: Double,
        val sigma: List<Double>,
        val height: Double,
        val midplane: Double,
        val collisions: Double,
        val local: Double,
        val nonlocal: Double,
        val orbits: Int,
    )

    private val cases = listOf(
        Case(0.1, 4.55, listOf(3.53, 1.77, 2.25), 2.32, 0.023, 1.75, 0.270, 0.065, 130),
        Case(0.5, 3.72, listOf(2.79, 1.56, 1.89), 2.21, 0.114, 8.99, 0.752, 0.402, 40),
        Case(1.0, 2.95, listOf(2.10, 1.38, 1.54), 2.16, 0.22, 18.95, 0.670, 0.859, 40),
        Case(2.0, 2.45, listOf(1.62, 1.28, 1.31), 2.49, 0.35, 44.3, 0.487, 1.859, 40),
    )

    @Test
    fun `steady states of ring patches`() {
        val measured = if (fullPhysics) cases else listOf(cases[1])
        for (case in measured) {
            measure(case, if (fullPhysics) 3000 else 1000, if (fullPhysics) case.orbits else 24)
        }
    }

    private fun measure(case: Case, count: Int, orbits: Int) {
        val edge = sqrt(count * PI / case.depth)
        val box = Box.centred(edge, edge, 16.0 + 8 * case.depth)
        val random = SeededRandom(count.toLong())
        val p = RandomPlacement().place(DoubleArray(count) { 1.0 }, box, booleanArrayOf(false, false, true), random)
        fun gauss() = DoubleArray(count) { 2.0 * random.nextGaussian() }
        val vy = gauss().also { for (k in it.indices) it[k] -= 1.5 * p.x[k] }
        val population =
            Population(p.x, p.y, p.z, gauss(), vy, gauss(), DoubleArray(count) { 1.0 }, DoubleArray(count) { 1.0 })
        val start = 2 * PI * orbits * (1 - AVERAGED)
        val statistics = CollisionStatistics(from = start)
        val sheet = HillSheet(box, 1.0)
        val moments = DoubleArray(6)
        var stress = 0.0
        var height = 0.0
        var midplane = 0.0
        var samples = 0
        val sampling = Output { s ->
            if (s.time > start && s.step % 10 == 0L) {
                samples++
                val m = VelocityMoments.of(s.population, sheet.meanFlow, OrbitalFrequencies(1.0))
                for (k in moments.indices) moments[k] += m.moments[k]
                stress += m.kinetic[VelocityMoments.XY]
                height += m.scaleHeight
                // Volume of the spheres within ±0.1 of the middle plane, by where they are cut.
                midplane +=
                    (0 until count).sumOf { k -> slab(s.population.z[k] - m.centreZ, 0.1) } / (0.2 * edge * edge)
            }
        }
        val forcing = CollisionForcing(BridgesRestitution(0.34, -0.234, 0.01948), recordCollisions = true)
        val simulation =
            Simulation(
                population,
                sheet,
                forcing,
                FixedTimeStep(2 * PI / 200),
                listOf(HillFrame(1.0)),
                listOf(statistics, sampling),
            )
        repeat(orbits * 200) { simulation.advance() }
        val time = simulation.time - start
        fun mean(k: Int) = moments[k] / samples
        val name = "τ = ${case.depth}"
        val bound = if (fullPhysics) 0.03 else 0.05
        assertPhysics("c/rΩ, $name", case.dispersion, sqrt(mean(0) + mean(1) + mean(2)), bound)
        if (fullPhysics) for (k in 0..2) assertPhysics("σ_${"xyz"[k]}/rΩ, $name", case.sigma[k], sqrt(mean(k)), bound)
        assertPhysics("H/r, $name", case.height, height / samples, bound)
        if (fullPhysics) assertPhysics("midplane filling factor, $name", case.midplane, midplane / samples, 0.05)
        assertPhysics(
            "collisions/particle/orbit, $name",
            case.collisions,
            2.0 * statistics.count / count / time * 2 * PI,
            bound,
        )
        val local = stress / samples / 1.5
        val nonlocal = statistics.virial[1] / time / count / 1.5
        assertPhysics("ν_loc/r²Ω, $name", case.local, local, if (fullPhysics) 0.06 else 0.12)
        assertPhysics("ν_nonloc/r²Ω, $name", case.nonlocal, nonlocal, if (fullPhysics) 0.06 else 0.08)
        assertPhysics(
            "2.25 Ω² ν / dissipation, $name",
            1.0,
            2.25 * (local + nonlocal) / (statistics.dissipated / time / count),
            0.02,
        )
        assertBelow("deepest overlap, $name", Overlap.deepest(population, sheet, simulation.time).depth, 1e-11)
    }

    /** Volume of a unit sphere centred at [z] between −h and h. */
    private fun slab(z: Double, h: Double): Double {
        fun below(a: Double): Double = a.coerceIn(-1.0, 1.0).let { PI * (2.0 / 3 + it - it * it * it / 3) }
        return if (abs(z) > 1 + h) 0.0 else below(h - z) - below(-h - z)
    }

    private companion object {
        /** Part of the run that is averaged: the last 25 of 40 orbits. */
        const val AVERAGED = 0.625
    }
}
