package daphnis.analysis.brightness

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.occultation.PhotonCounts
import daphnis.analysis.occultation.Transmissions
import daphnis.analysis.occultation.overlapping
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sin
import kotlin.math.sqrt

@Tag("jdk-neutral")
class PhotonPathsTest {
    private fun dense(time: Double = 0.4): State {
        val state = overlapping(90, HillSheet(Box.centred(12.0, 15.0, 6.0), 1.0), SeededRandom(7))
        return State(state.population, state.boundary, time)
    }

    private val table = PhaseTable(doubleArrayOf(0.0, 1.0, 2.0, PI), doubleArrayOf(2.0, 1.0, 0.7, 0.0))

    @Test
    fun `the first order of random paths is single scattering, and the next are smaller`() {
        val state = dense()
        for (law in listOf(
            ScatteringLaw.lambert(0.7),
            ScatteringLaw.lommelSeeliger(0.9, table),
            ScatteringLaw.ofSpheres(0.6, table),
        )) {
            for (line in listOf(
                Illumination.degrees(30.0, 20.0, 45.0, 35.0),
                Illumination.degrees(60.0, -70.0, -30.0, 100.0),
            )) {
                val exact = Brightness(listOf(line), law, 300).of(state)[1]
                val batches = List(40) {
                    PhotonPaths(state, SphereField(state), law, it.toLong()).of(line, 3, 1000)
                }
                val mean = batches.map { it[0] }.average()
                val error = sqrt(batches.sumOf { (it[0] - mean) * (it[0] - mean) } / 39 / 40)
                assertEquals(exact, mean, 3 * error) { law.words }
                assertTrue(error < 0.03 * mean && batches.sumOf { it[2] } < batches.sumOf { it[1] })
            }
        }
    }

    @Test
    fun `what a white patch reflects and lets through in all directions is what falls on its spheres`() {
        val state = dense()
        val law = ScatteringLaw.lambert(1.0)
        val light = LineOfSight.degrees(35.0, 50.0)
        val fallen = 1 - Transmissions(listOf(light), 400).of(state)[0]
        val random = SeededRandom(2)
        val field = SphereField(state)
        val orders = 60
        val samples = List(3000) { k ->
            // An eye above or below: the latter sees what light from below shows to one above, upside down.
            val height = random.nextDouble(-1.0, 1.0)
            val around = random.nextDouble(0.0, 2 * PI)
            val eye = LineOfSight(StrictMath.asin(maxOf(abs(height), 0.002)), around)
            val sky = sky(eye, light, height)
            val seen = PhotonPaths(
                if (height >
                    0
                ) {
                    state
                } else {
                    turned
                },
                if (height > 0) field else turnedField,
                law,
                1L + k,
            )
            // ∫ I/F |μ| dΩ / (π μ₀): 4π is the sky.
            4 * abs(height) / sin(light.elevation) * seen.of(sky, orders, 60).sum()
        }
        val mean = samples.average()
        val error = sqrt(samples.sumOf { (it - mean) * (it - mean) }) / samples.size
        println("scattered $mean ± $error of the $fallen that falls on spheres")
        assertEquals(fallen, mean, 3 * error)
        assertTrue(error < 0.02)
    }

    private val turned by lazy {
        val p = dense().population.copy()
        for (k in 0 until p.size) p.z[k] = -p.z[k]
        State(p, dense().boundary, dense().time)
    }
    private val turnedField by lazy { SphereField(turned) }

    /** The light of [light] for the eye of [eye], which stands below where [height] is below 0. */
    private fun sky(eye: LineOfSight, light: LineOfSight, height: Double): Illumination {
        val up = if (height > 0) light.elevation else -light.elevation
        val e = LineOfSight.direction(eye.elevation, eye.azimuth)
        val s = LineOfSight.direction(up, light.azimuth)
        val angle = StrictMath.acos((0..2).sumOf { e[it] * s[it] })
        val ahead = e[0] * s[1] - e[1] * s[0] >= 0
        return Illumination(eye, up, if (ahead) angle else -angle)
    }

