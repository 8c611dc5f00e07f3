package daphnis.analysis.profile

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs

/** Whether profiles are right, and their errors honest, at few particles in a bin. */
class ProfileErrorTest {
    private val box = Box.centred(10.0, 20.0, 4.0)
    private val width = Profile.COLUMNS.size
    private fun column(name: String) = Profile.COLUMNS.indexOf(name)

    /** 40 states of a Maxwellian of temperature [T] in each component, [count] particles each. */
    private fun states(boundary: BoundaryConditions, count: Int, seed: Long, measure: Averages) = repeat(STATES) {
        measure.add(uniform(count, boundary, seed = seed * 1000 + it, radius = 0.05) { r -> 0.5 * r.nextGaussian() })
    }

    @Tag("thorough")
    @Test
    fun `profiles tell the truth within one error in 60 to 75 percent, from one to 50 particles a bin`() {
        for (perBin in listOf(1.0, 1.5, 4.0, 50.0)) {
            val truth = mapOf(
                "count" to perBin,
                "mean_vx" to 0.0,
                "mean_vy" to 0.0,
                "c_xx" to T,
                "c_yy" to T,
                "c_xy" to 0.0,
                "surface_density" to perBin * BINS / 200,
                "filling_factor" to perBin * BINS * 4.0 / 3 * PI * 1.25e-4 / 800,
            )
            val covered = HashMap<String, Int>()
            val given = HashMap<String, Int>()
            val mean = HashMap<String, Double>()
            for (seed in 1L..REALISATIONS) {
                val averages = Averages(Profile(0, -5.0, 5.0, BINS))
                states(HillSheet(box, 2.0), (perBin * BINS).toInt(), seed, averages)
                for (bin in 0 until BINS) {
                    for ((name, value) in truth) {
                        val a = averages.average(bin * width + column(name))
                        mean.merge(name, a.mean, Double::plus)
                        if (!a.isLevelled) continue
                        given.merge(name, 1, Int::plus)
                        if (abs(a.mean - value) <= a.error) covered.merge(name, 1, Int::plus)
                    }
                }
            }
            val all = REALISATIONS * BINS
            for ((name, value) in truth) {
                val share = (covered[name] ?: 0) / (given[name] ?: 0).toDouble()
                assertTrue(share in 0.60..0.75 && given.getValue(name) > 0.9 * all) {
                    "$name at $perBin a bin: $share of ${given[name]} of $all"
                }
                val scale = if (value > 0) {
                    value
                } else if (name == "c_xy") {
                    T
                } else {
                    0.6
                }
                assertEquals(value, mean.getValue(name) / all, 0.015 * scale) { "$name at $perBin a bin" }
            }
        }
    }

    @Test
    fun `the temperature does not drop where particles get few`() {
        // Heights with an exponential tail: 300 a state in the middle plane, one in several states at the ends.
        val averages = Averages(Profile(2, -2.0, 2.0, 20))
        repeat(STATES) { seed ->
            val state = uniform(1000, Periodic(box), seed = seed + 1L) { r -> 0.5 * r.nextGaussian() }
            val z = state.population.z
            for (k in z.indices) z[k] = Math.signum(z[k]) * -0.3 * Math.log(1 - abs(z[k]) / 2.0001)
            averages.add(state)
        }
        val temperatures = (0 until 20).map { averages.average(it * width + column("c_xx")) }
        for ((bin, t) in temperatures.withIndex()) {
            if (t.isLevelled) {
                assertTrue(abs(t.mean - T) < 3.5 * t.error) {
                    "bin $bin: $t"
                }
            }
        }
        assertTrue(temperatures.count { it.isLevelled } >= 16)
    }

    @Test
    fun `a state counts by the particles it has in a bin`() {
        // One particle at speed 1 in each of 20 states, three at speed 0 in each of 20 others: the mean over particles
        // is 20/80, over states ½.
        val averages = Averages(Profile(0, -5.0, 5.0, 1))
        repeat(40) { k ->
            val n = if (k % 2 == 0) 1 else 3
            val p = Population(
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n) { if (n == 1) 1.0 else 0.0 },
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n) { 0.1 },
                DoubleArray(n) { 1.0 },
            )
            averages.add(State(p, Periodic(box), k.toDouble()))
        }
        assertEquals(0.25, averages.average(column("mean_vx")).mean, 1e-14)
        assertEquals(80 * 0.25 * 0.75 / 79, averages.average(column("c_xx")).mean, 1e-14)
        assertEquals(2.0, averages.average(column("count")).mean, 1e-14)
    }

    @Test
    fun `no particle, one, two, and bins filled in few states have no more than they can tell`() {
        val averages = Averages(Profile(0, -5.0, 5.0, 2))
        repeat(30) { k ->
            val n = if (k < 10) 1 else 0
            averages.add(
                uniform(n, Periodic(Box(0.0, -10.0, -2.0, 5.0, 10.0, 2.0)), seed = k + 1L) {
                    0.1 *
                        it.nextGaussian()
                },
            )
        }
        assertTrue(averages.average(column("mean_vx")).mean.isNaN() && averages.average(column("c_xx")).mean.isNaN())
        val filled = averages.average(width + column("mean_vx"))
        assertTrue(filled.mean.isFinite() && !filled.isLevelled)
        val one = Profile(0, -5.0, 5.0, 1).of(uniform(1, Periodic(box)) { 1.0 })
        assertTrue(one[column("mean_vx")] == 1.0 && one[column("c_xx")].isNaN() && one[column("c_xy")].isNaN())
        assertEquals(0.0, Profile(0, -5.0, 5.0, 1).of(uniform(2, Periodic(box)) { 1.0 })[column("c_xx")])
    }

    @Test
    fun `a sheared box of Lees and Edwards has its temperature and no mean velocity in bins of all axes`() {
        for (axis in 0..2) {
            val averages = Averages(Profile(axis, box.lower(axis), box.upper(axis), 4))
            states(LeesEdwards(box, 3.0), 40, 5, averages)
            for (bin in 0 until 4) {
                for ((name, value) in listOf("c_xx" to T, "c_yy" to T, "c_zz" to T, "c_xy" to 0.0, "mean_vx" to 0.0)) {
                    val a = averages.average(bin * width + column(name))
                    assertTrue(abs(a.mean - value) < 3.5 * a.error) { "axis $axis bin $bin $name: $a" }
                }
            }
        }
    }

    @Test
    fun `spheres fill both ends of a period, and are cut where there is none`() {
        for (boundary in listOf(Periodic(box), HillSheet(box, 1.0), LeesEdwards(box, 2.0), Walls(box))) {
            val state = uniform(2000, boundary, radius = 0.4)
            val volume = 2000 * 4.0 / 3 * PI * 0.064
            for (axis in 0..2) {
                val r = Profile(axis, box.lower(axis), box.upper(axis), 8).of(state)
                val sum = (0 until 8).sumOf { r[it * width + column("filling_factor")] } / 8 * 800
                val periodic = boundary.contactFaces(axis) == ContactFaces.PERIODIC
                if (periodic) assertEquals(volume, sum, 1e-9 * volume) else assertTrue(sum < 0.998 * volume)
            }
            // Half a period has no other end.
            val half = Profile(0, -5.0, 0.0, 4).of(state)
            assertTrue((0 until 4).sumOf { half[it * width + column("filling_factor")] } / 4 * 400 < 0.53 * volume)
        }
    }

    private companion object {
        const val T = 0.25
        const val STATES = 40
        const val BINS = 6
        const val REALISATIONS = 200L
    }
}
