package daphnis.core.physics

import daphnis.core.Engines
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Force
import daphnis.core.force.thermostat.Andersen
import daphnis.core.force.thermostat.WhiteNoise
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt

/** Gases in the steady state of a thermostat: van Noije & Ernst 1998, Granular Matter 1, 57. */
@Tag("physics")
class DrivenGasTest {
    private val filling = 0.02
    private val density = 6 / PI * filling
    private val contact = (1 - filling / 2) / ((1 - filling) * (1 - filling) * (1 - filling))

    /** ξ² at which T = 1, with the fourth cumulant [a2] of the steady state. */
    private fun intensity(e: Double, a2: Double) =
        (1 - e * e) * 4 / 3 * sqrt(PI) * density * contact * (1 + 3.0 / 16 * a2)

    private fun simulation(count: Int, seed: Long, e: Double, dt: Double, force: Force): Simulation {
        val box = cube(count, filling)
        val forcing = CollisionForcing(ConstantRestitution(e), engine = Engines.horizon(1))
        return Simulation(gas(count, box, seed, false), Periodic(box), forcing, FixedTimeStep(dt), listOf(force))
    }

    private fun moment(p: Population, power: Int): Double {
        var sum = 0.0
        for (k in 0 until p.size) {
            val square = p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
            sum += if (power == 2) square else square * square
        }
        return sum / p.size
    }

    /** Temperature and fourth cumulant, over [states] that are [apart], from time [from] on. */
    private fun steady(simulation: Simulation, from: Double, apart: Double, states: Int): Pair<Double, Double> {
        var square = 0.0
        var fourth = 0.0
        repeat(states) { k ->
            while (simulation.time < from + k * apart) simulation.advance()
            square += moment(simulation.population, 2) / states
            fourth += moment(simulation.population, 4) / states
        }
        return square / 3 to 0.6 * fourth / (square * square) - 1
    }

    @Test
    fun `white noise and collisions balance, and velocities have the fourth cumulant of theory`() {
        val count = if (fullPhysics) 50_000 else 3_000
        for ((e, a2) in listOf(0.8 to -0.00868, 0.6 to 0.01288)) {
            val noise = WhiteNoise(3, intensity(e, a2), conservesMomentum = true)
            val (t, measured) = steady(simulation(count, 1, e, 1.0, noise), 60.0, 10.0, if (fullPhysics) 80 else 12)
            assertPhysics("T of a gas under white noise, e = $e", 1.0, t, if (fullPhysics) 0.01 else 0.03)
            val bound = if (fullPhysics) 0.0012 else 0.015
            assertPhysics("a₂ under white noise, e = $e", a2, measured, bound, relative = false)
        }
    }

    @Tag("thorough")
    @Test
    fun `the temperature goes with the intensity to the power two thirds`() {
        val count = if (fullPhysics) 20_000 else 3_000
        val times = if (fullPhysics) 40 else 10
        val weak = WhiteNoise(3, intensity(0.8, 0.0), conservesMomentum = true)
        val strong = WhiteNoise(4, 8 * intensity(0.8, 0.0), conservesMomentum = true)
        val (cold) = steady(simulation(count, 1, 0.8, 1.0, weak), 60.0, 10.0, times)
        // Not the same step in units of the time between collisions: a kick may be as coarse as that.
        val (hot) = steady(simulation(count, 2, 0.8, 1.0, strong), 60.0, 5.0, 2 * times)
        assertPhysics("T at 8 times the intensity over T", 4.0, hot / cold, if (fullPhysics) 0.01 else 0.03)
    }

    @Tag("thorough")
    @Test
    fun `elastic spheres in a bath have its temperature, whatever their mass`() {
        val box = cube(3_000, 0.2)
        for (bath in listOf(WhiteNoise(5, 2 * 0.3 * 1.7, 0.3, overMass = true), Andersen(5, 0.5, 1.7))) {
            val p = gas(3_000, box, 3, false)
            for (k in 0 until p.size step 2) p.mass[k] = 5.0
            val simulation =
                Simulation(
                    p,
                    Periodic(box),
                    CollisionForcing(ConstantRestitution(1.0)),
                    FixedTimeStep(0.2),
                    listOf(bath),
                )
            val sums = DoubleArray(2)
            var states = 0
            while (simulation.time < 30) {
                simulation.advance()
                if (simulation.time < 15) continue
                states++
                val q = simulation.population
                for (k in 0 until q.size) {
                    val v2 = q.vx[k] * q.vx[k] + q.vy[k] * q.vy[k] + q.vz[k] * q.vz[k]
                    sums[q.id[k] % 2] += q.mass[k] * v2 / (3 * 1500)
                }
            }
            for (t in sums) assertPhysics("T of a bath, ${bath.javaClass.simpleName}", 1.7, t / states, 0.02)
        }
    }
}