    @Tag("thorough")
    @Test
    fun `the second order of a high dilute slab of spheres that scatter evenly is that of radiative transfer`() {
        val count = 200
        val side = 35.4491
        val depth = count * PI / (side * side)
        val high = Box.centred(side, side, 5000.0)
        val law = ScatteringLaw.ofSpheres(1.0, PhaseTable(doubleArrayOf(0.0, PI), doubleArrayOf(1.0, 1.0)))
        assertEquals(1.0, law.sphericalAlbedo, 1e-6)
        val line = Illumination.degrees(50.0, 30.0, 40.0, 60.0)
        val seen = Brightness(listOf(line), law, 64, orders = 2, paths = 3000)
        val averages = Averages(seen)
        val random = SeededRandom(17)
        val photons = PhotonCounts(count.toDouble(), 3)
        repeat(60) { averages.add(overlapping(photons.draw(count.toDouble()).toInt(), Periodic(high), random)) }
        val mu = sin(Math.toRadians(50.0))
        val light = sin(Math.toRadians(40.0))
        val first = averages.average(1)
        val second = averages.average(2)
        val expected = secondOrder(depth, mu, light)
        println("τ $depth: order 1 $first, order 2 $second, slab $expected")
        val single = light / (mu + light) / 4 * (1 - exp(-depth * (1 / mu + 1 / light)))
        assertEquals(single, first.mean, 3 * first.error)
        assertEquals(expected, second.mean, 3 * second.error)
        assertTrue(second.error < 0.03 * expected)
    }

    /** ∫ S₂ exp(−t/μ) dt/μ with S₂(t) = ½ ∫ S₁(t′) E₁(|t − t′|) dt′ and S₁ = exp(−t/μ₀)/4: albedo 1, evenly. */
    private fun secondOrder(depth: Double, mu: Double, light: Double): Double {
        val n = 400
        val h = depth / n
        var sum = 0.0
        // ∫ E₁ over a cell is the difference of E₂ at its ends.
        val kernel = DoubleArray(n) { if (it == 0) 2 * (1 - e2(h / 2)) else e2((it - 0.5) * h) - e2((it + 0.5) * h) }
        for (i in 0 until n) {
            val t = (i + 0.5) * h
            var source = 0.0
            for (j in 0 until n) {
                source += exp(-(j + 0.5) * h / light) / 4 * kernel[abs(i - j)]
            }
            sum += source / 2 * exp(-t / mu) * h / mu
        }
        return sum
    }

    /** E₂(x) = ∫₀¹ exp(−x/m) dm. */
    private fun e2(x: Double): Double = (0 until 2000).sumOf { exp(-x / ((it + 0.5) / 2000)) } / 2000

    @Test
    fun `a state has the same bits whatever was measured before and beside it, and another seed has others`() {
        val law = ScatteringLaw.lambert(0.5)
        val lines = listOf(
            Illumination.degrees(30.0, 20.0, 30.0, 0.0),
            Illumination.degrees(30.0, 20.0, 30.0, 5.0),
            Illumination.degrees(50.0, 20.0, 30.0, 25.0),
        )
        val all = Brightness(lines, law, 48, orders = 3, paths = 200)
        all.of(dense(9.0))
        val numbers = all.of(dense())
        for (k in lines.indices) {
            val alone = Brightness(listOf(lines[k]), law, 48, orders = 3, paths = 200).of(dense())
            assertArrayEquals(alone, numbers.copyOfRange(all.transmission(k), all.total(k) + 1))
            assertEquals(alone[1] + alone[2] + alone[3], alone[4], 1e-15)
        }
        val other = Brightness(lines, law, 48, orders = 3, paths = 200, seed = 2).of(dense())
        assertEquals(numbers[1], other[1])
        assertNotEquals(numbers[2], other[2])
        assertNotEquals(numbers[2], all.of(dense(0.41))[2])
    }
}
