package daphnis.analysis.occultation

import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt
import kotlin.system.measureTimeMillis

/** What a star behind a million spheres costs: docs/validation.md has the numbers. */
@Tag("thorough")
class ScanWorkTest {
    @Test
    fun `light behind a million spheres costs at most 60 words of a mask, or a ray, for each`() {
        for (depth in listOf(0.5, 1.5)) {
            val edge = sqrt(SPHERES * PI / depth)
            val state = overlapping(SPHERES, HillSheet(Box.centred(edge, edge, 6.0), 1.0), SeededRandom(1))
            for ((elevation, path) in listOf(90.0 to 0.0, 28.0 to 0.0, 10.0 to 90.0, 28.0 to 37.0, 0.1 to 37.0)) {
                val line = LineOfSight.degrees(elevation, 40.0)
                val scan = Scan(line, Footprint.rectangle(20.0, 10.0), Math.toRadians(path))
                var words = 0L
                val took = measureTimeMillis { words = scan.caster(state).cast().written }
                println("τ = $depth, B = $elevation, path $path: $words words in $took ms")
                assertTrue(words < 60L * SPHERES) { "$words" }
            }
            var rays = 0L
            val took = measureTimeMillis { rays = RayCasting(Math.toRadians(0.1), 40.0, 256).cast(state).asked }
            println("τ = $depth, B = 0.1, transmission: $rays rays in $took ms")
            assertTrue(rays < SPHERES) { "$rays" }
        }
    }

    private companion object {
        const val SPHERES = 1_000_000
    }
}
