package daphnis.analysis.diffusion

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.format.Snapshot
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

@Tag("jdk-neutral")
class MeanSquareDisplacementTest {
    private val box = Box.centred(7.0, 5.0, 9.0)
    private val positions = listOf(Coordinate.Position(0), Coordinate.Position(1), Coordinate.Position(2))

    /**
     * Walkers in a periodic box whose velocity keeps a part [memory] from step to step; unit steps of time and unit
     * speeds: D = (1 + a)/(1 − a)/2. Groups of [together] move together for the most part.
     */
    private fun walk(
        count: Int,
        times: Int,
        memory: Double,
        random: SeededRandom,
        drift: Double = 0.0,
        boundary: BoundaryConditions = Periodic(box),
        together: Int = 1,
    ): Trajectories {
        val v = Array(3) { DoubleArray(count) { random.nextGaussian() } }
        val p = population(count)
        val trajectories = Trajectories(positions, IntArray(count) { it })
        for (t in 0 until times) {
            trajectories.add(Snapshot.of(p, boundary, t.toLong(), t.toDouble()))
            for ((axis, x) in listOf(p.x, p.y, p.z).withIndex()) {
                for (k in 0 until count) {
                    x[k] += v[axis][k] + drift
                    v[axis][k] = memory * v[axis][k] + sqrt(1 - memory * memory) * kick(k, together, random)
                }
            }
            boundary.endStep(p, t + 1.0)
        }
        return trajectories
    }

    private var shared = 0.0

    /** A Gaussian number for particle [k], four fifths of whose square it shares with its group of [together]. */
    private fun kick(k: Int, together: Int, random: SeededRandom): Double {
        if (together == 1) return random.nextGaussian()
        if (k % together == 0) shared = random.nextGaussian()
        return sqrt(0.8) * shared + sqrt(0.2) * random.nextGaussian()
    }

