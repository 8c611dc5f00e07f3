package daphnis.analysis.brightness

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.occultation.PhotonCounts
import daphnis.analysis.occultation.Transmissions
import daphnis.analysis.occultation.overlapping
import daphnis.analysis.occultation.spheres
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sin
import kotlin.math.tan

@Tag("jdk-neutral")
class BrightnessTest {
    private val box = Box.centred(10.0, 12.0, 8.0)

    private fun at(time: Double, boundary: BoundaryConditions, count: Int = 40, radius: Double = 0.7): State {
        val state = overlapping(count, boundary, SeededRandom(3)) { radius * (1 + it % 3) / 2 }
        return State(state.population, boundary, time)
    }

    private val sheets = listOf(
        HillSheet(box, 1.0),
        LeesEdwards(box, 0.7),
        LeesEdwards(box, -0.7),
        HillSheet(box, 1.0, true),
        Periodic(box),
    )

    private val table = PhaseTable(
        doubleArrayOf(0.0, 0.3, 1.0, PI),
        doubleArrayOf(2.5, 1.9, 1.0, 0.1),
    )

    @Test
    fun `Lommel and Seeliger at opposition have ϖ f(0) over 8 times what does not come through, in every state`() {
        val directions = listOf(90.0 to 0.0, 40.0 to 0.0, 28.0 to 70.0, 10.0 to 200.0, 1.0 to 33.0)
        val lines = directions.map { (b, a) -> Illumination.degrees(b, a, b, 0.0) }
        for (boundary in sheets) {
            val state = at(0.83, boundary)
            val light = Transmissions(directions.map { LineOfSight.degrees(it.first, it.second) }, 64).of(state)
            for ((law, grains) in listOf(
                ScatteringLaw.lommelSeeliger(0.7) to 0.7,
                ScatteringLaw.lommelSeeliger(0.7, table) to 0.7 * 2.5,
                ScatteringLaw.ofSpheres(0.3, table) to 2 * 0.3 * 2.5,
            )) {
                val seen = Brightness(lines, law, 64)
                val numbers = seen.of(state)
                for (k in lines.indices) {
                    assertEquals(light[k], numbers[seen.transmission(k)])
                    assertEquals(grains / 8 * (1 - light[k]), numbers[seen.total(k)], 1e-14) { "${directions[k]}" }
                }
            }
        }
    }

    @Test
    fun `one sphere alone has the phase curve of its law`() {
        // Without images along x, which would stand in its light where this is low.
        val state = spheres(
            doubleArrayOf(0.2),
            doubleArrayOf(-0.3),
            doubleArrayOf(0.4),
            doubleArrayOf(1.0),
            HillSheet(Box.centred(5.0, 5.0, 4.0), 1.0, true),
        )
        fun lambert(a: Double) = 8 / (3 * PI) * (sin(a) + (PI - a) * cos(a))
        fun seeliger(a: Double) = if (a == 0.0) 1.0 else 1 - sin(a / 2) * tan(a / 2) * ln(1 / tan(a / 4))
        for (degrees in listOf(0.0, 20.0, 60.0, 100.0, 140.0)) {
            // From above, where the sphere hides no image of itself, and lit from low behind or above.
            val line = Illumination.degrees(90.0, 0.0, 90 - degrees, degrees)
            val angle = Math.toRadians(degrees)
            for ((law, product) in listOf(
                ScatteringLaw.lambert(0.9) to 0.9 * lambert(angle),
                ScatteringLaw.lommelSeeliger(0.8) to 0.8 / 2 * seeliger(angle),
                ScatteringLaw.lommelSeeliger(0.8, table) to 0.8 * table.at(angle) / 2 * seeliger(angle),
                ScatteringLaw.ofSpheres(0.6, table) to 0.6 * table.at(angle),
            )) {
                assertEquals(product, law.ofSphere(angle), 1e-12)
                val seen = Brightness(listOf(line), law, 800).of(state)
                assertEquals(product / 4 * PI / 25, seen[1], 4e-3 * product / 4 * PI / 25 + 2e-5) {
                    "${law.words} at $degrees"
                }
            }
        }
    }

