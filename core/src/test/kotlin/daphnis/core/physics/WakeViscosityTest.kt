package daphnis.core.physics

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.force.MeshGravity
import daphnis.core.population.VelocityMoments
import daphnis.core.run.CollisionStatistics
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.util.Locale
import kotlin.math.PI
import kotlin.math.cbrt
import kotlin.math.sqrt

/**
 * The viscosity of a patch with self-gravity wakes, all parts of it, against 26 r_h⁵ G² Σ²/Ω³ (Daisaka, Tanaka & Ida
 * 2001, Icarus 154, 296); r_h is the Hill radius of two spheres over the distance of their centres in contact. Units of
 * the patch: r = 1, Ω = 1; ε = 0.5. The short form is a small patch for a few orbits, which has wakes but no average
 * to speak of: there the energy balance is held.
 */
@Tag("physics")
class WakeViscosityTest {
    private class Seen(val ratio: Double, val balance: Double)

    @Tag("thorough")
    @Test
    fun `viscosity of wakes`() {
        if (!fullPhysics) {
            val seen = run(0.75, 0.5, 1, 2.0, 3.0, 5.0)
            assertPhysics("s² ν / dissipation with wakes, short", 1.0, seen.balance, 0.25)
            return
        }
        for ((hill, depth, seeds) in listOf(Triple(0.75, 0.5, 3))) {
            val seen = (1..seeds).map { run(hill, depth, it, 4.05, 4.0, 12.0) }
            val ratios = seen.map { it.ratio }
            val mean = ratios.average()
            val error = sqrt(ratios.sumOf { (it - mean) * (it - mean) } / (seeds - 1) / seeds)
            println(
                String.format(
                    Locale.ROOT,
                    "r_h %.2f, τ %.2f: viscosity over 26 r_h⁵G²Σ²/Ω³ %.3f ± %.3f, energy balance %.4f",
                    hill,
                    depth,
                    mean,
                    error,
                    seen.map { it.balance }.average(),
                ),
            )
            assertPhysics("s² ν / dissipation with wakes, r_h = $hill", 1.0, seen.map { it.balance }.average(), 0.05)
            assertPhysics("viscosity of wakes / 26 r_h⁵G²Σ²/Ω³, r_h = $hill", 1.0, mean, 0.15)
        }
    }

    /** A patch of [wavelengths] by as many critical wavelengths, from orbit [from] to orbit [until]. */
    private fun run(hill: Double, depth: Double, seed: Int, wavelengths: Double, from: Double, until: Double): Seen {
        // Ω² = 1 per unit of time squared: G ρ = 9 Ω² r_h³/π, λ = 48 π τ r_h³ r.
        val density = 9 * hill * hill * hill / PI
        val length = wavelengths * 48 * PI * depth * hill * hill * hill
        val settings = listOf(
            "frame={\"type\":\"hill\",\"angularSpeed\":1}",
            "seed=$seed",
            "box.lengths=[$length,$length,12]",
            "particles.sizes={\"type\":\"equal\",\"radius\":1}",
            "particles.density=$density",
            "particles.opticalDepth=$depth",
            "velocities.sigma=1",
            "restitution={\"type\":\"constant\",\"coefficient\":0.5}",
            "forces=[{\"type\":\"self-gravity\",\"method\":\"mesh\",\"constant\":1}]",
            "timeStep.steps=300",
        )
        val setup = ScenarioSetup.of(BuiltIn.scenario("ring-patch", settings), "ring-patch")
        val orbit = 2 * PI
        val statistics = CollisionStatistics(from = from * orbit)
        val flow = setup.boundary.meanFlow!!
        val gravity = setup.forces.filterIsInstance<MeshGravity>().first()
        var stress = 0.0
        var samples = 0
        val sampling = Output { s ->
            if (s.time > from * orbit && s.step % 10 == 0L) {
                stress += VelocityMoments.of(s.population, flow, setup.frequencies).kinetic[VelocityMoments.XY] +
                    gravity.stressXY(s.population, s.time) / s.population.mass.sum()
                samples++
            }
        }
        val simulation = Simulation(
            setup.population,
            setup.boundary,
            setup.collisions(recordCollisions = true),
            setup.timeStep,
            setup.forces,
            listOf(statistics, sampling),
        )
        while (simulation.time < until * orbit) simulation.advance()
        val mass = simulation.population.mass.sum()
        val time = simulation.time - from * orbit
        val work = -flow.rate * (stress / samples + statistics.virial[1] / time / mass)
        val viscosity = work / (flow.rate * flow.rate)
        val surface = mass / (length * length)
        val sphere = simulation.population.mass[0]
        check(Math.abs(cbrt(2 * sphere / 3) / 2 - hill) < 1e-9) { "r_h is ${cbrt(2 * sphere / 3) / 2}" }
        val balance = work / (statistics.dissipated / time / mass)
        println("r_h $hill seed $seed: ${simulation.population.size} spheres, viscosity $viscosity, balance $balance")
        return Seen(viscosity / (26 * Math.pow(hill, 5.0) * surface * surface), balance)
    }
}
