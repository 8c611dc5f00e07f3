package daphnis.core.physics

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.population.VelocityMoments
import daphnis.core.run.CollisionStatistics
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI

/**
 * A patch around an oblate planet, κ/Ω = 0.95 and ν² = 2Ω² − κ²: what the shear s = (2 − ½ κ²/Ω²) Ω puts in, s² times
 * the viscosity, is what collisions take. With the shear of Kepler the two would differ by 7 %.
 */
@Tag("physics")
@Tag("thorough")
class OblatePatchTest {
    @Test
    fun `shear work is dissipation`() {
        val orbits = if (fullPhysics) 60 else 24
        val settings = listOf("frame.radialFactor=0.95", "frame.verticalFactor=1.0470554904112") +
            if (fullPhysics) emptyList() else listOf("box.lengths=[120,120,20]")
        val setup = ScenarioSetup.of(BuiltIn.scenario("ring-patch", settings), "ring-patch")
        val orbit = 2 * PI / setup.angularSpeed!!
        val start = 0.375 * orbits * orbit
        val statistics = CollisionStatistics(from = start)
        val flow = setup.boundary.meanFlow!!
        var stress = 0.0
        var samples = 0
        val sampling = Output { s ->
            if (s.time > start && s.step % 5 == 0L) {
                stress += VelocityMoments.of(s.population, flow, setup.frequencies).kinetic[VelocityMoments.XY]
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
        while (simulation.time < orbits * orbit) simulation.advance()
        val mass = simulation.population.mass.sum()
        val time = simulation.time - start
        val work = -flow.rate * (stress / samples + statistics.virial[1] / time / mass)
        assertPhysics(
            "s² ν / dissipation, κ/Ω = 0.95",
            1.0,
            work / (statistics.dissipated / time / mass),
            if (fullPhysics) 0.003 else 0.01,
        )
    }
}
