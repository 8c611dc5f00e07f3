package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import daphnis.analysis.table.UnitNames
import daphnis.analysis.uniform
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.boundary.at
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.wall.CylinderWall
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.awt.image.BufferedImage
import kotlin.math.abs

/** Frames of 400 pixels of a box 10 long each way: 40 pixels per length. */
class FramePainterTest {
    private val box = Box.centred(10.0, 10.0, 10.0)

    private fun paint(
        state: State,
        view: MovieView = MovieView.TOP,
        colour: MovieColour = MovieColour.SIZE,
        look: (Scene) -> Unit = {},
    ): BufferedImage {
        val survey = Survey(MovieOptions(view, colour, width = 400))
        survey.look(state)
        survey.weigh(state)
        val scene = survey.scene(UnitNames(null), null).also(look)
        return FramePainter(scene, Legend(scene)).paint(state, "t = 0")
    }

    private fun state(boundary: BoundaryConditions, vararg spheres: Sphere, time: Double = 0.0) =
        State(populationOf(*spheres), boundary, time)

    /** Whether something stands at ([across], [up]). */
    private fun BufferedImage.shows(across: Double, up: Double): Boolean =
        getRGB(((across + 5) * 40).toInt(), ((5 - up) * 40).toInt()) and 0xffffff != ColourMap.SPACE

    @Test
    fun `what is thin along y has x to the right`() {
        val thin = Box.centred(40.0, 8.0, 8.0)
        val state = state(Periodic(thin), Sphere(15.0, 1.0, -2.0, r = 0.5))
        for ((view, up) in listOf(MovieView.TOP to 1.0, MovieView.SIDE to -2.0)) {
            val image = paint(state, view)

            // 10 pixels per length; the window is as high as the box.
            fun shows(x: Double, y: Double) =
                image.getRGB(((x + 20) * 10).toInt(), ((4 - y) * 10).toInt()) and 0xffffff != ColourMap.SPACE
            assertTrue(shows(15.0, up) && shows(15.4, up) && !shows(14.0, up) && !shows(-15.0, up)) { "$view" }
        }
        // Of two behind one another along y the one with the smaller y is in front.
        val two = state(Periodic(thin), Sphere(0.0, -1.0, 0.0, r = 0.4), Sphere(0.0, 1.0, 0.0, r = 0.5))
        val front = paint(two, MovieView.SIDE).getRGB(200, 40) and 0xffffff
        val other = state(Periodic(thin), Sphere(0.0, 1.0, 0.0, r = 0.5), Sphere(9.0, 0.0, 0.0, r = 0.4))
        val alone = paint(other, MovieView.SIDE)
        assertTrue(front != alone.getRGB(200, 40) and 0xffffff)
    }

    @Test
    fun `what is behind a wall is grey, as it is in the middle of the box`() {
        val along = listOf(1.0, 0.0, 0.0)
        val drum = Walls(box, surfaces = listOf(CylinderWall(List(3) { 0.0 }, along, 4.0)))
        val state = state(drum, Sphere(0.0, -3.0, 0.0, r = 0.5))
        fun BufferedImage.isWall(across: Double, up: Double) =
            getRGB(((across + 5) * 40).toInt(), ((5 - up) * 40).toInt()) and 0xffffff == ColourMap.WALL
        val side = paint(state, MovieView.SIDE)
        for ((y, z) in listOf(4.1 to 0.0, -4.1 to 0.0, 0.0 to 4.1, 3.0 to -3.0)) {
            assertTrue(side.isWall(y, z)) {
                "$y $z"
            }
        }
        for ((y, z) in listOf(3.9 to 0.0, 0.0 to -3.9, 2.7 to 2.7, -3.0 to 0.0)) assertTrue(!side.isWall(y, z))
        assertTrue(side.shows(-3.0, 0.0))
        // The middle of the drum from above: it ends at y = ±4 for every x.
        val top = paint(state, MovieView.TOP)
        assertTrue(top.isWall(4.1, 4.5) && top.isWall(-4.1, -4.5) && !top.isWall(3.9, 4.5))
    }

