package daphnis.analysis.plot

import daphnis.analysis.insitu.State
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Images
import daphnis.core.boundary.LeesEdwards
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

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
