package daphnis.analysis.profile

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.State
import daphnis.analysis.statistics.SampleMean
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.abs
import kotlin.math.cbrt
import kotlin.math.sqrt

class FourthCumulantsTest {
    private val box = Box.centred(20.0, 20.0, 20.0)

    /** [count] spheres whose velocities and spins are drawn as vectors, of radii from 1 to [most]; mass r³. */
    private fun state(
        count: Int,
        random: SeededRandom,
        shear: Double = 0.0,
        most: Double = 1.0,
        hasSpin: Boolean = true,
        vector: (SeededRandom) -> DoubleArray,
    ): State {
        val radius = DoubleArray(count) { random.nextDouble(1.0, maxOf(most, 1.0 + 1e-12)) }
        val mass = DoubleArray(count) { radius[it] * radius[it] * radius[it] }
        val x = List(3) { DoubleArray(count) { random.nextDouble(-10.0, 10.0) } }
        val c = List(count) { vector(random) }
        val w = List(count) { vector(random) }

        // Equal energies, a drift, and in a sheared box a flow that is not straight.
        fun bent(y: Double) = if (shear == 0.0) 0.0 else shear * y + 2 * Math.signum(y)
        val v = List(3) { a ->
            DoubleArray(count) { c[it][a] / sqrt(mass[it]) + 0.7 + if (a == 0) bent(x[1][it]) else 0.0 }
        }
        val p = Population(x[0], x[1], x[2], v[0], v[1], v[2], radius, mass)
        val spins = List(3) { a -> DoubleArray(count) { w[it][a] / sqrt(mass[it]) / radius[it] - 0.4 } }
        val spun = if (hasSpin) p.withSpin(spins[0], spins[1], spins[2]) else p
        return State(spun, if (shear == 0.0) Periodic(box) else LeesEdwards(box, shear), 0.0)
    }

    private fun gaussian(random: SeededRandom) = DoubleArray(3) { random.nextGaussian() }

    private fun inBall(random: SeededRandom): DoubleArray {
        while (true) {
            val at = DoubleArray(3) { random.nextDouble(-1.0, 1.0) }
            if (at.sumOf { it * it } <= 1) return at
        }
    }

    /** Mean and error over the states that [make] gives for seeds from 1 on, by column. */
    private fun means(runs: Int, make: (SeededRandom) -> State): List<SampleMean> {
        val all = List(runs) { FourthCumulants().of(make(SeededRandom(it + 1L))) }
        return FourthCumulants.COLUMNS.indices.map { c -> SampleMean.of(DoubleArray(runs) { all[it][c] }) }
    }

    @Tag("thorough")
    @Test
    fun `a Maxwellian has no cumulants, however few particles, of whatever sizes, and in a bent flow`() {
        val cases = listOf<(SeededRandom) -> State>(
            { state(3, it, vector = ::gaussian) },
            { state(10, it, vector = ::gaussian) },
            { state(12, it, most = 4.0, vector = ::gaussian) },
            { state(600, it, shear = 0.9, vector = ::gaussian) },
        )
        for ((k, make) in cases.withIndex()) {
            val all = means(if (k < 3) 20_000 else 400, make)
            for (c in 1..3) {
                assertTrue(abs(all[c].mean) < 4 * all[c].error && all[c].error < 0.005) {
                    "case $k, column $c: ${all[c]}"
                }
            }
        }
    }

    @Test
    fun `errors of a Maxwellian cover 0 in 60 to 75 percent of drawn sets`() {
        val covered = IntArray(4)
        for (set in 0 until SETS) {
            val averages = Averages(FourthCumulants())
            val random = SeededRandom(1000L + set)
            repeat(24) { averages.add(state(60, random, vector = ::gaussian)) }
            for (c in 1..3) if (averages.average(c).let { abs(it.mean) <= it.error }) covered[c]++
        }
        for (c in 1..3) assertTrue(covered[c] in SETS * 60 / 100..SETS * 75 / 100) { "column $c: ${covered.asList()}" }
    }

    @Test
    fun `vectors evenly in a ball have −2 in 7, those of one length −2 in 5, and two Gaussians what integrals say`() {
        // ⟨r²⟩ = 3/5 and ⟨r⁴⟩ = 3/7 in a ball, 1 and 1 on its surface.
        val ball = means(400) { state(500, it, vector = ::inBall) }
        // What a ratio of means is off where it is no Maxwellian: some 1/N.
        for (c in 1..2) assertEquals(-2.0 / 7, ball[c].mean, 0.003)
        assertTrue(ball[1].error < 1e-3)
        val surface = means(400) { random ->
            state(500, random) { r ->
                inBall(r).let { v ->
                    sqrt(v.sumOf { it * it }).let { s ->
                        DoubleArray(3) {
                            v[it] /
                                s
                        }
                    }
                }
            }
        }
        assertEquals(-0.4, surface[1].mean, 0.005)
        // One in ten is five times as fast: ⟨c⁴⟩ and ⟨c²⟩ of the two Gaussians together.
        val mixed = means(60) { random ->
            state(5000, random) { r ->
                (
                    if (r.nextDouble() <
                        0.1
                    ) {
                        5.0
                    } else {
                        1.0
                    }
                    ).let { f -> DoubleArray(3) { f * r.nextGaussian() } }
            }
        }
        val wanted = (0.9 + 0.1 * 625) / ((0.9 + 2.5) * (0.9 + 2.5)) - 1
        assertEquals(wanted, mixed[1].mean, 0.02 * wanted)
        assertEquals(0.0, mixed[3].mean, 4 * mixed[3].error)
    }