    @Test
    fun `a sphere is a disc at its place and to scale, from above and from the side`() {
        val state = state(Periodic(box), Sphere(2.0, -3.0, 1.0, r = 0.5))
        for ((view, up) in listOf(MovieView.TOP to 2.0, MovieView.SIDE to 1.0)) {
            val image = paint(state, view)
            assertEquals(400, image.width)
            for ((dx, dy) in listOf(0.0 to 0.0, 0.45 to 0.0, -0.45 to 0.0, 0.0 to 0.45, 0.3 to -0.3)) {
                assertTrue(image.shows(-3 + dx, up + dy)) { "$view $dx $dy" }
            }
            for ((dx, dy) in listOf(0.6 to 0.0, -0.6 to 0.0, 0.0 to 0.6, 0.0 to -0.6, 0.42 to 0.42)) {
                assertTrue(!image.shows(-3 + dx, up + dy)) { "$view $dx $dy" }
            }
        }
    }

    @Test
    fun `what spins faster has the colour of more, whichever way round`() {
        // The fastest of few is beyond the range, as a rare one is.
        val three = populationOf(Sphere(2.0, -3.0, r = 0.5), Sphere(-2.0, 3.0, r = 0.5), Sphere(4.0, 4.0, r = 0.5))
        val spun = three.withSpin(
            doubleArrayOf(0.0, 0.0, 9.0),
            doubleArrayOf(-3.0, 0.5, 0.0),
            doubleArrayOf(4.0, 0.0, 0.0),
        )
        var range: ColourRange? = null
        val image = paint(State(spun, Periodic(box), 0.0), colour = MovieColour.SPIN) { range = it.colours }
        assertEquals(0.0, range!!.low)
        assertEquals(0.5, State(spun, Periodic(box), 0.0).quantity(MovieColour.SPIN, 1))
        assertEquals(5.0, State(spun, Periodic(box), 0.0).quantity(MovieColour.SPIN, 0))
        assertTrue(image.shows(-3.0, 2.0) && image.shows(3.0, -2.0))
        assertTrue(image.getRGB(80, 120) != image.getRGB(320, 280))
    }

    @Test
    fun `materials that are shown have a swatch and a name, and what only a body is made of has none`() {
        val spheres = populationOf(Sphere(2.0, -3.0, r = 0.5), Sphere(-2.0, 3.0, r = 0.5), Sphere(4.0, 0.0, r = 0.5))
        val names = listOf("unused", "ice", "rock", "moon")
        val state = State(spheres.withMaterial(intArrayOf(1, 2, 3), names), Periodic(box), 0.0, firstBody = 2)
        val image = paint(state, colour = MovieColour.MATERIAL) {
            assertEquals(mapOf(1 to "ice", 2 to "rock"), it.materials)
        }
        // Discs are shaded: that of the body has the hue of none of the two.
        assertTrue(listOf(80 to 120, 320 to 280, 200 to 40).map { (x, y) -> image.getRGB(x, y) }.toSet().size == 3)
        val map = ColourMap.QUANTITY
        val below = (400 until image.height).flatMap { y -> (0 until 400).map { image.getRGB(it, y) and 0xffffff } }
        // Squares of the font's size of 11 times 0.8, and no colour in between.
        assertEquals(listOf(81, 81), listOf(map.rgb(0.0), map.rgb(1.0)).map { colour -> below.count { it == colour } })
        assertTrue(below.none { it == map.rgb(0.5) || it == map.rgb(0.25) })
    }

    @Test
    fun `names that have no room are cut, and all swatches stay in the picture`() {
        val names = List(12) { "a-material-with-a-long-name-$it" }
        val spheres = Array(12) { Sphere(0.0, -4.4 + 0.8 * it, r = 0.35) }
        val state = State(populationOf(*spheres).withMaterial(IntArray(12) { it }, names), Periodic(box), 0.0)
        val image = paint(state, colour = MovieColour.MATERIAL)
        for (k in 0 until 12) {
            val colour = ColourMap.QUANTITY.rgb(k / 11.0)
            val rows = 400 until image.height
            val count = rows.sumOf { y -> (0 until 400).count { image.getRGB(it, y) and 0xffffff == colour } }
            assertEquals(81, count) { "material $k" }
        }
    }

