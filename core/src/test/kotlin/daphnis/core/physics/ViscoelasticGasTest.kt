package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.TimeStep
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.surface.SurfaceContact
import daphnis.core.surface.ViscoelasticRestitution
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.util.Locale
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * A gas of viscoelastic spheres that cools, T ∝ t^(−5/3) where Haff's law of a constant coefficient is T ∝ t^(−2)
 * (Brilliantov & Pöschel 2000, Phys. Rev. E 61, 5573; Schwager & Pöschel 1998, Phys. Rev. E 57, 650).
 */
@Tag("physics")
class ViscoelasticGasTest {
    private val law = ViscoelasticRestitution(0.98, 2.0, 0.5, 1.0)

    /** −d ln T/dt at temperature [t] with Maxwellian velocities, number density [n] and pair correlation [chi]. */
    private fun rate(t: Double, n: Double, chi: Double): Double {
        val each = 4 * n * chi * sqrt(Math.PI * t)
        var lost = 0.0
        val du = sqrt(t) / 500
        for (k in 0 until 6000) {
            val u = (k + 0.5) * du
            val e = law.restitution(SurfaceContact.headOn(u, 0.5, 1.0))
            lost += u / (2 * t) * exp(-u * u / (4 * t)) * (1 - e * e) * u * u / 4 * du
        }
        return each / 2 * lost / (1.5 * t)
    }

    @Test
    fun `a gas of viscoelastic spheres cools with the exponent five thirds`() {
        val count = if (fullPhysics) 2000 else 1000
        val filling = 0.05
        val box = cube(count, filling)
        val chi = (1 - filling / 2) / ((1 - filling) * (1 - filling) * (1 - filling))
        val exponents = ArrayList<Double>()
        val rates = ArrayList<Double>()
        val seeds = 1L..when {
            fullPhysics -> 8L
            quickPhysics -> 1L
            else -> 2L
        }
        for (seed in seeds) {
            val step = TimeStep { 1 / sqrt(temperature(it)) }
            val simulation = Simulation(gas(count, box, seed, false), Periodic(box), CollisionForcing(law), step)
            val points = ArrayList<Pair<Double, Double>>()
            var last = 0.0 to 0.0
            while (last.second > -7.0) {
                simulation.advance()
                val now = simulation.time to ln(temperature(simulation.population))
                if (now.second > last.second - 0.5) continue
                val middle = (now.second + last.second) / 2
                val seen = (last.second - now.second) / (now.first - last.first)
                points += middle to ln(seen)
                rates += seen / rate(exp(middle), count / box.volume, chi)
                last = now
            }
            val x = points.map { it.first }.average()
            val y = points.map { it.second }.average()
            // T ∝ (t + t₀)^(−p) has −d ln T/dt ∝ T^(1/p), whatever t₀ is.
            exponents += points.sumOf { (it.first - x) * (it.first - x) } /
                points.sumOf { (it.first - x) * (it.second - y) }
        }
        val mean = exponents.average()
        val error = sqrt(exponents.sumOf { (it - mean) * (it - mean) } / exponents.size / (exponents.size - 1))
        val isOne = exponents.size == 1
        val said = if (isOne) "one seed" else String.format(Locale.ROOT, "±%.4f of %d seeds", error, exponents.size)
        assertPhysics("exponent of cooling, viscoelastic, $said", 5.0 / 3, mean, 0.01)
        assertPhysics("rate of cooling, viscoelastic, over that of Maxwellian velocities", 1.0, rates.average(), 0.01)
    }
}