    private fun population(count: Int) = Population(
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count),
        DoubleArray(count) { 0.1 },
        DoubleArray(count) { 1.0 },
    )

    @Test
    fun `a random walk has the coefficient it was made with, and errors that cover it`() {
        var covered = 0
        val curve = IntArray(32)
        var sum = 0.0
        val runs = 200
        for (seed in 1L..runs) {
            val squares = MeanSquareDisplacement(walk(300, 64, 0.0, SeededRandom(seed)))
            val d = squares.diffusion(0, 1, 2)!!
            if (abs(d.value - 0.5) <= d.error) covered++
            sum += d.value
            for (l in curve.indices) if (abs(squares.mean(0)[l] - squares.lag[l]) <= squares.error(0)[l]) curve[l]++
        }
        assertTrue(covered in 120..150) { "$covered of $runs" }
        for (l in listOf(0, 3, 7)) assertTrue(curve[l] in 120..150) { "lag ${l + 1}: ${curve[l]} of $runs" }
        assertEquals(0, curve[15]) { "a quarter of the time says nothing of its own error" }
        assertEquals(0.5, sum / runs, 0.003)
    }

    @Tag("thorough")
    @Test
    fun `errors cover the coefficient of walkers that go in groups of thirty, as of independent ones`() {
        // Without the centre of mass, of ten groups: 0.5 (0.8 · 0.9 + 0.2).
        for ((together, truth) in listOf(1 to 0.5, 30 to 0.46)) {
            val found = List(200) {
                MeanSquareDisplacement(walk(300, 64, 0.0, SeededRandom(it + 1L), together = together))
                    .diffusion(0, 1, 2)!!
            }
            val covered = found.count { abs(it.value - truth) <= it.error }
            assertTrue(covered in 120..150) { "groups of $together: $covered of 200" }
            val mean = found.map { it.value }.average()
            val spread = sqrt(found.sumOf { (it.value - mean) * (it.value - mean) } / 199)
            assertEquals(1.0, spread / found.map { it.error }.average(), 0.15) { "groups of $together" }
        }
    }

    @Tag("thorough")
    @Test
    fun `two windows of one run of walkers in groups agree within their errors`() {
        val away = List(100) { run ->
            val random = SeededRandom(500L + run)
            val (a, b) = List(2) {
                MeanSquareDisplacement(walk(300, 64, 0.0, random, together = 30)).diffusion(0, 1, 2)!!
            }
            (a.value - b.value) / sqrt(a.error * a.error + b.error * b.error)
        }.filter { !it.isNaN() }
        assertTrue(away.size > 90) { "${away.size} of 100 have errors" }
        assertEquals(1.0, sqrt(away.sumOf { it * it } / away.size), 0.25)
    }

    @Test
    fun `a time of fewer than six longest lags has a coefficient without an error`() {
        val few = MeanSquareDisplacement(walk(300, 23, 0.0, SeededRandom(4))).diffusion(0, 1, 2)!!
        assertEquals(listOf(2.0, 4.0, true), listOf(few.from, few.to, few.error.isNaN()))
        val enough = MeanSquareDisplacement(walk(300, 24, 0.0, SeededRandom(4))).diffusion(0, 1, 2)!!
        assertTrue(enough.to == 4.0 && !enough.error.isNaN())
    }

    @Test
    fun `a fit begins no earlier than the least lag, and there is none where that leaves no room`() {
        val squares = MeanSquareDisplacement(walk(300, 64, 0.0, SeededRandom(4)))
        val begins = listOf(0.0, 5.5, 8.0).map { squares.diffusion(0, 1, 2, least = it)!!.from }
        assertEquals(listOf(2.0, 6.0, 8.0), begins)
        assertNull(squares.diffusion(0, 1, 2, least = 20.0))
    }

    @Test
    fun `a walk through faces that slide has the displacements of one through faces that stand`() {
        val still = MeanSquareDisplacement(walk(60, 64, 0.0, SeededRandom(9)))
        for (rate in listOf(0.4, -1.3)) {
            val slid = MeanSquareDisplacement(walk(60, 64, 0.0, SeededRandom(9), boundary = LeesEdwards(box, rate)))
            for (axis in 1..2) {
                assertArrayEquals(still.mean(axis), slid.mean(axis), 1e-9) { "rate $rate, ${"xyz"[axis]}" }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `flight that remembers its velocity is left out of the fit`() {
        // Memory 0.8 lasts 4.5 steps; the slope at a lag of one step is a fifth of what it comes to. D = 4.5.
        var covered = 0
        var sum = 0.0
        val runs = 40
        for (seed in 1L..runs) {
            val d = MeanSquareDisplacement(walk(200, 512, 0.8, SeededRandom(seed), drift = 0.3)).diffusion(0, 1, 2)!!
            assertTrue(d.from >= 10) { "from lag ${d.from}" }
            assertTrue(d.to in 2 * d.from..4 * d.from && (d.to <= 32 || d.to == 2 * d.from)) { "to lag ${d.to}" }
            if (abs(d.value - 4.5) <= d.error) covered++
            sum += d.value
        }
        assertEquals(4.5, sum / runs, 0.08)
        assertTrue(covered in 20..34) { "$covered of $runs" }
    }

    @Test
    fun `free flight and rest have no coefficient`() {
        val p = population(60)
        val random = SeededRandom(3)
        for (k in 0 until 60) p.vx[k] = random.nextGaussian()
        val t = Trajectories(positions, IntArray(60) { it })
        for (step in 0 until 80) {
            t.add(Snapshot.of(p, Periodic(box), step.toLong(), step * 0.5))
            for (k in 0 until 60) p.x[k] += p.vx[k] * 0.5
            Periodic(box).endStep(p, step * 0.5)
        }
        val msd = MeanSquareDisplacement(t)
        assertNull(msd.diffusion(0))
        assertNull(msd.diffusion(1))
        val mean = p.vx.average()
        assertEquals(
            (0 until 60).sumOf {
                (p.vx[it] - mean) * (p.vx[it] - mean)
            } / 60,
            msd.mean(0)[3] / 4,
            1e-10,
        ) { "after 2 units of time" }
        assertEquals(0.5, msd.lag[0], 1e-12)
    }

    @Test
    fun `guiding centres that stay stay, through any number of faces`() {
        val omega = 0.7
        val sheet = HillSheet(Box.centred(3.0, 4.0, 1.0), omega)
        val random = SeededRandom(5)
        val s =
            List(40) {
                Epicycle(
                    random.nextDouble(-1.5, 1.5),
                    random.nextDouble(-2.0, 2.0),
                    1.2,
                    random.nextDouble(0.0, 6.0),
                    0.1,
                    0.0,
                ).state(omega)
            }
        val start = List(40) { 4 * s[it][0] + 2 * s[it][4] / omega }
        fun column(c: Int) = DoubleArray(40) { s[it][c] }
        val p =
            Population(
                column(0),
                column(1),
                column(2),
                column(3),
                column(4),
                column(5),
                DoubleArray(40) {
                    0.1
                },
                DoubleArray(40) { 1.0 },
            )
        val frame = daphnis.core.hill.HillFrame(omega)
        val simulation = daphnis.core.Simulation(p, sheet, null, daphnis.core.FixedTimeStep(0.05), listOf(frame))
        repeat(600) { simulation.advance() }
        val state = Snapshot.of(p, sheet, 600, simulation.time)
        assertTrue(state.image!![0].any { abs(it) > 0 } && state.image!![1].any { abs(it) > 3 })
        for (k in 0 until 40) assertEquals(start[k], Coordinate.GuidingCentre(omega).of(state, k), 1e-8) { "sphere $k" }
    }

    @Test
    fun `too little is refused by name`() {
        val random = SeededRandom(1)
        fun problem(what: () -> Unit) = assertThrows(IllegalArgumentException::class.java) { what() }.message!!
        assertTrue("15 times" in problem { MeanSquareDisplacement(walk(5, 15, 0.0, random)) })
        assertTrue("2 at least" in problem { MeanSquareDisplacement(walk(1, 20, 0.0, random)) })
        val t = Trajectories(positions, intArrayOf(0, 7))
        val state = Snapshot.of(population(5), Periodic(box), 0, 1.0)
        assertTrue("particle 7 is missing" in problem { t.add(state) })
        val silent = with(state) { Snapshot(0, 1.0, lengths, periodic, 0.0, id, position, velocity, radius, mass) }
        assertTrue("crossed the box" in problem { Trajectories(positions, intArrayOf(0)).add(silent) })
        val once = Trajectories(positions, intArrayOf(0)).also { it.add(state) }
        assertTrue("must ascend" in problem { once.add(state) })
        assertTrue("no particle" in problem { Trajectories(positions, IntArray(0)) })
    }

    @Test
    fun `spheres that swap what they are but not their places have not moved`() {
        val random = SeededRandom(8)
        val p = Walkers.population(20)
        for (axis in 0..2) for (k in 0 until 20) p.position(axis)[k] = random.nextDouble(-2.0, 2.0)
        for (k in 0 until 20) p.mass[k] = 1.0 + k
        val trajectories = Trajectories(List(3) { Coordinate.Position(it) }, IntArray(20) { it })
        for (t in 0L..20L) {
            trajectories.add(Snapshot.of(p, Walkers.BOUNDARY, t, t.toDouble()))
            val (a, b) = random.nextInt(20) to random.nextInt(20)
            p.mass[a] = p.mass[b].also { p.mass[b] = p.mass[a] }
        }
        val found = MeanSquareDisplacement(trajectories)
        for (axis in 0..2) assertEquals(0.0, found.mean(axis).max())
    }
}
