package daphnis.core.merging

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.FixedThreads
import daphnis.core.engine.SerialEngine
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.physics.cube
import daphnis.core.physics.gas
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.potential.PairInteractions
import daphnis.core.potential.SteppedPotential
import daphnis.core.run.CollisionStatistics
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

class MergingTest {
    private fun collisions(rule: MergeRule) =
        CollisionForcing.builder(ConstantRestitution(1.0)).merging(rule).recordCollisions().build()

    private fun simulation(population: Population, rule: MergeRule, statistics: CollisionStatistics, dt: Double = 0.5) =
        Simulation(population, Open, collisions(rule), FixedTimeStep(dt), outputs = listOf(statistics))

    /** Σ m, m x, m v by axis, r³, and the angular momentum about the origin by axis. */
    private fun sums(p: Population): List<Double> {
        fun sum(term: (Int) -> Double) = (0 until p.size).sumOf(term)
        fun spin(k: Int, axis: Int) = if (p.hasSpin) listOf(p.wx, p.wy, p.wz)[axis][k] else 0.0
        val inertia = { k: Int -> 0.4 * p.mass[k] * p.radius[k] * p.radius[k] }
        return listOf(sum { p.mass[it] }, sum { p.radius[it] * p.radius[it] * p.radius[it] }) +
            (0..2).flatMap { a ->
                val (b, c) = (a + 1) % 3 to (a + 2) % 3
                listOf(
                    sum { p.mass[it] * p.position(a)[it] },
                    sum { p.mass[it] * p.velocity(a)[it] },
                    sum {
                        p.mass[it] * (p.position(b)[it] * p.velocity(c)[it] - p.position(c)[it] * p.velocity(b)[it]) +
                            inertia(it) * spin(it, a)
                    },
                )
            }
    }

    @Test
    fun `what is left of two has the mass, momentum, volume and angular momentum of both`() {
        val start = populationOf(
            Sphere(x = -2.0, y = 0.3, z = 0.1, vx = 1.0, vy = 0.1, r = 0.5, m = 1.0),
            Sphere(x = 2.0, y = -0.2, vx = -0.5, vz = 0.2, r = 1.0, m = 8.0),
        ).withSpin(doubleArrayOf(0.3, 0.1), doubleArrayOf(-0.2, 0.0), doubleArrayOf(0.0, 0.5))
        val expected = sums(start)
        val statistics = CollisionStatistics()
        val simulation = simulation(start, MergeRule.always(), statistics)
        fun energy() = simulation.conserved().kineticEnergy + simulation.population.let { p ->
            (0 until p.size).sumOf {
                0.2 * p.mass[it] * p.radius[it] * p.radius[it] *
                    (p.wx[it] * p.wx[it] + p.wy[it] * p.wy[it] + p.wz[it] * p.wz[it])
            }
        }
        val before = energy()
        repeat(8) { simulation.advance() }
        val end = simulation.population
        assertEquals(listOf(1), end.id.toList())
        val moved = sums(end)
        for (k in expected.indices) {
            // The centre of mass has gone on for four units of time.
            val drift = if (k in listOf(2, 5, 8)) expected[k + 1] * 4 else 0.0
            assertEquals(expected[k] + drift, moved[k], 1e-13) { "$k" }
        }
        assertEquals(before - energy(), statistics.dissipated, 1e-14)
        assertEquals(1, simulation.collisions!!.counters.mergers)
        assertEquals(1, simulation.collisions!!.counters.collisions)
    }

    @Test
    fun `of two equals the lower id is left, and spheres that meet too fast bounce`() {
        val start = populationOf(Sphere(x = -1.0, vx = 1.0, r = 0.5), Sphere(x = 1.0, vx = -1.0, r = 0.5))
        val merged = simulation(start.copy(), MergeRule.below(2.1), CollisionStatistics())
        repeat(4) { merged.advance() }
        assertEquals(listOf(0), merged.population.id.toList())
        assertEquals(0.0, merged.population.vx[0])
        assertEquals(Math.cbrt(0.25), merged.population.radius[0], 1e-15)
        val apart = simulation(start.copy(), MergeRule.below(1.9), CollisionStatistics())
        repeat(4) { apart.advance() }
        assertEquals(2, apart.population.size)
        // √(2 G m/d) = √(2 · 1 · 2/1) = 2.
        for ((factor, left) in listOf(0.99 to 2, 1.01 to 1)) {
            val bound = simulation(start.copy(), MergeRule.belowEscape(1.0, factor), CollisionStatistics())
            repeat(4) { bound.advance() }
            assertEquals(left, bound.population.size)
        }
    }

    @Test
    fun `a chain that merges in one step is one sphere`() {
        val spheres = Array(20) { Sphere(x = 1.0 * it, vx = if (it < 10) 1.0 else -1.0, r = 0.5) }
        val statistics = CollisionStatistics()
        val simulation = simulation(populationOf(*spheres), MergeRule.always(), statistics, dt = 30.0)
        simulation.advance()
        val p = simulation.population
        assertEquals(1, p.size)
        assertEquals(20.0, p.mass[0], 1e-13)
        assertEquals(9.5, p.x[0], 1e-12)
        assertEquals(0.0, p.vx[0], 1e-14)
        assertEquals(19, simulation.collisions!!.counters.mergers)
        assertEquals(10.0, statistics.dissipated, 1e-12)
    }

