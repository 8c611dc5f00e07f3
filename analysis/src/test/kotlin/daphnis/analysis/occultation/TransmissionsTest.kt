package daphnis.analysis.occultation

import daphnis.analysis.insitu.Averages
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sin

@Tag("jdk-neutral")
class TransmissionsTest {
    @Test
    fun `each line of a grid has what rays along it alone have, the azimuths of the first elevation first`() {
        val sheet = HillSheet(Box.centred(12.0, 48.0, 4.0), 1.0)
        val state = overlapping(60, sheet, SeededRandom(5))
        val lines = LineOfSight.grid(doubleArrayOf(20.0, 90.0), doubleArrayOf(0.0, 45.0, 120.0))
        assertEquals(
            listOf(0.0, 45.0, 120.0, 0.0, 45.0, 120.0),
            lines.map {
                Math.round(Math.toDegrees(it.azimuth)).toDouble()
            },
        )
        assertEquals(PI / 2, lines[3].elevation)
        val seen = Transmissions(lines, rays = 60).of(state)
        // Sixty squared rays on a patch four times as long as wide: 120 by 30.
        for ((k, line) in lines.withIndex()) {
            assertEquals(RayCasting(line.elevation, line.azimuth, 120).cast(state).transmission, seen[k])
        }
        assertTrue(abs(seen[0] - seen[1]) > 0.005 && abs(seen[0] - seen[3]) > 0.1) { seen.toList().toString() }
    }

    @Tag("thorough")
    @Test
    fun `a dilute random slab lets exp(-τ over sin B) through, within its error in two of three realisations`() {
        val box = Box.centred(50.0, 50.0, 20.0)
        val sheet = HillSheet(box, 1.0)
        val lines = LineOfSight.grid(doubleArrayOf(15.0, 28.0, 90.0), doubleArrayOf(40.0))
        val mean = 100.0
        val depth = mean * PI / 2500
        val covered = IntArray(lines.size)
        for (seed in 1L..REALISATIONS) {
            val random = SeededRandom(seed)
            val photons = PhotonCounts(mean, seed)
            val averages = Averages(Transmissions(lines, rays = 64))
            // The number of spheres is Poisson's: then the exponential is exact.
            repeat(20) { averages.add(overlapping(photons.draw(mean).toInt(), sheet, random)) }
            for ((k, line) in lines.withIndex()) {
                val t = averages.average(k)
                if (abs(t.mean - exp(-depth / sin(line.elevation))) <= t.error) covered[k]++
            }
        }
        val shares = covered.map { it / REALISATIONS.toDouble() }
        println("dilute slab, τ = $depth: $shares of $REALISATIONS covered")
        // Of fifty a share is good to 7 %.
        val bounds = if (REALISATIONS == 200) 0.6..0.75 else 0.5..0.85
        for (share in shares) assertTrue(share in bounds) { "$shares" }
    }

    @Test
    fun `directions that are none are refused`() {
        assertThrows(IllegalArgumentException::class.java) { LineOfSight(0.0) }
        assertThrows(IllegalArgumentException::class.java) { LineOfSight.degrees(0.0999, 0.0) }
        assertThrows(IllegalArgumentException::class.java) { RayCasting(1e-9) }
        assertEquals(0.1, Math.toDegrees(LineOfSight.degrees(LineOfSight.LOWEST, 0.0).elevation), 1e-15)
        assertThrows(IllegalArgumentException::class.java) { LineOfSight(1.6) }
        assertThrows(IllegalArgumentException::class.java) { LineOfSight(1.0, Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { Transmissions(emptyList(), 0) }
    }

    private companion object {
        val REALISATIONS = if (System.getProperty("daphnis.physics") == "full") 200 else 50
    }
}
