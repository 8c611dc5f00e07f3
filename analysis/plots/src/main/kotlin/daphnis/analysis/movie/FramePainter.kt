package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.WallCut
import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import kotlin.math.pow

/** Paints frames of one [scene], each into the same picture. One thread. */
internal class FramePainter(private val scene: Scene, private val legend: Legend) {
    private val view = scene.view
    private val options = scene.options
    val image = BufferedImage(view.width, view.height + legend.height, BufferedImage.TYPE_INT_RGB)
    private val pixels = (image.raster.dataBuffer as DataBufferInt).data
    private val raster = DiscRaster(pixels, view)
    private val discs = DiscLayer(scene, raster)
    private val grid = if (scene.isImage || options.colour == MovieColour.DENSITY) {
        SurfaceGrid(view, scene.cell)
    } else {
        null
    }

    // Discs in the thinnest places are to be seen too.
    private val map =
        if (scene.isImage && options.colour == MovieColour.DENSITY) ColourMap.DENSITY else ColourMap.QUANTITY

    /** Paints [state]; the picture is valid until the next call. */
    fun paint(state: State, clock: String): BufferedImage {
        pixels.fill(ColourMap.SPACE)
        val box = PictureBox(state, view, scene.sight)
        grid?.let { weigh(state, box, it) }
        walls(state)
        if (scene.isImage) ground(box, grid!!)
        val radius = state.population.radius
        discs.draw(state, box, { !state.isParticle(it) || !scene.isImage || scene.isDisc(radius[it]) }) { k, x, y ->
            if (state.isParticle(k)) colourOf(state, k, x, y) else ColourMap.BODY
        }
        legend.paint(image, clock, map)
        return image
    }

    private fun walls(state: State) {
        val cut = WallCut(state, scene.sight.across, scene.sight.up)
        if (cut.isEmpty) return
        for (row in 0 until view.height) {
            val above = view.window.top - (row + 0.5) / view.scaleY
            for (column in view.firstColumn until view.endColumn) {
                val right = view.window.left + (column - view.firstColumn + 0.5) / view.scaleX
                if (cut.isBehind(right, above)) pixels[row * view.width + column] = ColourMap.WALL
            }
        }
    }

    private fun colourOf(state: State, k: Int, x: Double, y: Double): Int {
        if (options.colour != MovieColour.DENSITY) {
            return map.rgb(scene.colours.place(state.quantity(options.colour, k)))
        }
        val density = grid!!.density(grid.cellAt(x.toInt(), y.toInt()))
        return map.rgb(scene.colours.place(density))
    }

    /** With what is beyond the faces of a box that is narrower than the window, so that it has no thin borders. */
    private fun weigh(state: State, box: PictureBox, grid: SurfaceGrid) {
        grid.clear()
        val beyond = scene.cell * (scene.passes + 1) / minOf(view.scaleX, view.scaleY)
        val p = state.population
        val window = view.window
        val across = p.position(scene.sight.across)
        val above = p.position(scene.sight.up)
        for (k in 0 until p.size) {
            if (!state.isParticle(k) || scene.isImage && scene.isDisc(p.radius[k])) continue
            for (code in if (box.isPart && box.isNear(k, beyond)) box.codes else ITSELF) {
                val x = across[k] + box.shift(code, scene.sight.across)
                val y = above[k] + box.shift(code, scene.sight.up)
                if (x !in window.left..window.right || y !in window.bottom..window.top) continue
                grid.add(view.x(x), view.y(y), p.mass[k], state.quantity(options.colour, k))
            }
        }
        grid.smooth(scene.passes)
    }

    /** The surface density as brightness; the colour is that of the mean sphere there. */
    private fun ground(box: PictureBox, grid: SurfaceGrid) {
        for (row in box.firstRow until box.endRow) {
            for (column in box.firstColumn until box.endColumn) {
                val k = grid.cellAt(column, row)
                val density = grid.density(k)
                if (density <= 0) continue
                pixels[row * view.width + column] = if (options.colour == MovieColour.DENSITY) {
                    map.rgb(scene.colours.place(density))
                } else {
                    val colour = map.rgb(scene.colours.place(grid.mean(k)))
                    ColourMap.mixed(ColourMap.SPACE, colour, (density / scene.bright).coerceAtMost(1.0).pow(GAMMA))
                }
            }
        }
    }

    private companion object {
        /** Faint parts are lifted, as film does. */
        const val GAMMA = 0.6
        val ITSELF = intArrayOf(0)
    }
}
