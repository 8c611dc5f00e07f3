package daphnis.analysis.profile

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.SpinSums
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

class RotationByGroupTest {
    private val boundary = Periodic(Box.centred(20.0, 20.0, 20.0))

    /** Two sizes, 1 and 2, of mass r³, in turns; spins normal with √(T/I) around [mean], I = 2/5 m r². */
    private fun state(n: Int, seed: Long, temperature: Double = 3.0, mean: Double = 0.0, bodies: Int = 0): State {
        val random = SeededRandom(seed)
        val radius = DoubleArray(n) { 1.0 + it % 2 }
        val mass = DoubleArray(n) { radius[it] * radius[it] * radius[it] }
        val x = List(3) { DoubleArray(n) { random.nextDouble(-9.0, 9.0) } }
        val v = List(3) { DoubleArray(n) { random.nextGaussian() / sqrt(mass[it]) } }
        val w = List(3) { a ->
            DoubleArray(n) {
                val inertia = 0.4 * mass[it] * radius[it] * radius[it]
                random.nextGaussian() * sqrt(temperature / inertia) + if (a == 2) mean else 0.0
            }
        }
        val p = Population(x[0], x[1], x[2], v[0], v[1], v[2], radius, mass).withSpin(w[0], w[1], w[2])
        return State(p, boundary, 0.0, firstBody = n - bodies)
    }

    private fun DoubleArray.of(group: Int, column: String) =
        this[group * RotationByGroup.COLUMNS.size + RotationByGroup.COLUMNS.indexOf(column)]

    @Test
    fun `all particles together have what the series of a run says, bodies left out`() {
        val state = state(40, 2, mean = 0.3)
        val all = RotationByGroup(momentFactor = 0.5).of(state)
        val sums = SpinSums(0.5).also { it.take(state.population) }
        assertEquals(sums.temperature, all.of(0, "temperature") / all.of(0, "mean_mass"), 1e-13)
        for ((axis, name) in listOf("mean_wx", "mean_wy", "mean_wz").withIndex()) {
            assertEquals(sums.mean(axis), all.of(0, name), 1e-14)
        }
        val without = RotationByGroup().of(state(40, 2, bodies = 5))
        assertEquals(35.0, without.of(0, "count"))
        assertEquals((18 + 2 * 17) / 35.0, without.of(0, "mean_radius"), 1e-14)
    }

    @Test
    fun `sizes that share one temperature spin as their moments of inertia say`() {
        val averages = Averages(RotationByGroup(SizeGroups.of(state(2, 1))!!))
        for (seed in 1L..300L) averages.add(state(100, seed, mean = 0.5))
        fun of(group: Int, column: String) =
            averages.average(group * RotationByGroup.COLUMNS.size + RotationByGroup.COLUMNS.indexOf(column))
        for ((group, radius) in listOf(1.0, 2.0).withIndex()) {
            val inertia = 0.4 * Math.pow(radius, 5.0)
            assertEquals(3 + inertia * 0.25 / 3, of(group, "temperature").mean, 4 * of(group, "temperature").error)
            assertEquals(9 / inertia + 0.25, of(group, "w2").mean, 4 * of(group, "w2").error)
            assertEquals(0.5, of(group, "mean_wz").mean, 4 * of(group, "mean_wz").error)
            assertEquals(Math.pow(radius, 3.0), of(group, "mean_mass").mean, 1e-12)
        }
    }

    @Test
    fun `without spins there are sizes only, and an empty group has no means`() {
        val p = state(6, 1).population
        val smooth = State(Population(p.x, p.y, p.z, p.vx, p.vy, p.vz, p.radius, p.mass), boundary, 0.0)
        val found = RotationByGroup(SizeGroups(doubleArrayOf(0.5, 1.5, 3.0, 4.0))).of(smooth)
        assertEquals(listOf(3.0, 3.0, 0.0), List(3) { found.of(it, "count") })
        assertEquals(2.0, found.of(1, "mean_radius"))
        for (column in RotationByGroup.COLUMNS.drop(3)) assertTrue(found.of(0, column).isNaN()) { column }
        assertTrue(found.of(2, "mean_radius").isNaN())
        assertTrue(SpinDistribution().of(smooth).all { it.isNaN() })
    }

