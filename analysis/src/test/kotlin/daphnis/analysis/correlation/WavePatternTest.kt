package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.atan
import kotlin.math.cos
import kotlin.math.sqrt

@Tag("jdk-neutral")
class WavePatternTest {
    private val box = Box.centred(60.0, 72.0, 2.0)
    private val sheet = HillSheet(box, 1.0)

    /** When images of [sheet] have slid by 0.37 of the patch. */
    private val time = (1 - 0.37) * 72 / 90

    /** 4 waves across, 2 along, leaning with the images. */
    private val ky = 2 * PI / 72 * 2
    private val kx = (2 * PI * 4 - ky * 0.37 * 72) / 60

    private fun state(x: DoubleArray, y: DoubleArray, boundary: BoundaryConditions = sheet, at: Double = time): State {
        val n = x.size
        val zero = DoubleArray(n)
        return State(
            Population(
                x,
                y,
                zero,
                zero,
                zero,
                zero,
                DoubleArray(n) {
                    0.1
                },
                DoubleArray(n) { 1.0 },
            ),
            boundary,
            at,
        )
    }

    /**
     * Autocorrelations of [states] independent states of [count] particles of density 1 + [depth] cos(k·r + some
     * phase).
     */
    private fun waves(
        count: Int,
        depth: Double,
        states: Int,
        random: SeededRandom,
        mirror: Int = 1,
    ): Pair<List<DoubleArray>, SurfaceMap> {
        lateinit var map: SurfaceMap
        val maps = List(states) {
            val phase = random.nextDouble(0.0, 2 * PI)
            val x = DoubleArray(count)
            val y = DoubleArray(count)
            for (k in 0 until count) {
                do {
                    x[k] = random.nextDouble(-30.0, 30.0)
                    y[k] = random.nextDouble(-36.0, 36.0)
                } while (random.nextDouble() * (1 + depth) > 1 + depth * cos(kx * x[k] + ky * y[k] + phase))
                y[k] *= mirror
            }
            // Mirrored, images slide the other way.
            map = SurfaceMap.of(state(x, y, at = time * mirror), 2.5)
            map.autocorrelation(map.nx / 2, map.ny / 2)
        }
        return maps to map
    }

    private fun pattern(maps: Pair<List<DoubleArray>, SurfaceMap>) = WavePattern.of(
        maps.first,
        maps.second.nx / 2,
        maps.second.ny / 2,
        maps.second.dx,
        maps.second.dy,
    )

    @Test
    fun `a leaning wave comes back with its pitch and spacing, and its mirror with the other sign`() {
        val found = pattern(waves(3000, 0.5, 20, SeededRandom(3)))!!
        assertEquals(atan(ky / kx), found.pitch.mean, 0.01)
        assertEquals(2 * PI / kx, found.spacing.mean, 0.1)
        assertTrue(found.pitch.error > 0 && found.spacing.error > 0 && found.contrast > 20)
        val mirrored = pattern(waves(3000, 0.5, 20, SeededRandom(3), mirror = -1))!!
        assertEquals(-atan(ky / kx), mirrored.pitch.mean, 0.01)
        assertEquals(2 * PI / kx, mirrored.spacing.mean, 0.1)
    }

    @Tag("thorough")
    @Test
    fun `errors cover the truth in two of three realisations, and few particles do not shift it`() {
        for ((count, depth) in listOf(400 to 0.7, 1500 to 0.4)) {
            val random = SeededRandom(11)
            val truth = doubleArrayOf(atan(ky / kx), 2 * PI / kx)
            val covered = IntArray(2)
            val sum = DoubleArray(2)
            val squares = DoubleArray(2)
            repeat(REALISATIONS) {
                val found = pattern(waves(count, depth, 20, random))
                assertNotNull(found)
                for ((q, a) in listOf(found!!.pitch, found.spacing).withIndex()) {
                    val off = a.mean - truth[q]
                    if (Math.abs(off) <= a.error) covered[q]++
                    sum[q] += off
                    squares[q] += off * off
                }
            }
            for (q in 0..1) {
                assertTrue(covered[q] in REALISATIONS * 60 / 100..REALISATIONS * 76 / 100) {
                    "$count particles: covered ${covered.toList()} of $REALISATIONS"
                }
                val scatter = sqrt(squares[q] / REALISATIONS)
                assertTrue(Math.abs(sum[q] / REALISATIONS) < 3.5 * scatter / sqrt(REALISATIONS.toDouble())) {
                    "$count particles: ${sum[q] / REALISATIONS} of $scatter"
                }
            }
        }
    }

    /** As [waves], but each particle stays from state to state, and is drawn anew with the chance [fresh]. */
    private fun lasting(count: Int, depth: Double, states: Int, fresh: Double, random: SeededRandom) = run {
        lateinit var map: SurfaceMap
        val x = DoubleArray(count)
        val y = DoubleArray(count)
        val maps = List(states) { state ->
            for (k in 0 until count) {
                if (state > 0 && random.nextDouble() > fresh) continue
                do {
                    x[k] = random.nextDouble(-30.0, 30.0)
                    y[k] = random.nextDouble(-36.0, 36.0)
                } while (random.nextDouble() * (1 + depth) > 1 + depth * cos(kx * x[k] + ky * y[k]))
            }
            map = SurfaceMap.of(state(x.copyOf(), y.copyOf()), 2.5)
            map.autocorrelation(map.nx / 2, map.ny / 2)
        }
        maps to map
    }