    @Test
    fun `beyond a face the image goes on, where the shear has brought it`() {
        val sphere = Sphere(1.0, 4.9, 0.0, r = 0.4)
        assertTrue(paint(state(Periodic(box), sphere)).shows(-4.9, 1.0))
        // Rate 0.7 over the edge of 10 for a time of 0.3: the image below has slid by −2.1 along x.
        val sheared = paint(state(LeesEdwards(box, 0.7), sphere, time = 0.3))
        assertTrue(sheared.shows(4.9, 1.0))
        assertTrue(!sheared.shows(-4.9, 1.0))
        assertTrue(sheared.shows(-4.9, -1.1))
    }

    /** The earlier state of two, of a sheet that is 5 wide in the first and 15 in the second, which the window is of. */
    private fun breathing(colour: MovieColour, make: (BoundaryConditions) -> Population): BufferedImage {
        val sheet = HillSheet(box, 1.0, perturbation = 0.5)
        val survey = Survey(MovieOptions(MovieView.TOP, colour, width = 400))
        val states = listOf(0.0, Math.PI).map { State(make(sheet.at(it)), sheet, it) }
        for (s in states) survey.look(s)
        for (s in states) survey.weigh(s)
        val scene = survey.scene(UnitNames(null), null)
        return FramePainter(scene, Legend(scene)).paint(states[0], "t = 0")
    }

    @Test
    fun `a box that is narrower than the window is cut at its own faces`() {
        // At time 0 images have not slid; the picture is 400 pixels high for a length of 15.
        for (colour in listOf(MovieColour.SIZE, MovieColour.DENSITY)) {
            val image = breathing(colour) { populationOf(Sphere(2.4, 0.0, 0.0, r = 0.4)) }
            fun shows(up: Double) = image.getRGB(200, ((7.5 - up) * 400 / 15).toInt()) and 0xffffff != ColourMap.SPACE
            val seen = listOf(7.4, 2.6, 2.45, 2.1, 0.0, -2.45, -2.7, -3.0).map { it to shows(it) }
            assertTrue(shows(2.1) && shows(2.45) && shows(-2.45)) { "$colour $seen" }
            assertTrue(!shows(2.6) && !shows(-2.7) && !shows(-3.0) && !shows(7.4))
        }
    }

    @Test
    fun `the faces of a box that is narrower than the window are no thinner than the rest`() {
        for (radius in listOf(0.0025, 0.1)) {
            val image = breathing(MovieColour.DENSITY) { uniform(40_000, it, radius = radius).population }
            fun mean(rows: IntRange): Double {
                var sum = 0.0
                for (y in rows) for (x in 100 until 300) sum += image.getRGB(x, y) shr 8 and 0xff
                return sum / (rows.count() * 200)
            }
            // The box has rows 133 to 267.
            val inside = mean(180..220)
            for (face in listOf(mean(134..137), mean(262..265))) {
                assertEquals(inside, face, (if (radius < 0.01) 0.15 else 0.1) * inside) { "$radius" }
            }
            assertEquals(ColourMap.SPACE, image.getRGB(200, 130) and 0xffffff)
        }
    }

    @Test
    fun `the nearer sphere hides the other, whatever their order`() {
        val large = Sphere(0.0, 0.0, 2.0, r = 1.0)
        val small = Sphere(0.0, 0.0, -1.0, r = 0.5)
        val near = paint(state(Periodic(box), small, large)).getRGB(200, 200)
        assertEquals(near, paint(state(Periodic(box), large, small)).getRGB(200, 200))
        val below = Sphere(0.0, 0.0, -2.0, r = 1.0)
        val other = paint(state(Periodic(box), below, small)).getRGB(200, 200)
        assertTrue(near != other)
    }

    @Test
    fun `from the side the lower edge of the view from above is nearest, as in the pictures of a report`() {
        val inner = Sphere(-2.0, 0.0, 0.0, r = 1.0)
        val outer = Sphere(2.0, 0.0, 0.0, r = 0.5)
        val both = paint(state(Periodic(box), outer, inner), MovieView.SIDE, MovieColour.SIZE).getRGB(200, 200)
        val ground = Sphere(2.0, -4.0, 0.0, r = 0.5)
        assertEquals(
            paint(state(Periodic(box), ground, inner), MovieView.SIDE, MovieColour.SIZE).getRGB(200, 200),
            both,
        )
    }