    @Test
    fun `fast particles that spin fast have a mixed cumulant`() {
        val both = means(200) { random ->
            val p = state(500, random, vector = ::gaussian).population
            val (x, y, z) = List(3) { a -> DoubleArray(p.size) { 3 * p.velocity((a + 1) % 3)[it] } }
            State(p.withSpin(x, y, z), Periodic(box), 0.0)
        }
        // ⟨c⁴⟩/⟨c²⟩² − 1 = 2/3.
        assertEquals(2.0 / 3, both[3].mean, 4 * both[3].error + 1 / 500.0)
    }

    @Test
    fun `each group has its own, and there are none of few, of what is at rest or does not spin`() {
        val random = SeededRandom(5)
        val made = state(4000, random, most = 2.0, hasSpin = false, vector = ::gaussian).population
        for (k in 0 until made.size) if (made.radius[k] > 1.5) made.vx[k] *= 3.0
        val found = FourthCumulants(SizeGroups(doubleArrayOf(1.0, 1.5, 2.0, 9.0))).of(State(made, Periodic(box), 0.0))
        fun of(group: Int, column: String) = found[group * 4 + FourthCumulants.COLUMNS.indexOf(column)]
        assertEquals(4000.0, of(0, "count") + of(1, "count"))
        // (3/5) ⟨c⁴⟩/⟨c²⟩² of variances 9, 1 and 1 is 0.6 · 287/121.
        assertTrue(abs(of(0, "a2")) < 0.12) { "${found.asList()}" }
        assertEquals(0.6 * 287 / 121 - 1, of(1, "a2"), 0.15)
        assertTrue(of(2, "a2").isNaN() && of(0, "spin_a2").isNaN() && of(0, "mixed_a2").isNaN())
        val rest = State(state(9, random) { DoubleArray(3) }.population, Periodic(box), 0.0)
        assertTrue(FourthCumulants().of(rest).drop(1).all { it.isNaN() })
        assertTrue(FourthCumulants().of(state(2, random, vector = ::gaussian)).drop(1).all { it.isNaN() })
    }

    /** van Noije & Ernst 1998, for three dimensions. */
    private fun ofTheory(e: Double) = 16 * (1 - e) * (1 - 2 * e * e) / (81 - 17 * e + 30 * e * e * (1 - e))

    @Test
    @Tag("thorough")
    fun `a gas of smooth spheres that cools has the cumulant of theory before it clusters`(@TempDir home: Path) {
        for (e in listOf(0.9, 0.8)) {
            val found = SampleMean.of(DoubleArray(SEEDS) { cooling(e, it + 101L, home.resolve("$e-$it")) })
            // The theory leaves out higher cumulants: at 0.9 Monte Carlo of the Boltzmann equation has -0.0159 ± 0.0004.
            assertEquals(ofTheory(e), found.mean, 3 * found.error + 0.1 * abs(ofTheory(e))) { "$e: $found" }
            assertTrue(found.error < 0.002)
        }
    }

    /** Mean of a₂ over states after 8 to 30 collisions per sphere, at a filling factor of 0.01. */
    private fun cooling(e: Double, seed: Long, home: Path): Double {
        val n = 4000
        val edge = cbrt(n * Math.PI / 6 / 0.01)
        val settings = listOf("particles.count=$n", "box.lengths=[$edge,$edge,$edge]", "restitution.coefficient=$e")
        val none = listOf("output.snapshotEvery=0", "output.checkpointEvery=0", "output.seriesEvery=0", "until=1e6")
        val scenario = BuiltIn.scenario("cooling-gas", settings + none + listOf("timeStep.dt=0.5", "seed=$seed"))
        val measured = ArrayList<Double>()
        Run.start(scenario, "test", home).use { run ->
            run.execute(
                watcher = {
                    val each = 2.0 * it.collisions!!.counters.collisions / n
                    if (each > 8 && each < 30) measured += FourthCumulants().of(State.of(it))[1]
                },
                cancelled = { 2.0 * run.simulation.collisions!!.counters.collisions / n > 30 },
            )
        }
        return measured.average()
    }

    private companion object {
        const val SETS = 400
        const val SEEDS = 10
    }
}
