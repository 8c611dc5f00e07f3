package daphnis.analysis.occultation

import daphnis.analysis.insitu.State
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

@Tag("jdk-neutral")
class ScanTest {
    private val box = Box.centred(10.0, 12.0, 3.0)

    /** What every ray of the lattice finds by a search of all spheres and images, as [scan] lays its rays. */
    private fun plain(scan: Scan, state: State): List<Double> {
        val curve = scan.of(state)
        val (c, s) = cos(scan.path) to sin(scan.path)
        val f = scan.footprint
        val (places, tracks) = curve.transmission[0].size to curve.transmission.size
        val spacing = scan.spacing(state, places * f.length * tracks * f.width)
        val lattice = Lattice(f, places, tracks, spacing)
        val images = Images().also { it.prepare(state.boundary, state.time) }
        return curve.transmission.indices.flatMap { track ->
            (0 until places).map { place ->
                var free = 0
                var all = 0
                for (i in 0 until lattice.nu) {
                    for (j in 0 until lattice.nv) {
                        val inU = (i + 0.5) * lattice.stepU - f.length / 2
                        val inV = (j + 0.5) * lattice.stepV - f.width / 2
                        if (f.isDisc && inU * inU + inV * inV > f.length * f.length / 4) continue
                        val u = inU + f.length / 2 + (place - places / 2.0) * f.length
                        val v = inV + f.width / 2 + (track - tracks / 2.0) * f.width
                        all++
                        if (!isBlocked(
                                state,
                                images,
                                u * c - v * s,
                                u * s + v * c,
                                scan.line.elevation,
                                scan.line.azimuth,
                            )
                        ) {
                            free++
                        }
                    }
                }
                free / all.toDouble()
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `light curves are those of a plain search along each ray, along any path and however images stand`() {
        val random = SeededRandom(3)
        for (boundary in listOf(HillSheet(box, 1.0), LeesEdwards(box, -0.7), HillSheet(box, 1.0, true))) {
            val state = overlapping(9, boundary, random) { 0.9 }.let { State(it.population, boundary, 0.83) }
            for ((line, path) in listOf(
                LineOfSight(PI / 2) to 0.0,
                LineOfSight(0.5, 1.1) to PI / 2,
                LineOfSight(0.45, 3.9) to 0.6,
                LineOfSight(0.7, 2.0) to -2.2,
            )) {
                if (!boundary.hasImages(0) && (path == 0.6 || path == -2.2)) continue
                for (footprint in listOf(Footprint.rectangle(3.1, 1.3), Footprint.disc(2.75))) {
                    val scan = Scan(line, footprint, path)
                    val seen = scan.of(state).transmission.flatMap { it.asList() }
                    val expected = plain(scan, state)
                    assertEquals(expected.size, seen.size)
                    for (k in seen.indices) {
                        assertEquals(expected[k], seen[k], 1e-12) {
                            "${boundary.javaClass.simpleName}, B ${line.elevation}, A ${line.azimuth}, path $path, $footprint, $k"
                        }
                    }
                }
            }
        }
    }

    @Test
    fun `footprints that fill the patch lose together what the shadows cover`() {
        val sheet = HillSheet(box, 1.0)
        for (path in listOf(0.0, PI / 2, 0.7)) {
            val state =
                spheres(doubleArrayOf(4.9), doubleArrayOf(-5.5), doubleArrayOf(1.0), doubleArrayOf(1.0), sheet, 0.3)
            val scan = Scan(LineOfSight(0.9, 0.4), Footprint.rectangle(0.5, 0.5), path)
            val all = scan.of(state).transmission.flatMap { it.asList() }
            // A turned rectangle sees images twice and other parts never; along the axes it is the patch.
            if (path != 0.7) assertEquals(PI / sin(0.9) / 120, 1 - all.average(), 0.0015)
            assertTrue(all.all { it in 0.0..1.0 } && all.min() == 0.0 && all.max() == 1.0) { "$path" }
        }
    }

    @Test
    fun `tracks and places are as many as fit, and a whole number of footprints fills the edge`() {
        val state = overlapping(5, HillSheet(box, 1.0), SeededRandom(1))
        fun of(footprint: Footprint, path: Double) =
            Scan(LineOfSight(1.0), footprint, path).of(state).let { it.transmission.size to it.transmission[0].size }
        assertEquals(12 to 10, of(Footprint.rectangle(1.0, 1.0), 0.0))
        assertEquals(10 to 12, of(Footprint.rectangle(1.0, 1.0), PI / 2))
        assertEquals(3 to 3, of(Footprint.rectangle(3.0, 3.5), 0.0))
        // Along a diagonal of 45 degrees the patch is 22/√2 long, and 120 over that wide.
        assertEquals(7 to 15, of(Footprint.disc(1.0), PI / 4))
    }

    @Test
    fun `a footprint larger than the patch and a path that leaves it are refused in words`() {
        val sheet = HillSheet(box, 1.0)
        fun problem(f: Footprint, path: Double) = Scan(LineOfSight(1.0), f, path).problem(sheet)
        assertNull(problem(Footprint.rectangle(10.0, 12.0), 0.0))
        assertTrue(problem(Footprint.rectangle(10.1, 1.0), 0.0)!!.startsWith("it must fit into the patch"))
        assertNotNull(problem(Footprint.rectangle(1.0, 12.1), 0.0))
        assertNull(problem(Footprint.rectangle(12.0, 10.0), PI / 2))
        assertNotNull(problem(Footprint.disc(10.1), 0.0))
        assertTrue("at most 4000000 are looked at" in problem(Footprint.disc(0.001), 0.0)!!)
        val open = HillSheet(box, 1.0, true)
        assertNull(Scan(LineOfSight(1.0), Footprint.disc(1.0), PI / 2).problem(open))
        val why = Scan(LineOfSight(1.0), Footprint.disc(1.0), 0.1).problem(open)
        assertTrue(why!!.startsWith("the path leaves the patch, which does not repeat along x")) { why }
        val state = overlapping(5, sheet, SeededRandom(1))
        assertThrows(IllegalArgumentException::class.java) { Scan(LineOfSight(1.0), Footprint.disc(13.0)).of(state) }
        for (size in listOf(0.0, -1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { Footprint.disc(size) }
            assertThrows(IllegalArgumentException::class.java) { Footprint.rectangle(1.0, size) }
        }
    }

    @Test
    fun `bits of a row are set and counted over whole words and parts of them`() {
        val random = SeededRandom(9)
        val mask = ShadowMask(3, 200)
        val plain = Array(3) { BooleanArray(200) }
        repeat(60) {
            val row = random.nextInt(3)
            val from = random.nextInt(200)
            val to = minOf(199, from + random.nextInt(90))
            mask.block(row, from, to)
            plain[row].fill(true, from, to + 1)
            val (a, b) = listOf(random.nextInt(201), random.nextInt(201)).sorted()
            for (k in 0 until 3) assertEquals((a until b).count { plain[k][it] }, mask.blocked(k, a, b))
            if (it ==
                20
            ) {
                plain.forEachIndexed { k, p -> assertTrue(mask.blocked(k, 0, 200) < 200 || p.all { on -> on }) }
            }
        }
        val full = ShadowMask(3, 200)
        for (row in 0 until 3) full.block(row, if (row == 1) 1 else 0, 199)
        assertFalse(full.isFull())
        full.block(1, 0, 0)
        assertTrue(full.isFull())
    }
}