    @Test
    fun `shadows are those that a search of all spheres and images finds, from above and from below`() {
        for (boundary in sheets + HillSheet(box, 1.0, true)) {
            val state = at(0.83, boundary, 9, 1.0)
            val field = FieldRay(SphereField(state))
            val p = state.population
            var free = 0
            val random = SeededRandom(8)
            repeat(600) {
                val k = random.nextInt(p.size)
                val normal = LineOfSight.direction(
                    StrictMath.asin(random.nextDouble(-1.0, 1.0)),
                    random.nextDouble(0.0, 6.3),
                )
                val toward = LineOfSight.direction(random.nextDouble(-1.5, 1.5), random.nextDouble(0.0, 6.3))
                val place = doubleArrayOf(
                    p.x[k] + p.radius[k] * normal[0],
                    p.y[k] + p.radius[k] * normal[1],
                    p.z[k] + p.radius[k] * normal[2],
                )
                if (abs(toward[2]) < 0.2 || (0..2).sumOf { normal[it] * toward[it] } <= 0) return@repeat
                val expected = PlainPaths(state).first(place, toward)
                assertEquals(expected == null, field.isFree(place, toward)) { "${boundary.javaClass.simpleName} $it" }
                assertEquals(expected != null, field.meets(place, toward))
                if (expected == null) {
                    free++
                } else {
                    assertEquals(expected.sphere, field.sphere)
                    assertArrayEquals(expected.normal, field.normal, 1e-9)
                }
            }
            assertTrue(free in 60..450) { "$free" }
        }
    }

    @Test
    fun `light and eye may change places, with the cosines`() {
        for (boundary in sheets.take(3)) {
            val state = at(0.83, boundary)
            for (law in listOf(ScatteringLaw.lambert(0.8), ScatteringLaw.lommelSeeliger(0.8, table))) {
                for ((b, light, phase) in listOf(Triple(50.0, 20.0, 40.0), Triple(25.0, -60.0, 110.0))) {
                    val there = Illumination.degrees(b, 25.0, light, phase)
                    // Light from below is an eye from above once the sheet is upside down.
                    val turned = if (light > 0) state else upsideDown(state)
                    val eye = LineOfSight(abs(there.lightElevation), there.lightAzimuth)
                    val sign = if (light > 0) 1 else -1
                    val again = Illumination(eye, sign * there.eye.elevation, -there.phaseAngle)
                    assertEquals(Math.toRadians(25.0), again.lightAzimuth, 1e-12)
                    val forth = Brightness(listOf(there), law, 500).of(state)[1] * sin(there.eye.elevation)
                    val back = Brightness(listOf(again), law, 500).of(turned)[1] * sin(eye.elevation)
                    assertEquals(forth, back, 0.01 * forth) { "${boundary.javaClass.simpleName} ${law.words} $light" }
                    assertTrue(forth > 1e-3)
                }
            }
        }
    }

    private fun upsideDown(state: State): State {
        val p = state.population
        fun copy(of: DoubleArray, sign: Int = 1) = DoubleArray(p.size) { sign * of[it] }
        return spheres(copy(p.x), copy(p.y), copy(p.z, -1), copy(p.radius), state.boundary, state.time)
    }

    @Tag("thorough")
    @Test
    fun `spheres without correlation have the brightness of a slab, which is more at opposition`() {
        // So high that at one degree no sphere is behind the same ones in both directions; many, so that τ is exact.
        val high = Box.centred(60.0, 60.0, 6000.0)
        val count = 144
        val depth = count * PI / 3600
        val sine = sin(Math.toRadians(28.0))
        val lines = listOf(0.0, 1.0).map { Illumination.degrees(28.0, 40.0, 28.0, it) }
        val seen = Brightness(lines, ScatteringLaw.lambert(1.0), 128)
        val photons = PhotonCounts(count.toDouble(), 5)
        val averages = Averages(seen)
        val random = SeededRandom(11)
        repeat(REALISATIONS) {
            averages.add(overlapping(photons.draw(count.toDouble()).toInt(), Periodic(high), random))
        }
        val x = depth / sine
        assertEquals(0.126, depth, 0.001)
        val full = averages.average(seen.total(0))
        val far = averages.average(seen.total(1))
        println("slab of τ = $depth at 28°: I/F = $full A at opposition, $far A far from it")
        val phase = ScatteringLaw.lambert(1.0).ofSphere(Math.toRadians(1.0))
        assertEquals(2.0 / 3 * (1 - exp(-x)), full.mean, 3 * full.error)
        assertEquals(phase / 8 * (1 - exp(-2 * x)), far.mean, 3 * far.error)
        assertTrue(full.error < 0.01 * full.mean)
        val ratio = averages.series(seen.total(0)).average() / averages.series(seen.total(1)).average()
        assertEquals(2 / (1 + exp(-x)), ratio * phase * 3 / 8, 0.01)
    }

    private companion object {
        val REALISATIONS = if (System.getProperty("daphnis.physics") == "full") 2000 else 150
    }
}
