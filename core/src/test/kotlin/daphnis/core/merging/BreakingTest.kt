package daphnis.core.merging

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.MaterialLaws
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import kotlin.math.sqrt

/** Spheres that break: what pieces have together, what it costs, and when nothing breaks. */
class BreakingTest {
    private fun Population.energy() = (0 until size).sumOf {
        0.5 * mass[it] *
            (vx[it] * vx[it] + vy[it] * vy[it] + vz[it] * vz[it])
    }

    private fun Population.sum(column: DoubleArray) = (0 until size).sumOf { mass[it] * column[it] }

    /** Two that meet head on with the relative speed [speed] at time 0.5 of a step of 1, the first of them at rest. */
    private fun pair(speed: Double, radius: Double = 1.0) = Population(
        doubleArrayOf(0.0, 1.0 + radius + 0.5 * speed),
        DoubleArray(2),
        DoubleArray(2),
        doubleArrayOf(0.0, -speed),
        DoubleArray(2),
        DoubleArray(2),
        doubleArrayOf(1.0, radius),
        doubleArrayOf(1.0, radius * radius * radius),
    )

    private fun step(population: Population, rule: BreakRule, restitution: Double, steps: Int = 1): CollisionForcing {
        val forcing = CollisionForcing.builder(ConstantRestitution(restitution)).breaking(rule).build()
        Simulation(population, Open, forcing, FixedTimeStep(1.0)).use { simulation ->
            repeat(steps) { simulation.advance() }
        }
        return forcing
    }

    @ParameterizedTest
    @ValueSource(ints = [2, 3, 4, 5, 12, 1000])
    fun `pieces have the mass, centre, momentum and volume of their sphere, and the energy that the impact had`(
        n: Int,
    ) {
        val rule = BreakRule(0.5, n, 0.3, 1e-3)
        val population = pair(2.0, radius = 0.7)
        val before = population.copy()
        val forcing = step(population, rule, restitution = 0.6)
        assertEquals(2 * n, population.size)
        assertEquals(2L, forcing.counters.broken)
        assertEquals((0 until 2 * n).toList(), population.id.sorted())
        assertEquals(before.mass.sum(), population.mass.sum(), 1e-13)
        assertEquals(before.sum(before.vx), population.sum(population.vx), 1e-14)
        assertEquals(before.sum(before.x) + before.sum(before.vx), population.sum(population.x), 1e-13)
        assertEquals(0.0, population.sum(population.y), 1e-14)
        assertEquals(before.radius.sumOf { it * it * it }, population.radius.sumOf { it * it * it }, 1e-13)
        val reduced = before.mass[0] * before.mass[1] / before.mass.sum()
        val cost = before.mass.sumOf { rule.energy(it) }
        // Of what is left of ½ μ v² when pieces are paid for, 1 − ε² is lost; the pieces have their energy.
        val lost = (1 - 0.36) * (0.5 * reduced * 4 - cost)
        assertEquals(before.energy() - lost, population.energy(), 1e-14)
        for (k in 0 until population.size) {
            for (j in 0 until k) assertTrue(population.id[j] != population.id[k])
        }
    }

    @Test
    fun `pieces are inside their sphere at first, and then leave it`() {
        val population = pair(2.0)
        step(population, BreakRule(0.5, 12, 0.3, 1e-3), restitution = 1.0)
        // The second has given its speed to the first, without what the pieces cost: the centres are at rest and at −½ v.
        fun groups() = population.indicesById().partition { population.x[it] < 1 }
        val (first, second) = groups()
        assertEquals(12, first.size)
        assertEquals(12, second.size)
        for (group in listOf(first, second)) {
            fun mean(column: DoubleArray) = group.sumOf { column[it] } / group.size
            val (x, y, z) = Triple(mean(population.x), mean(population.y), mean(population.z))
            val (u, v, w) = Triple(mean(population.vx), mean(population.vy), mean(population.vz))
            for (k in group) {
                val dx = population.x[k] - x
                val dy = population.y[k] - y
                val dz = population.z[k] - z
                val d = sqrt(dx * dx + dy * dy + dz * dz)
                assertEquals(1.0, d + population.radius[k], 1e-14)
                val outward = (population.vx[k] - u) * dx + (population.vy[k] - v) * dy + (population.vz[k] - w) * dz
                assertEquals(0.3, outward / d, 1e-14)
            }
        }
    }

