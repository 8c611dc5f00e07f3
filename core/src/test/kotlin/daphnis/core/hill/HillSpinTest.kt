package daphnis.core.hill

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Walls
import daphnis.core.boundary.prepare
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.StepRows
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Drift
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.SphereQuantity
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.CoulombRoughness
import daphnis.core.wall.WallContact
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/** Spins relative to a frame that turns. */
class HillSpinTest {
    private val omega = 1.3
    private val orbit = 2 * Math.PI / omega

    /** [w] as it is seen after [time] in axes that turn with [omega] about z. */
    private fun seen(w: List<Double>, time: Double): List<Double> {
        val angle = omega * time
        return listOf(cos(angle) * w[0] + sin(angle) * w[1], cos(angle) * w[1] - sin(angle) * w[0], w[2])
    }

    private fun Population.spinning(vararg w: List<Double>) =
        withSpin(DoubleArray(size) { w[it][0] }, DoubleArray(size) { w[it][1] }, DoubleArray(size) { w[it][2] })

    private fun Population.spin(id: Int) = indexOf(id).let { listOf(wx[it], wy[it], wz[it]) }

    @Test
    fun `a horizontal spin turns backwards once an orbit, a vertical one stays`() {
        val w = listOf(0.6, -0.2, 0.9)
        for (steps in listOf(4, 7, 100)) {
            for (collisions in listOf(null, CollisionForcing(ConstantRestitution(1.0)))) {
                val p = populationOf(Sphere(x = 1.0, vy = -1.5 * omega)).spinning(w)
                val simulation = Simulation(p, Open, collisions, FixedTimeStep(orbit / steps), listOf(HillFrame(omega)))
                for (step in 1..10 * steps + steps / 3) {
                    simulation.advance()
                    val expected = seen(w, simulation.time)
                    for (axis in 0..2) assertEquals(expected[axis], simulation.population.spin(0)[axis], 1e-13)
                }
            }
        }
    }

    @Test
    fun `an impact sees spins as they are turned at its time, and what it adds turns with the others`() {
        val law = CoulombRoughness(0.3, 0.4)
        val turning = CollisionLaw(ConstantRestitution(0.8), roughness = law, turning = omega)
        val still = CollisionLaw(ConstantRestitution(0.8), roughness = law)
        val images = Images().apply { prepare(Open, 0.0) }
        var least = Double.POSITIVE_INFINITY
        for (seed in 1L..300L) {
            val random = SeededRandom(seed)
            val time = random.nextDouble(0.05, 1.0)
            val w = List(2) { List(3) { random.nextGaussian() } }
            val v = List(3) { random.nextGaussian() }
            val first = Sphere(x = -1.5 - 2 * time, vx = 2.0, vy = v[0], vz = v[1])
            val other = Sphere(x = 0.5, y = (v[0] - v[2]) * time, z = v[1] * time, vy = v[2], r = 1.0, m = 2.0)
            val one = rows(populationOf(first, other).spinning(w[0], w[1]))
            val two = rows(populationOf(first, other).spinning(seen(w[0], time), seen(w[1], time)))
            assertTrue(turning.collide(one, 0, 1, 0, images, time, CollisionOutcome()))
            assertTrue(still.collide(two, 0, 1, 0, images, time, CollisionOutcome()))
            least = minOf(least, abs(two.wy[0] - seen(w[0], time)[1]))
            assertSame(one, two, time, "seed $seed")
            val walls = Walls(Box.centred(9.0, 9.0, 9.0), roughness = List(6) { law })
            for ((rows, its) in listOf(one to turning, two to still)) {
                val contact = WallContact().apply { prepare(walls.walls, its) }
                contact.reflect(rows, 0, (seed % 6).toInt(), time, CollisionOutcome())
            }
            assertSame(one, two, time, "seed $seed, wall")
        }
        assertTrue(least > 0.0) { "an impact changes no spin" }
    }

    private fun rows(p: Population) = StepRows().apply { load(p, IntArray(p.size) { it }, 1.0, false) }

    /** [turned] is in the axes of the start, [plain] in those of [time]. */
    private fun assertSame(turned: StepRows, plain: StepRows, time: Double, story: String) {
        for (slot in 0..1) {
            val w = seen(listOf(turned.wx[slot], turned.wy[slot], turned.wz[slot]), time)
            val expected = listOf(plain.wx[slot], plain.wy[slot], plain.wz[slot])
            for (axis in 0..2) {
                assertEquals(expected[axis], w[axis], 1e-13) { story }
                val v = slot * StepRows.STRIDE + StepRows.VX + axis
                assertEquals(plain.state[v], turned.state[v], 1e-13) { story }
            }
        }
    }

    @Test
    fun `a simulation in the frame has a law that turns with it`() {
        fun end(drift: Drift): Population {
            val p = populationOf(Sphere(x = -1.2), Sphere(x = 1.2, vx = -4.0)).spinning(
                listOf(2.0, 1.0, 0.0),
                listOf(0.0, 0.0, 0.0),
            )
            val forcing = CollisionForcing(ConstantRestitution(1.0), roughness = CoulombRoughness(9.0, 0.0))
            val simulation = Simulation(p, Open, forcing, FixedTimeStep(0.2), listOf(drift))
            simulation.advance()
            assertEquals(1L, forcing.counters.collisions)
            return simulation.population
        }
        val frame = HillFrame(omega)
        val turning = end(frame)
        val still = end(object : Drift by frame {
            override val turning get() = 0.0
        })
        // Until the impact, after about a tenth, the spin has turned by an eighth.
        assertEquals(still.vx[0], turning.vx[0], 1e-14)
        assertTrue(abs(still.vz[0] - turning.vz[0]) > 0.01) { "${still.vz[0]} and ${turning.vz[0]}" }
    }

    @Test
    fun `a forcing that goes over to another simulation has that one's axes`() {
        fun spinning() = populationOf(Sphere(x = -1.2), Sphere(x = 1.2, vx = -4.0))
            .spinning(listOf(2.0, 1.0, 0.0), listOf(0.0, 0.0, 0.0))

        fun end(p: Population, forcing: CollisionForcing, forces: List<Drift>): List<Double> {
            Simulation(p, Open, forcing, FixedTimeStep(0.2), forces).advance()
            assertEquals(1L, forcing.counters.collisions)
            return List(2) { p.indexOf(it) }.flatMap { listOf(p.vx[it], p.vz[it], p.wx[it], p.wy[it]) }
        }

        fun forcing() = CollisionForcing(ConstantRestitution(1.0), roughness = CoulombRoughness(9.0, 0.0))
        val kinds = listOf(emptyList(), listOf(HillFrame(omega)))
        val alone = kinds.map { end(spinning(), forcing(), it) }
        assertTrue(alone[0] != alone[1])
        for (last in 0..1) {
            // The same population, so that the forcing has a step for it; it comes by only under the last forces.
            val p = spinning()
            val kept = forcing()
            val there = DoubleArray(2) { p.x[it] }
            for (k in 0..1) p.x[k] = there[k] + 9.0 * k
            Simulation(p, Open, kept, FixedTimeStep(1e-9), kinds[1 - last]).advance()
            assertEquals(0L, kept.counters.collisions)
            val start = spinning()
            for (q in SphereQuantity.entries) for (c in q.places) start.column(c).copyInto(p.column(c))
            assertEquals(alone[last], end(p, kept, kinds[last])) { "last $last" }
        }
    }
}
