package daphnis.core.engine.horizon

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.Pieces
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.pow

class MemberSizesTest {
    private val n = 20_000

    @Test
    fun `spheres of one size, or nearly, all have cells`() {
        assertEquals(0.5, choose(DoubleArray(n) { 0.5 }))
        val random = SeededRandom(1)
        val radii = DoubleArray(n) { random.nextDouble(0.9, 1.1) }
        assertEquals(radii.max(), choose(radii))
    }

    @Test
    fun `a moonlet has none`() {
        assertEquals(0.4, choose(DoubleArray(n) { if (it == 7) 40.0 else 0.4 }))
    }

    @Test
    fun `of many sizes a few of the largest have none`() {
        // n(r) of the power -3, by inversion of its cumulative distribution, from 0.3 to 9.
        val random = SeededRandom(2)
        val (a, b) = listOf(0.3, 9.0).map { it.pow(-2) }
        val radii = DoubleArray(n) { (a + random.nextDouble(0.0, 1.0) * (b - a)).pow(-0.5) }
        val limit = choose(radii, half = 40.0)
        val giants = radii.count { it > limit }
        assertTrue(giants in 1..n / 50) { "$giants of $n above $limit" }
        assertTrue(radii.any { it == limit })
    }

    @Test
    fun `small spheres far from the origin, where floats are coarse, do not decide`() {
        val radii = DoubleArray(n) { if (it == 7) 40.0 else 0.4 }
        assertEquals(40.0, choose(radii, middle = 1e5))
        assertEquals(0.4, choose(radii, middle = 100.0))
    }

    @Test
    fun `the largest and the mean are found wherever large spheres are, in pieces too`() {
        val random = SeededRandom(4)
        for (last in listOf(n - 1, n / 2, 0)) {
            val radii = DoubleArray(n) { if (it == last) 1.1 else random.nextDouble(0.9, 1.0) }
            assertEquals(1.1, choose(radii))
            for (loop in listOf(InlineLoop, Pieces)) {
                val sizes = MemberSizes()
                assertEquals(1.1, choose(radii, sizes = sizes, loop = loop))
                assertEquals(radii.average(), sizes.mean, 1e-12)
            }
        }
    }

    private fun choose(
        radii: DoubleArray,
        middle: Double = 0.0,
        half: Double = 100.0,
        sizes: MemberSizes = MemberSizes(),
        loop: RangeLoop = InlineLoop,
    ): Double {
        val random = SeededRandom(3)
        fun column() = DoubleArray(n) { middle + random.nextDouble(-half, half) }
        fun speeds() = DoubleArray(n) { 0.1 * random.nextGaussian() }
        val p = Population(column(), column(), column(), speeds(), speeds(), speeds(), radii, radii)
        val box = middle.let { Box(it - half, it - half, it - half, it + half, it + half, it + half) }
        val space = EpochSpace(InlineLoop)
        space.measure(p, Periodic(box), 0.1)
        val limit = sizes.choose(p, space.frame, space.cells.speeds.rms, loop)
        space.frame.memberRadius = limit
        val tuning = HorizonTuning(2)
        assertTrue(space.frame.begin(tuning))
        space.cells.sort(p, tuning, 0.0)
        val members = (0 until space.cells.members).map { radii[space.cells.order[it]] }
        assertTrue(members.size > n / 2 && members.all { it <= limit })
        return limit
    }
}