    @Test
    fun `nothing breaks that is too slow, too small or cannot pay`() {
        fun broken(speed: Double, rule: BreakRule, radius: Double = 1.0) =
            step(pair(speed, radius), rule, restitution = 0.5).counters.broken
        assertEquals(0, broken(2.0, BreakRule(2.0, 2, 0.1, 1e-3)))
        assertEquals(2, broken(2.0, BreakRule(1.999, 2, 0.1, 1e-3)))
        // ½ μ v² is 1, and the pieces of both have spread².
        assertEquals(2, broken(2.0, BreakRule(0.1, 2, 0.9999, 1e-3)))
        assertEquals(0, broken(2.0, BreakRule(0.1, 2, 1.0001, 1e-3)))
        // Eight pieces have half the radius.
        assertEquals(2, broken(2.0, BreakRule(0.1, 8, 0.1, 0.499)))
        assertEquals(0, broken(2.0, BreakRule(0.1, 8, 0.1, 0.501)))
        assertEquals(1, broken(2.0, BreakRule(0.1, 8, 0.1, 0.499), radius = 0.9))
    }

    @Test
    fun `a gas that breaks keeps its momentum, and its energy but for what restitution takes`() {
        val box = Box.centred(14.0, 14.0, 14.0)
        val random = SeededRandom(3)
        val places = RandomPlacement(2_000).place(DoubleArray(100) { 1.0 }, box, BooleanArray(3), random)
        fun velocities() = DoubleArray(100) { random.nextGaussian() }
        val population = Population(
            places.x,
            places.y,
            places.z,
            velocities(),
            velocities(),
            velocities(),
            DoubleArray(100) { 1.0 },
            DoubleArray(100) { 1.0 },
        )
        val energy = population.energy()
        val momentum = population.sum(population.vx)
        val forcing = CollisionForcing.builder(
            ConstantRestitution(1.0),
        ).breaking(BreakRule(1.0, 3, 0.2, 0.4, 7)).build()
        Simulation(population, Periodic(box), forcing, FixedTimeStep(0.1)).use { simulation ->
            repeat(200) { simulation.advance() }
        }
        assertEquals(100 + 2 * forcing.counters.broken, population.size.toLong())
        // Twice at most: 3^(−2/3) is 0.48, and 3^(−1) less than 0.4.
        assertTrue(forcing.counters.broken in 101L..400L) { "${forcing.counters.broken}" }
        assertEquals(energy, population.energy(), 1e-12 * energy)
        assertEquals(momentum, population.sum(population.vx), 1e-12)
    }

    @ParameterizedTest
    @ValueSource(booleans = [false, true])
    fun `what collisions are said to take is what is lost, also where pieces merge again`(byMaterial: Boolean) {
        val box = Box.centred(12.0, 12.0, 12.0)
        val random = SeededRandom(5)
        val places = RandomPlacement(2_000).place(DoubleArray(100) { 0.8 }, box, BooleanArray(3), random)
        fun velocities() = DoubleArray(100) { 2 * random.nextGaussian() }
        val plain = Population(
            places.x,
            places.y,
            places.z,
            velocities(),
            velocities(),
            velocities(),
            DoubleArray(100) { 0.8 },
            DoubleArray(100) { 1.0 },
        )
        val population = if (byMaterial) plain.withMaterial(IntArray(100) { it % 2 }, listOf("a", "b")) else plain
        val one = ConstantRestitution(0.8)
        val law: ContactLaw = if (byMaterial) MaterialLaws(one).between(0, 1, ConstantRestitution(0.5)) else one
        val forcing = CollisionForcing.builder(law).recordCollisions().merging(MergeRule.below(1.5))
            .breaking(BreakRule(2.0, 4, 0.4, 0.1, 7)).build()
        val energy = population.energy()
        var lost = 0.0
        Simulation(population, Periodic(box), forcing, FixedTimeStep(0.1)).use { simulation ->
            repeat(60) {
                simulation.advance()
                val record = forcing.record!!
                for (k in 0 until record.size) {
                    lost += 0.5 * record.impulse(k) * (1 - record.coefficient(k)) * record.impactSpeed(k)
                    lost += record.surfaceDissipation(k)
                }
            }
        }
        assertTrue(forcing.counters.let { it.broken > 100 && it.mergers > 100 }) { "${forcing.counters.broken}" }
        assertEquals(energy - population.energy(), lost, 1e-12 * energy)
    }

    @Test
    fun `numbers out of range and spheres with spins are refused`() {
        for (act in listOf<() -> Any>(
            { BreakRule(-1.0, 2, 0.1, 0.1) },
            { BreakRule(Double.NaN, 2, 0.1, 0.1) },
            { BreakRule(1.0, 1, 0.1, 0.1) },
            { BreakRule(1.0, 1001, 0.1, 0.1) },
            { BreakRule(1.0, 2, 0.0, 0.1) },
            { BreakRule(1.0, 2, 0.1, 0.0) },
            {
                step(
                    pair(2.0).withSpin(DoubleArray(2), DoubleArray(2), DoubleArray(2)),
                    BreakRule(0.5, 2, 0.1, 0.1),
                    0.5,
                )
            },
        )) {
            assertThrows(IllegalArgumentException::class.java) { act() }
        }
    }
}