    @Test
    fun `the number of spheres of a gas falls as the Enskog rate says, and nothing is lost but energy`() {
        val count = 20_000
        val box = cube(count, 0.01)
        val statistics = CollisionStatistics()
        val simulation = Simulation(
            gas(count, box, 11, lattice = false),
            Periodic(box),
            collisions(MergeRule.always()),
            FixedTimeStep(0.1),
            outputs = listOf(statistics),
        )
        val before = simulation.conserved()
        while (simulation.time < 0.5 - 1e-9) simulation.advance()
        // ν of the Enskog theory at a filling factor of 0.01 is 0.138840, and it falls as N does.
        val merged = count - simulation.population.size
        val expected = count * (1 - 1 / (1 + 0.5 * 0.138840 * 0.5))
        assertEquals(expected, merged.toDouble(), 4 * sqrt(expected))
        while (simulation.time < 20) simulation.advance()
        val end = simulation.conserved()
        assertTrue(end.count < count / 2)
        assertEquals(count - simulation.collisions!!.counters.mergers, end.count.toLong())
        assertEquals(before.mass, end.mass, 1e-9)
        for ((a, b) in listOf(before.momentumX to end.momentumX, before.momentumZ to end.momentumZ)) {
            assertEquals(a, b, 1e-9)
        }
        assertEquals(count * 0.125, simulation.population.radius.sumOf { it * it * it }, 1e-8)
        assertEquals(before.kineticEnergy - end.kineticEnergy, statistics.dissipated, 1e-9 * before.kineticEnergy)
    }

    @Test
    fun `a step that fails leaves all spheres as they were`() {
        val box = cube(500, 0.1)
        val start = gas(500, box, 5, lattice = false)
        val digest = stateDigest(start)
        val mass = start.mass.toList()
        var asked = 0
        val rule = MergeRule { _, _, _ -> if (++asked == 100) error("enough") else true }
        val simulation = Simulation(start, Periodic(box), collisions(rule), FixedTimeStep(2.0))
        assertThrows(IllegalStateException::class.java) { simulation.advance() }
        assertEquals(500, simulation.population.size)
        assertEquals(digest, stateDigest(simulation.population))
        assertEquals(mass, simulation.population.mass.toList())
        val other =
            Simulation(
                gas(500, box, 5, lattice = false),
                Periodic(box),
                collisions(MergeRule.always()),
                FixedTimeStep(2.0),
            )
        simulation.advance()
        other.advance()
        assertEquals(stateDigest(other.population), stateDigest(simulation.population))
        assertTrue(other.population.size < 450)
    }

    @Test
    fun `a sphere that has grown until it touches its own image ends the run, on every engine, before it is lost`() {
        val side = 4.0
        val box = Box(0.0, 0.0, 0.0, side, side, side)
        for (boundary in listOf(Periodic(box), LeesEdwards(box, 0.3))) {
            for (engine in listOf(SerialEngine()) + CoreEngines.others(FixedThreads(2))) {
                // 32 spheres of a face-centred lattice, which would be one with a radius of 2.06.
                val sites = (0 until 64).filter { (it + it / 4 + it / 16) % 2 == 0 }
                fun at(site: Int) = 0.5 + site % 4
                val start = populationOf(
                    *sites.map {
                        Sphere(at(it), at(it / 4), at(it / 16), sin(1.0 * it), cos(2.0 * it), r = 0.65)
                    }.toTypedArray(),
                )
                val collisions = CollisionForcing.builder(ConstantRestitution(1.0)).engine(engine)
                    .merging(MergeRule.always()).build()
                Simulation(start, boundary, collisions, FixedTimeStep(0.05)).use { simulation ->
                    val e = assertThrows(IllegalArgumentException::class.java) {
                        repeat(2000) { _ -> simulation.advance() }
                    }
                    val story = "${engine.name} in $boundary"
                    assertTrue("touches its own image" in e.message!!) { "$story: ${e.message}" }
                    assertEquals(32.0, simulation.population.mass.sum(), 1e-9) { story }
                    assertTrue(simulation.population.radius.max() < side / 2) { story }
                }
            }
        }
    }

    @Test
    fun `spheres with interactions do not merge`() {
        val both = CollisionForcing.builder(ConstantRestitution(1.0)).merging(MergeRule.always())
            .interactions(PairInteractions(SteppedPotential.squareWell(1.5, 1.0)))
        assertThrows(IllegalArgumentException::class.java) { both.build() }
    }

    @Test
    fun `a small heavy sphere that meets a large light one is found where it goes`() {
        val random = SeededRandom(3)
        val box = Box.centred(6.0, 6.0, 6.0)
        val radii = DoubleArray(60) { if (it % 10 == 0) 0.003 else 0.3 }
        val places = RandomPlacement().place(radii, box, BooleanArray(3), random)
        fun gauss() = DoubleArray(60) { random.nextGaussian() }
        val mass = DoubleArray(60) { (if (it % 10 == 0) 1e6 else 1e-6) * radii[it] * radii[it] * radii[it] }
        val start = Population(places.x, places.y, places.z, gauss(), gauss(), gauss(), radii, mass)
        val forcing = collisions(MergeRule.always())
        val simulation = Simulation(start, Periodic(box), forcing, FixedTimeStep(0.05))
        while (simulation.time < 3) simulation.advance()
        assertTrue(simulation.population.size < 40)
    }

    @Test
    fun `rules that are none are refused`() {
        assertThrows(IllegalArgumentException::class.java) { MergeRule.below(0.0) }
        assertThrows(IllegalArgumentException::class.java) { MergeRule.below(Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { MergeRule.belowEscape(0.0, 1.0) }
        assertThrows(IllegalArgumentException::class.java) { MergeRule.belowEscape(1.0, -1.0) }
    }
}