    @Test
    fun `spheres below two pixels make an image as bright as their surface density`() {
        // 40,000 of 0.1 pixels, three times as many on the right: 400 particles a cell of 20 by 20 pixels on the right.
        val all = uniform(40_000, Periodic(box), radius = 0.0025)
        val p = all.population
        for (k in 0 until p.size) p.y[k] = if (k % 4 == 0) -abs(p.y[k]) else abs(p.y[k])
        fun mean(image: BufferedImage, columns: IntRange): Double {
            var sum = 0.0
            for (x in columns) for (y in 20 until 380) sum += image.getRGB(x, y) shr 8 and 0xff
            return sum / (columns.count() * 360)
        }
        for (colour in listOf(MovieColour.SIZE, MovieColour.DENSITY)) {
            val image = paint(all, colour = colour) { assertTrue(it.isImage) }
            val left = mean(image, 20..180)
            val right = mean(image, 220..380)
            assertTrue(right > 1.25 * left) { "$colour: $left $right" }
        }
    }

    @Test
    fun `the words of the legend end before the bar that tells lengths, which ends before the colours`() {
        // So flat that its vertical is enlarged two hundred times, which the legend says.
        val flat = Periodic(Box.centred(100.0, 10_000.0, 10.0))
        val state = state(flat, Sphere(0.0, 0.0, 1.0, r = 1.0), Sphere(3.0, 10.0, -1.0, r = 2.0))
        for (width in listOf(240, 320, 400, 439, 440, 600, 800, 1200, 2400)) {
            val survey = Survey(MovieOptions(MovieView.SIDE, MovieColour.SIZE, width = width))
            survey.look(state)
            survey.weigh(state)
            val scene = survey.scene(UnitNames(null), null)
            val legend = Legend(scene)
            assertTrue(legend.remark!!.startsWith("vertical × ")) { "${legend.remark}" }
            val image = FramePainter(scene, legend).paint(state, "0")
            // White pixels beside each other that no letter has.
            val least = maxOf(8, width / 60)
            val strip = image.height - legend.height until image.height
            val grey = (0 until width).filter { x -> strip.any { image.getRGB(x, it) and 0xffffff == 0xb8bcc4 } }
            fun isBar(x: Int) = strip.any { y ->
                x + least < width && (x..x + least).all { image.getRGB(it, y) and 0xffffff == 0xffffff }
            }
            val bar = (0 until width).filter { isBar(it) }
            assertTrue(grey.isNotEmpty() && bar.isNotEmpty() && grey.max() < bar.min()) {
                "$width: ${grey.maxOrNull()}, $bar"
            }
            assertTrue(bar.max() + least < if (width < 440) width else width / 2) { "$width: $bar" }
        }
    }

    @Test
    fun `the grid keeps mass, also at the border and smoothed`() {
        val view = Viewport(Window(0.0, 10.0, 0.0, 5.0), 400)
        for (cell in listOf(1, 3)) {
            val grid = SurfaceGrid(view, cell)
            for ((x, y) in listOf(0.0 to 0.0, 400.0 to 200.0, 123.4 to 56.7)) grid.add(x, y, 2.0, 3.0)
            grid.smooth(2)
            var sum = 0.0
            for (k in 0 until grid.columns * grid.rows) sum += grid.density(k)
            assertEquals(6.0, sum * cell * cell * view.pixelArea, 1e-12)
            assertEquals(3.0, grid.mean(grid.cellAt(123, 56)), 1e-12)
        }
    }

    @Test
    fun `in open space all but the outermost are in view`() {
        val cloud = Array(4000) { k -> Sphere(k % 20 * 0.1, k / 20 % 20 * 0.1, k / 400 * 0.1, r = 0.05) }
        val lost = Sphere(1e6, -1e6, 0.0, r = 0.05)
        paint(state(Open, *cloud, lost)) { scene ->
            assertTrue(scene.view.window.across in 1.9..2.2 && scene.view.window.up in 1.9..2.2)
        }
    }
}