    @Test
    fun `partial temperatures are energies, equal where sizes share one, whatever part of the mass they have`() {
        val random = SeededRandom(9)
        val n = 12
        val sum = DoubleArray(2)
        val radius = DoubleArray(n) { if (it < 4) 1.3 else 1.0 }
        val mass = DoubleArray(n) { if (it < 4) 2.0 else 1.0 }
        val runs = 20_000
        repeat(runs) {
            val v = List(3) { DoubleArray(n) { random.nextGaussian() * sqrt(2 / mass[it]) + 4 } }
            val p = Population(DoubleArray(n), DoubleArray(n), DoubleArray(n), v[0], v[1], v[2], radius, mass)
            val found = DispersionBySize.of(State(p, boundary, 0.0))!!.of(State(p, boundary, 0.0))
            for (g in 0..1) sum[g] += found[g * DispersionBySize.COLUMNS.size + 7] / runs
        }
        // Around the centre of mass they would seem to have 1.875 and 1.75.
        for (g in 0..1) assertEquals(2.0, sum[g], 0.03)
    }

    @Test
    fun `spins of a Maxwellian are distributed like it, of any sizes, and those of a ball are not`() {
        val shape = SpinDistribution(20, 4.0)
        val averages = Averages(shape)
        for (seed in 1L..400L) averages.add(state(200, seed, mean = 0.2))
        var away = 0
        for (bin in 0 until 20) {
            // Mean over the bin, by the rule of Simpson.
            fun mean(at: Double, width: Double, f: (Double) -> Double) =
                (f(at - width / 2) + 4 * f(at) + f(at + width / 2)) / 6
            val wanted = List(3) { mean(shape.component(bin), 0.4, SpinDistribution::ofComponent) } +
                mean(shape.modulus(bin), 0.2, SpinDistribution::ofModulus)
            for (which in 0..3) {
                val found = averages.average(which * 20 + bin)
                if (abs(found.mean - wanted[which]) > 2 * found.error + 1e-3) away++
                assertEquals(wanted[which], found.mean, 5 * found.error + 2e-3) { "bin $bin of $which" }
            }
        }
        assertTrue(away <= 12) { "$away" }
        assertEquals(1.0, (0 until 20).sumOf { averages.average(60 + it).mean * 0.2 }, 2e-3)
        assertEquals(exp(-0.5) / sqrt(2 * PI), SpinDistribution.ofComponent(-1.0), 1e-15)
    }

    @Test
    fun `equal moduli fill one bin of the modulus, and what is impossible is refused`() {
        val n = 6
        val w = List(3) { axis -> DoubleArray(n) { if (it / 2 == axis) 2.0 * (it % 2) - 1 else 0.0 } }
        val p = state(n, 1).population
        val ones = DoubleArray(n) { 1.0 }
        val spun = Population(p.x, p.y, p.z, p.vx, p.vy, p.vz, ones, ones).withSpin(w[0], w[1], w[2])
        val found = SpinDistribution(10, 5.0).of(State(spun, boundary, 0.0))
        // ⟨s²⟩ = 3, so all of them are at √3.
        assertEquals(listOf(0.0, 0.0, 0.0, 2.0, 0.0), found.slice(30..34))
        assertEquals(listOf(1.0 / 6, 4.0 / 6, 1.0 / 6), listOf(found[3], found[5], found[6]))
        val alike = p.withSpin(ones, ones, ones)
        assertTrue(SpinDistribution(10, 5.0).of(State(alike, boundary, 0.0)).all { it.isNaN() })
        assertThrows(IllegalArgumentException::class.java) { SpinDistribution(0, 5.0) }
        assertThrows(IllegalArgumentException::class.java) { SpinDistribution(3, 0.0) }
    }

    @Test
    fun `a group may be anything`() {
        val odd = object : SphereGroups {
            override val count = 2

            override fun of(state: State, index: Int) = if (index == 0) -1 else index % 2
        }
        val found = RotationByGroup(odd).of(state(7, 4))
        assertEquals(listOf(3.0, 3.0), List(2) { found.of(it, "count") })
        assertEquals(listOf(1.0, 2.0), List(2) { found.of(it, "mean_radius") })
        assertEquals(2 * 4 * 40, SpinDistribution(groups = odd).of(state(7, 4)).size)
    }
}
