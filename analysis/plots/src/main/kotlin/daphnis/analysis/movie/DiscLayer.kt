package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import kotlin.math.floor

/**
 * The discs of a frame, from the farthest to the nearest. A sphere that sticks out of a periodic face is cut there and
 * goes on at the other, where its image is at the time: one beyond a face along which images slide has slid.
 */
internal class DiscLayer(private val scene: Scene, private val raster: DiscRaster) {
    private val view = scene.view
    private val window = view.window
    private val right = scene.sight.across
    private val up = scene.sight.up
    private val along = scene.sight.depth
    private val nearer = scene.sight.nearer
    private var count = 0
    private var x = DoubleArray(FIRST)
    private var y = DoubleArray(FIRST)
    private var index = IntArray(FIRST)
    private var order = LongArray(FIRST)

    /**
     * Draws the spheres of [state], in its [box], that [isShown], each in the colour that [rgb] gives for its index and
     * pixel.
     */
    fun draw(state: State, box: PictureBox, isShown: (Int) -> Boolean, rgb: (Int, Double, Double) -> Int) {
        count = 0
        gather(state, box, isShown)
        order.sort(0, count)
        val p = state.population
        for (n in 0 until count) {
            val entry = order[n].toInt()
            val k = index[entry]
            val least = if (state.isParticle(k)) 0.0 else LEAST_BODY
            val across = maxOf(p.radius[k] * view.scaleX, least)
            val above = maxOf(p.radius[k] * view.scaleY, least)
            raster.draw(box, x[entry], y[entry], across, above, rgb(k, x[entry], y[entry]))
        }
    }

    private fun gather(state: State, box: PictureBox, isShown: (Int) -> Boolean) {
        val p = state.population
        for (k in 0 until p.size) {
            if (!isShown(k)) continue
            val r = p.radius[k]
            if (box.isNear(k, r)) {
                addImages(state, box, k)
            } else {
                add(k, r, p.position(right)[k], p.position(up)[k], p.position(along)[k])
            }
        }
    }

    private fun addImages(state: State, box: PictureBox, k: Int) {
        val p = state.population
        for (code in box.codes) {
            var depth = p.position(along)[k] + box.shift(code, along)
            // An image beyond a face may have slid out of the box along the line of sight.
            val period = box.period(along)
            if (period > 0) depth -= floor((depth - state.boundary.box.lower(along)) / period) * period
            val x = p.position(right)[k] + box.shift(code, right)
            add(k, p.radius[k], x, p.position(up)[k] + box.shift(code, up), depth)
        }
    }

    private fun add(k: Int, r: Double, across: Double, above: Double, depth: Double) {
        if (across + r < window.left || across - r > window.right) return
        if (above + r < window.bottom || above - r > window.top) return
        if (count == x.size) grow()
        x[count] = view.x(across)
        y[count] = view.y(above)
        index[count] = k
        // Sorts as the depths do: the bits of a float ascend with it, once those of negative ones are turned around.
        val bits = (nearer * depth).toFloat().toRawBits()
        order[count] = (bits xor (bits shr 31 and Int.MAX_VALUE)).toLong() shl 32 or count.toLong()
        count++
    }

    private fun grow() {
        y = y.copyOf(2 * count)
        index = index.copyOf(2 * count)
        order = order.copyOf(2 * count)
        // Last, since its length says how many there is room for: an allocation before it may have failed.
        x = x.copyOf(2 * count)
    }

    private companion object {
        const val FIRST = 1024

        /** Radius in pixels: a body is not overlooked. */
        const val LEAST_BODY = 1.5
    }
}