    @Tag("thorough")
    @Test
    fun `errors cover the truth in two of three realisations of states that resemble one another`() {
        val random = SeededRandom(12)
        val truth = doubleArrayOf(atan(ky / kx), 2 * PI / kx)
        for ((states, fresh) in listOf(40 to 0.5, 80 to 0.25)) {
            val found = List(REALISATIONS) { pattern(lasting(400, 0.7, states, fresh, random)) }.filterNotNull()
            for ((q, of) in listOf<(WavePattern) -> BlockAverage>({ it.pitch }, { it.spacing }).withIndex()) {
                val known = found.map(of).filter { it.isLevelled }
                val covered = known.count { Math.abs(it.mean - truth[q]) <= it.error }
                val spread = sqrt(known.sumOf { (it.mean - truth[q]) * (it.mean - truth[q]) } / known.size)
                assertTrue(known.size > REALISATIONS * 9 / 10) { "$states states: ${known.size} errors" }
                assertTrue(covered in known.size * 60 / 100..known.size * 76 / 100) {
                    "$states states, $fresh fresh: covered $covered of ${known.size}"
                }
                assertEquals(1.0, spread / known.map { it.error }.average(), 0.15) { "$states states, $fresh fresh" }
            }
        }
    }

    @Test
    fun `waves along the orbit alone have no radial spacing`() {
        val box = LeesEdwards(Box.centred(60.0, 72.0, 2.0), 0.5)
        val random = SeededRandom(2)
        val maps = List(4) {
            val x = DoubleArray(3000) { random.nextDouble(-30.0, 30.0) }
            val y = DoubleArray(3000)
            for (k in 0 until 3000) {
                do {
                    y[k] = random.nextDouble(-36.0, 36.0)
                } while (random.nextDouble() * 2 > 1 + cos(2 * PI / 72 * 5 * y[k]))
            }
            SurfaceMap.of(state(x, y, box, 0.0), 2.5).autocorrelation(12, 14)
        }
        assertNull(WavePattern.of(maps, 12, 14, 2.5, 72.0 / 29))
    }

    /** Of [patches] patches of [states] states by [draw], those in which a pattern is found. */
    private fun found(patches: Int, states: Int, draw: (Long) -> State): Int = (0 until patches).count { patch ->
        lateinit var map: SurfaceMap
        val maps = List(states) {
            map = SurfaceMap.of(draw(1L + patch * states + it), 2.5)
            map.autocorrelation(12, 14)
        }
        WavePattern.of(maps, 12, 14, map.dx, map.dy) != null
    }

    @Test
    fun `a uniform patch has no pattern, be its states one or many, different or the same`() {
        fun even(seed: Long) = uniform(2000, sheet, seed).let { State(it.population, sheet, time) }
        assertTrue(found(200, 1) { even(it) } <= 2)
        assertTrue(found(50, 8) { even(it) } <= 1)
        // States a step apart hold the same noise; as many as there may be, they are no better than one.
        assertTrue(found(100, 5) { even((it - 1) / 5) } <= 2)
    }

    @Test
    fun `round clumps are no wakes`() {
        fun clumps(seed: Long): State {
            val random = SeededRandom(1000 + seed)
            val x = DoubleArray(2000)
            val y = DoubleArray(2000)
            for (k in 0 until 2000) {
                val centre = k - k % 20
                x[k] =
                    if (k == centre) {
                        random.nextDouble(-30.0, 30.0)
                    } else {
                        within(x[centre] + 1.5 * random.nextGaussian(), 60.0)
                    }
                y[k] =
                    if (k == centre) {
                        random.nextDouble(-36.0, 36.0)
                    } else {
                        within(y[centre] + 1.5 * random.nextGaussian(), 72.0)
                    }
            }
            return state(x, y, at = 0.0)
        }
        assertTrue(found(100, 1) { clumps(it) } <= 2)
        assertTrue(found(50, 6) { clumps(it) } <= 1)
    }

    @Test
    fun `more states show a weaker wave`() {
        // Power of the wave about once that of counting.
        val random = SeededRandom(21)
        assertNull(pattern(waves(400, 0.3, 1, random)))
        val found = pattern(waves(400, 0.3, 60, random))!!
        assertEquals(atan(ky / kx), found.pitch.mean, 4 * found.pitch.error)
    }

    private fun within(v: Double, length: Double) = v - length * Math.floor((v + length / 2) / length)

    @Test
    fun `none, one and empty states`() {
        assertNull(WavePattern.of(emptyList(), 10, 10, 1.0, 1.0))
        assertNull(WavePattern.of(listOf(DoubleArray(21 * 21)), 10, 10, 1.0, 1.0))
        assertNull(WavePattern.of(listOf(DoubleArray(5 * 5) { 1.0 }), 2, 2, 1.0, 1.0))
        assertThrows(IllegalArgumentException::class.java) { WavePattern.of(listOf(DoubleArray(10)), 10, 10, 1.0, 1.0) }
        val one = pattern(waves(4000, 0.5, 1, SeededRandom(3)))!!
        assertEquals(atan(ky / kx), one.pitch.mean, 0.03)
        assertTrue(one.pitch.error.isNaN() && one.spacing.error.isNaN())
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
