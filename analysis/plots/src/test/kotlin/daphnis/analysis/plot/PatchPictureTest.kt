package daphnis.analysis.plot

import daphnis.analysis.insitu.State
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO

class PatchPictureTest {
    @TempDir
    lateinit var home: Path

    private val box = Box.centred(10.0, 14.0, 8.0)

    /** Spheres that stick out of faces, of a corner, of none. */
    private fun state(boundary: BoundaryConditions, time: Double): State {
        val x = doubleArrayOf(4.8, -2.0, 1.0, -4.9, 3.0)
        val y = doubleArrayOf(1.0, 6.7, -6.8, -6.9, 2.0)
        val n = x.size
        return State(
            Population(
                x,
                y,
                DoubleArray(n) {
                    it * 0.5
                },
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n) { 0.5 },
                DoubleArray(n) { 1.0 },
            ),
            boundary,
            time,
        )
    }

    private fun picture(
        boundary: BoundaryConditions,
        x: DoubleArray,
        y: DoubleArray,
        z: DoubleArray,
        r: Double,
    ): PatchPicture {
        val n = x.size
        fun all(value: Double) = DoubleArray(n) { value }
        return PatchPicture(
            State(Population(x, y, z, all(0.0), all(0.0), all(0.0), all(r), all(1.0)), boundary, 0.0),
            "m",
        )
    }

    private fun size(name: String): Pair<Int, Int> =
        ImageIO.read(home.resolve("$name.png").toFile()).let { it.width to it.height }

    @Test
    fun `all of a patch that is thin along the orbit lies along its length`() {
        val thin =
            picture(
                HillSheet(Box.centred(200.0, 5.0, 20.0), 1.0),
                doubleArrayOf(-90.0, 80.0),
                DoubleArray(2),
                DoubleArray(2),
                1.0,
            )
        assertEquals(0, thin.across)
        assertEquals(null, thin.partAbove)
        thin.writeAbove(home, "above")
        val (width, height) = size("above")
        assertTrue(width == 1400 && height in 80..110) { "$width × $height" }
        val circles = Regex("<circle cx=\"([-0-9.]+)\"").findAll(Files.readString(home.resolve("above.svg"))).map {
            it.groupValues[1].toDouble()
        }
        assertEquals(setOf(70.0, 1260.0), circles.toSet())
        val long =
            picture(
                HillSheet(Box.centred(10.0, 12600.0, 0.6), 1.0),
                DoubleArray(1),
                DoubleArray(1),
                DoubleArray(1),
                0.1,
            )
        assertEquals("The first 40 m of 12600 m", long.partAbove)
    }

    @Test
    fun `a few spheres that are far out do not make a line of the layer`() {
        fun layer(highest: Double) = picture(
            HillSheet(Box.centred(20.0, 20.0, 20.0), 1.0),
            DoubleArray(500),
            DoubleArray(500),
            DoubleArray(500) { if (it == 7) highest else 0.5 * (it % 2) },
            0.5,
        )
        assertEquals("1 of 500 spheres are farther up or down", layer(50.0).leftOutSide)
        assertEquals("1 of 500 spheres are farther up or down", layer(-2.6).leftOutSide)
        assertEquals(null, layer(2.4).leftOutSide)
        fun height(highest: Double) = layer(highest).writeSide(home, "side").let { size("side").second }
        // Three times as high as all others, from below to above, and the strip.
        assertEquals(6.0 / 20.0 * 1400, height(50.0) - 56.0, 2.0)
        assertEquals(4.0 / 20.0 * 1400, height(1.5) - 56.0, 2.0)
    }

    @Test
    fun `a tall picture is no higher than a wide one is wide, and has room for its bar`() {
        val tall =
            picture(
                Periodic(Box.centred(15.0, 15.0, 60.0)),
                DoubleArray(2),
                DoubleArray(2),
                doubleArrayOf(-29.5, 29.5),
                0.5,
            )
        tall.writeSide(home, "side")
        val (width, height) = size("side")
        assertTrue(width in 350..450 && height in 1440..1470) { "$width × $height" }
        assertTrue(">2 m</text>" in Files.readString(home.resolve("side.svg")))
    }

    @Test
    fun `each material and the bodies have colours and names of their own`() {
        val population = Population(
            doubleArrayOf(-2.0, 0.0, 2.0),
            DoubleArray(3),
            DoubleArray(3),
            DoubleArray(3),
            DoubleArray(3),
            DoubleArray(3),
            DoubleArray(3) { 0.5 },
            DoubleArray(3) { 1.0 },
        ).withMaterial(intArrayOf(0, 1, 1), listOf("ice", "rock"))
        val state = State(population, HillSheet(box, 1.0), 0.0, 1.0, firstBody = population.id.max())
        PatchPicture(state, "m").writeAbove(home, "above")
        val svg = Files.readString(home.resolve("above.svg"))
        assertTrue(listOf(">ice<", ">rock<", ">moonlets<").all { it in svg }) { svg }
        val drawn = circles("above", 10.0).filter { it.second > 0 }
        assertEquals(3, drawn.map { it.third }.toSet().size) { "$drawn" }
    }

    /** Centres of the circles in a picture, in lengths from its lower left corner, and their colours. */
    private fun circles(name: String, height: Double): List<Triple<Double, Double, String>> {
        val scale = 1400 / 14.0
        return Regex(
            "<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\" r=\"[0-9.]+\" fill=\"(#[0-9a-f]+)\"",
        ).findAll(Files.readString(home.resolve("$name.svg")))
            .map {
                Triple(
                    it.groupValues[1].toDouble() / scale,
                    height - it.groupValues[2].toDouble() / scale,
                    it.groupValues[3],
                )
            }.toList()
    }

    @Test
    fun `discs from above are those of all images that touch the box, whichever axis slides`() {
        for (boundary in listOf(LeesEdwards(box, 0.7), LeesEdwards(box, -0.7), HillSheet(box, 1.0))) {
            for (time in listOf(0.0, 0.41)) {
                val state = state(boundary, time)
                val images = Images().also { it.prepare(boundary, time) }
                val expected = ArrayList<Pair<Double, Double>>()
                for (k in 0 until state.population.size) {
                    for (ix in -4..4) {
                        for (iy in -4..4) {
                            val code = Images.code(ix, iy, 0)
                            val x = state.population.x[k] + images.shift(code, 0) + 5
                            val y = state.population.y[k] + images.shift(code, 1) + 7
                            if (x > -0.5 && x < 10.5 && y > -0.5 && y < 14.5) expected += y to x
                        }
                    }
                }
                PatchPicture(state, "m").writeAbove(home, "above")
                val drawn = circles("above", 10.0)
                assertEquals(expected.size, drawn.size) { "${boundary.javaClass.simpleName} at $time" }
                for ((y, x) in expected) {
                    assertTrue(
                        drawn.any {
                            Math.hypot(it.first - y, it.second - x) < 0.001
                        },
                    ) { "${boundary.javaClass.simpleName} at $time: none at $y, $x" }
                }
            }
        }
    }

    @Test
    fun `from the side an image that has slid is as near as where it stands in the box`() {
        val boundary = LeesEdwards(box, 0.7)
        // The sphere at (−2, 6.7) sticks out at the right; its image at the left stands at x = −2 − 7, which is 1 in
        // the box.
        val time = 7 / (0.7 * 14)
        val population = Population(
            doubleArrayOf(-2.0, 1.0, -5.0, 4.9),
            doubleArrayOf(6.7, 0.0, 1.0, 2.0),
            DoubleArray(4),
            DoubleArray(4),
            DoubleArray(4),
            DoubleArray(4),
            DoubleArray(4) { 0.5 },
            DoubleArray(4) { 1.0 },
        )
        PatchPicture(State(population, boundary, time), "m").writeSide(home, "side")
        val circles = circles("side", 1.0)
        assertEquals(5, circles.size)
        val image = circles.first { it.first < 0 }
        assertEquals(-0.3, image.first, 1e-6)
        assertEquals(circles.first { Math.abs(it.first - 7) < 0.01 }.third, image.third)
    }
}
