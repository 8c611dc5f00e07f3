package daphnis.analysis.occultation

import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.lang.management.ManagementFactory
import kotlin.math.PI
import kotlin.math.sqrt

/** How long a star takes behind a million spheres: docs/validation.md has the numbers. */
@Tag("thorough")
class ScanTimeTest {
    @Test
    fun `a scan behind a million spheres takes two seconds of a processor at most`() {
        val threads = ManagementFactory.getThreadMXBean()
        for (depth in listOf(0.5, 1.5)) {
            val edge = sqrt(SPHERES * PI / depth)
            val state = overlapping(SPHERES, HillSheet(Box.centred(edge, edge, 6.0), 1.0), SeededRandom(1))
            for ((elevation, path) in listOf(90.0 to 0.0, 28.0 to 0.0, 10.0 to 90.0, 28.0 to 37.0, 0.1 to 37.0)) {
                val line = LineOfSight.degrees(elevation, 40.0)
                val scan = Scan(line, Footprint.rectangle(20.0, 10.0), Math.toRadians(path))
                val took = List(3) {
                    val before = threads.currentThreadCpuTime
                    val curve = scan.of(state)
                    ScanStatistics().add(curve)
                    (threads.currentThreadCpuTime - before) / 1e9
                }
                println("τ = $depth, B = $elevation, path $path: $took s")
                assertTrue(took.min() < 2) { "$took" }
            }
            val before = threads.currentThreadCpuTime
            Transmissions(listOf(LineOfSight.degrees(0.1, 40.0))).of(state)
            val took = (threads.currentThreadCpuTime - before) / 1e9
            println("τ = $depth, B = 0.1, transmission: $took s")
            assertTrue(took < 2) { "$took" }
        }
    }

    private companion object {
        const val SPHERES = 1_000_000
    }
}
