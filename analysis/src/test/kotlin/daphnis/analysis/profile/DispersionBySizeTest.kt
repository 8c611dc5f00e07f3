package daphnis.analysis.profile

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class DispersionBySizeTest {
    private val boundary = LeesEdwards(Box.centred(30.0, 20.0, 10.0), 0.8)

    /**
     * [counts] spheres of [radii], components of the velocity normal with [sigmas] on top of the shear; heights with
     * twice that.
     */
    private fun state(
        radii: List<Double>,
        counts: List<Int>,
        sigmas: List<Double>,
        seed: Long,
        drift: Double = 0.4,
        bodies: Int = 0,
    ): State {
        val random = SeededRandom(seed)
        val radius = radii.indices.flatMap { c -> List(counts[c]) { radii[c] } }.toDoubleArray()
        val sigma = radii.indices.flatMap { c -> List(counts[c]) { sigmas[c] } }
        val n = radius.size
        val y = DoubleArray(n) { random.nextDouble(-10.0, 10.0) }
        val v = List(3) { axis -> DoubleArray(n) { sigma[it] * (axis + 1) * random.nextGaussian() + drift } }
        val z = DoubleArray(n) { 2 * sigma[it] * random.nextGaussian() }
        for (k in 0 until n) v[0][k] += 0.8 * y[k]
        val p = Population(
            DoubleArray(n),
            y,
            z,
            v[0],
            v[1],
            v[2],
            radius,
            DoubleArray(n) {
                radius[it] * radius[it] *
                    radius[it]
            },
        )
        return State(p, boundary, 0.0, firstBody = n - bodies)
    }

    private fun column(name: String) = DispersionBySize.COLUMNS.indexOf(name)

    @Tag("thorough")
    @Test
    fun `each class has the dispersion it was made with, also of two spheres with two fifths of the mass`() {
        // Masses 1, 8 and 64·…: two of radius 5 carry 250 of 650.
        val radii = listOf(1.0, 2.0, 5.0)
        val counts = listOf(80, 40, 2)
        val sigmas = listOf(3.0, 1.0, 0.5)
        val by = DispersionBySize.of(state(radii, counts, sigmas, 1))!!
        assertEquals(3, by.classes)
        val runs = 6000
        val sum = DoubleArray(3 * DispersionBySize.COLUMNS.size)
        for (seed in 1L..runs) {
            by.of(state(radii, counts, sigmas, seed)).forEachIndexed { k, value ->
                sum[k] +=
                    value / runs
            }
        }
        for (c in 0..2) {
            fun of(name: String) = sum[c * DispersionBySize.COLUMNS.size + column(name)]
            assertEquals(counts[c].toDouble(), of("count"), 1e-9)
            assertEquals(radii[c], of("mean_radius"), 1e-9)
            // Relative error of a mean of squares of n numbers in 6000 states, and the noise that others leave in the
            // centre of mass.
            val slack = 5 * (sqrt(2.0 / counts[c] / runs) + 0.3 / sqrt(runs.toDouble()) / sigmas[c] / sigmas[c])
            for ((axis, name) in listOf("c_xx", "c_yy", "c_zz").withIndex()) {
                val wanted = (axis + 1) * (axis + 1) * sigmas[c] * sigmas[c]
                assertEquals(1.0, of(name) / wanted, slack) { "class $c, $name" }
            }
            assertEquals(of("c_xx") + of("c_yy") + of("c_zz"), of("c2"), 1e-9)
            assertEquals(1.0, of("h2") / (4 * sigmas[c] * sigmas[c]), slack) { "class $c, height" }
        }
    }

    @Tag("thorough")
    @Test
    fun `dispersion and height of a class of few tell the truth within one error in 60 to 75 percent`() {
        for (few in listOf(2, 3, 6)) cover(few)
    }

    private fun cover(few: Int) {
        val counts = listOf(30, few)
        val sigmas = listOf(1.0, 0.5)
        fun made(seed: Long) = state(listOf(1.0, 2.0), counts, sigmas, seed)
        val by = DispersionBySize.of(made(1))!!
        val truths = listOf("c_xx" to 1.0, "c_yy" to 2.0, "c2" to sqrt(14.0), "h2" to 2.0)
        val covered = HashMap<String, Int>()
        for (run in 0 until REALISATIONS) {
            val averages = Averages(by)
            repeat(40) { averages.add(made(1000L * run + it)) }
            for (c in 0..1) {
                for ((name, truth) in truths) {
                    val root = averages.average(c * DispersionBySize.COLUMNS.size + column(name)).root()
                    if (abs(root.mean - truth * sigmas[c]) <=
                        root.error
                    ) {
                        covered.merge("$name of class $c", 1, Int::plus)
                    }
                }
            }
        }
        assertEquals(8, covered.size)
        for ((name, count) in covered) {
            assertTrue(count in REALISATIONS * 60 / 100..REALISATIONS * 75 / 100) {
                "$few of few, $name: $count"
            }
        }
    }

    @Test
    fun `many sizes make eight classes of equal width in ln r, with the largest and the smallest in them`() {
        val random = SeededRandom(2)
        val radii = List(500) { 0.1 * Math.pow(256.0, random.nextDouble(0.0, 1.0)) }
        val one = List(500) { 1.0 }
        val s = state(radii, List(500) { 1 }, one, 7)
        val by = DispersionBySize.of(s)!!
        assertEquals(8, by.classes)
        val result = by.of(s)
        val counts = List(8) { result[it * DispersionBySize.COLUMNS.size] }
        assertEquals(500.0, counts.sum())
        val r = List(8) { result[it * DispersionBySize.COLUMNS.size + 1] }
        for (c in 1..7) assertEquals(2.0, r[c] / r[c - 1], 0.25) { r.toString() }
    }

    @Test
    fun `one size has no classes, bodies are left out, an empty class and one with half of all have no number`() {
        assertNull(DispersionBySize.of(state(listOf(1.0), listOf(10), listOf(1.0), 1)))
        assertNull(DispersionBySize.of(state(listOf(1.0, 9.0), listOf(10, 1), listOf(1.0, 1.0), 1, bodies = 1)))
        val by = DispersionBySize.of(state(listOf(1.0, 2.0, 3.0), listOf(40, 5, 2), listOf(1.0, 1.0, 1.0), 1))!!
        val without = by.of(state(listOf(1.0, 3.0), listOf(40, 2), listOf(1.0, 1.0), 3))
        assertEquals(
            listOf(false, true, false),
            List(3) {
                without[it * DispersionBySize.COLUMNS.size + column("c2")].isNaN()
            },
        )
        val heavy = by.of(state(listOf(1.0, 3.0), listOf(20, 1), listOf(1.0, 1.0), 3))
        assertTrue(heavy[column("c2")].isNaN())
        assertEquals(20.0, heavy[0])
    }

    @Test
    fun `the squares of each class are those of its dispersion and of the centre of mass that all move`() {
        val radii = listOf(1.0, 2.0, 5.0)
        val counts = listOf(80, 40, 2)
        val s = state(radii, counts, listOf(3.0, 2.5, 2.0), 4)
        val p = s.population
        // A fourth class that has no sphere.
        val found = DispersionBySize(doubleArrayOf(0.9, 1.5, 3.0, 4.0, 6.0)).of(s)
        fun result(c: Int, name: String) = found[c * DispersionBySize.COLUMNS.size + column(name)]
        val place = listOf(0, 1, 3)
        val mass = p.mass.sum()
        val columns = mapOf<String, (Int) -> Double>(
            "c_xx" to { s.againstFlow(it, 0) },
            "c_yy" to { p.vy[it] },
            "c_zz" to { p.vz[it] },
            "h2" to { p.z[it] },
        )
        for ((name, value) in columns) {
            val centre = (0 until p.size).sumOf { p.mass[it] * value(it) } / mass
            // ⟨V²⟩ from the dispersions that came out, by the definition.
            val ofCentre = (0 until p.size).sumOf { k ->
                val share = p.mass[k] / mass
                share * share * result(place[radii.indexOf(p.radius[k])], name)
            }
            for (c in radii.indices) {
                val members = (0 until p.size).filter { p.radius[it] == radii[c] }
                val squares = members.sumOf { (value(it) - centre) * (value(it) - centre) }
                val free = members.sumOf { 1 - 2 * p.mass[it] / mass }
                val sigma2 = result(place[c], name)
                assertTrue(sigma2 > 0)
                assertEquals(squares, sigma2 * free + members.size * ofCentre, 1e-10 * squares) { "class $c, $name" }
            }
            assertTrue(result(2, name).isNaN()) { "$name of a class without spheres" }
        }
        assertEquals(0.0, result(2, "count"))
    }

    @Test
    fun `two sizes are two classes, as many sizes as classes one each, and sizes equal but for rounding are one`() {
        fun meanRadii(vararg radii: Double, most: Int = 8): List<Double> {
            val s = state(radii.toList(), radii.map { 20 }, radii.map { 1.0 }, 5)
            val result = DispersionBySize.of(s, most)!!.of(s)
            return (1 until result.size step DispersionBySize.COLUMNS.size).map { result[it] }
        }
        assertEquals(listOf(1.0, 3.0), meanRadii(1.0, 3.0))
        assertEquals(listOf(1.0, 2.0, 10.0), meanRadii(1.0, 2.0, 10.0, most = 3))
        // Edges 1, 2.15, 4.64, 10.
        val three = meanRadii(1.0, 2.0, 5.0, 10.0, most = 3)
        assertEquals(listOf(1.5, 7.5), listOf(three[0], three[2]))
        assertTrue(three[1].isNaN())
        assertNull(DispersionBySize.of(state(listOf(1.0, 1 + 1e-12), listOf(5, 5), listOf(1.0, 1.0), 1)))
    }

    @Test
    fun `an edge belongs to the class above it, the last one to the last class, and spheres beyond are in none`() {
        val s = state(listOf(0.9, 1.0, 2.0, 3.0, 3.1), listOf(1, 2, 4, 8, 16), List(5) { 1.0 }, 6)
        fun counts(vararg edges: Double): List<Double> {
            val by = DispersionBySize(edges)
            val result = by.of(s)
            return List(by.classes) { result[it * DispersionBySize.COLUMNS.size] }
        }
        assertEquals(listOf(2.0, 12.0), counts(1.0, 2.0, 3.0))
        assertEquals(listOf(6.0, 24.0), counts(1.0, 3.0, 4.0))
        assertEquals(listOf(14.0), counts(1.0, 3.0))
        for (edges in listOf(doubleArrayOf(1.0), doubleArrayOf(1.0, 1.0), doubleArrayOf(1.0, 3.0, 2.0))) {
            assertThrows(IllegalArgumentException::class.java) { DispersionBySize(edges) }
        }
    }

    private companion object {
        const val REALISATIONS = 500
    }
}
