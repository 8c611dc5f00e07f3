package daphnis.analysis.moonlet

import daphnis.analysis.insitu.State
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.util.Random
import kotlin.math.abs
import kotlin.math.exp

class MoonletMapTest {
    private val sheet = HillSheet(Box.centred(40.0, 100.0, 4.0), 1.0)

    /**
     * A body anywhere, and a ring with two gaps of Gaussian shape, [at] to either side and 1 wide, of 0.8 of the surface
     * density: behind the body outside, ahead inside. Where images slide, the nearest one of the body counts.
     */
    private fun state(random: Random, time: Double, depth: Double, at: Double): State {
        val bodyX = 40 * (random.nextDouble() - 0.5)
        val bodyY = 100 * (random.nextDouble() - 0.5)
        val x = ArrayList<Double>()
        val y = ArrayList<Double>()
        val offset = sheet.shear!!.offset(time)
        while (x.size < 4000) {
            val dx = 40 * (random.nextDouble() - 0.5)
            val dy = 100 * (random.nextDouble() - 0.5)
            val isDownstream = dx * dy < 0
            if (isDownstream && random.nextDouble() < depth * exp(-(abs(dx) - at) * (abs(dx) - at) / 2)) continue
            // Back into the box, as a boundary does.
            val boxes = Math.rint((bodyX + dx) / 40)
            val inX = bodyX + dx - boxes * 40
            val alongY = bodyY + dy - boxes * offset
            x += inX
            y += alongY - Math.rint(alongY / 100) * 100
        }
        x += bodyX
        y += bodyY
        val n = x.size
        val zero = { DoubleArray(n) }
        val p = Population(
            x.toDoubleArray(),
            y.toDoubleArray(),
            zero(),
            zero(),
            zero(),
            zero(),
            DoubleArray(n) { 0.1 },
            DoubleArray(n) { if (it == n - 1) 1e6 else 2.0 },
        )
        return State(p, sheet, time, 1.0, n - 1)
    }

    private fun map(seed: Long, states: Int, depth: Double = 0.8, at: Double = 3.0): MoonletMap {
        val random = Random(seed)
        return MoonletMap(4000, 41, 21, 40.0, 100.0).also { map ->
            repeat(states) { map.add(state(random, 0.37 * it, depth, at)) }
        }
    }

    @Tag("thorough")
    @Test
    fun `gaps are found where they were made, and errors cover that in 60 to 80 of 100 maps`() {
        val found = List(60) { map(it.toLong(), 16).gaps(5.0, 45.0, 8.0)!! }
        assertEquals(6.0, found.map { it.separation }.average(), 0.03)
        assertTrue(found.none { it.isLane })
        val separations = found.count { abs(it.separation - 6) < it.separationError }
        assertTrue(separations in 36..48) { "$separations of 60" }
        // The deepest is 0.8 of what is there without gaps; all of a gap, and against the mean, it is less.
        val depth = found.map { it.depth }.average()
        assertEquals(0.65, depth, 0.1)
        val depths = found.count { abs(it.depth - depth) < it.depthError }
        assertTrue(depths in 36..48) { "$depths of 60" }
    }

    @Test
    fun `a trough around the orbit of the body is a lane, and no propeller`() {
        val found = List(20) { map(it.toLong(), 16, at = 0.0).gaps(5.0, 45.0, 8.0)!! }
        assertTrue(found.all { it.isLane }) { "${found.count { it.isLane }} of 20" }
        // Of three states too: there is no error, but the middle is the deepest place.
        assertTrue(map(1, 3, at = 0.0).gaps(5.0, 45.0, 8.0)!!.isLane)
    }

    @Test
    fun `a uniform ring has no propeller, and a map of no states none either`() {
        assertNull(map(3, 16, depth = 0.0).gaps(5.0, 45.0, 8.0))
        assertNull(MoonletMap(4000, 41, 21, 40.0, 100.0).gaps(5.0, 45.0, 8.0))
        assertThrows(IllegalArgumentException::class.java) { MoonletMap(0, 40, 21, 40.0, 100.0) }
    }

    @Test
    fun `the excess is of the particles alone, 0 on average, and the body in the middle`() {
        val map = map(5, 8)
        val excess = map.excess()
        assertEquals(0.0, excess.average(), 1e-12)
        assertEquals(0.0, map.x(20))
        assertEquals(0.0, map.y(10))
        val wake = map.wake(5.0, 45.0)
        assertTrue(wake[23] < -0.6 && wake[17] < -0.6 && wake[10] > -0.2) { "${wake[23]} ${wake[17]} ${wake[10]}" }
        // On the other side of the body, upstream, nothing is missing.
        val upstream = (0 until 21).filter { map.y(it) in 5.0..45.0 }.map { excess[23 * 21 + it] }.average()
        assertTrue(upstream > -0.2) { "$upstream" }
        val few = map(5, 3).gaps(5.0, 45.0, 8.0)!!
        assertTrue(few.separationError.isNaN() && few.depthError.isNaN() && !few.isLane)
    }
}
