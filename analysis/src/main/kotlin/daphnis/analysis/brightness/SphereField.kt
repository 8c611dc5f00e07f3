package daphnis.analysis.brightness

import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * The spheres of [state] in cells of one box, which the images that reach into it are in too, so that a ray that leaves
 * through a face goes on at the place where it enters the next box. Axes are those of [PlaneImages]: a from row to row
 * of images, b along a row, and z, along which there are none.
 *
 * ```
 *   b ▲  ┌───┬───┬───┐
 *     │  │  ●│   │   ◗   in the last column, and as an image in the first, displaced by the slide of the rows
 *     │  ├───┼───┼───┤
 *     │  ◗   │   │●  │
 *     │  └───┴───┴───┘
 *     └──────────────▶ a
 * ```
 */
internal class SphereField(state: State) {
    private val population = state.population
    private val images = PlaneImages(state.boundary, state.time)
    private val box = state.boundary.box
    private val placeA = population.position(images.across)
    private val placeB = population.position(images.along)

    /** 0 or 1, the axis a; [along] the axis b. */
    val across = images.across
    val along = images.along

    /** By which the next row of images, that at larger a, is displaced along b. */
    val offset = images.offset

    /** Whether there are images along a, b and z. */
    val repeats = booleanArrayOf(images.repeats(across), images.repeats(along), false)

    /** Where the cells begin; [high] where they end. */
    val low = DoubleArray(AXES)
    val high = DoubleArray(AXES)

    /** Numbers and widths of cells. */
    val count = IntArray(AXES)
    val width = DoubleArray(AXES)

    // Spheres and images that reach into the box, and of which sphere each is one.
    private var size = 0
    var centreA = DoubleArray(population.size)
        private set
    var centreB = DoubleArray(population.size)
        private set
    var owner = IntArray(population.size)
        private set

    /** Where each cell's part of [entries] begins; indices of spheres and images. */
    val start: IntArray
    val entries: IntArray

    init {
        for (axis in 0 until AXES) extent(axis)
        for (k in 0 until population.size) add(k)
        divide()
        val cells = count[0] * count[1] * count[2]
        start = IntArray(cells + 1)
        for (k in 0 until size) forEachCell(k) { start[it + 1]++ }
        for (cell in 0 until cells) start[cell + 1] = Math.addExact(start[cell], start[cell + 1])
        entries = IntArray(start[cells])
        val next = start.copyOf(cells)
        for (k in 0 until size) forEachCell(k) { entries[next[it]++] = k }
    }

    /** Height and radius of the sphere or image [k]. */
    fun z(k: Int) = population.z[owner[k]]

    fun radius(k: Int) = population.radius[owner[k]]

    private fun extent(axis: Int) {
        if (repeats[axis]) {
            low[axis] = box.lower(if (axis == 0) across else along)
            high[axis] = box.upper(if (axis == 0) across else along)
            return
        }
        val place = if (axis == 0) {
            placeA
        } else if (axis == 1) {
            placeB
        } else {
            population.z
        }
        low[axis] = Double.POSITIVE_INFINITY
        high[axis] = Double.NEGATIVE_INFINITY
        for (k in 0 until population.size) {
            low[axis] = minOf(low[axis], place[k] - population.radius[k])
            high[axis] = maxOf(high[axis], place[k] + population.radius[k])
        }
        if (population.size == 0) {
            low[axis] = 0.0
            high[axis] = 0.0
        }
    }

    /** Adds those of the sphere [k] and its images that reach into the box. */
    private fun add(k: Int) {
        val r = population.radius[k]
        for (row in reaching(0, placeA[k], r)) {
            val b = placeB[k] + row * offset
            for (place in reaching(1, b, r)) {
                if (size == owner.size) grow()
                owner[size] = k
                centreA[size] = placeA[k] + row * (high[0] - low[0])
                centreB[size] = b + place * (high[1] - low[1])
                size++
            }
        }
    }

    /** By how many edges along [axis] something at [place] may be displaced to come within [r] of the box. */
    private fun reaching(axis: Int, place: Double, r: Double): IntRange {
        if (!repeats[axis]) return 0..0
        val edge = high[axis] - low[axis]
        return ceil((low[axis] - r - place) / edge).toInt()..floor((high[axis] + r - place) / edge).toInt()
    }

    private fun grow() {
        val more = size + size / 2 + 16
        centreA = centreA.copyOf(more)
        centreB = centreB.copyOf(more)
        owner = owner.copyOf(more)
    }

    /** About one sphere in a cell, and cells no smaller than a mean radius. */
    private fun divide() {
        val n = maxOf(1, population.size)
        var mean = 0.0
        for (k in 0 until population.size) mean += population.radius[k] / n
        val (a, b, z) = DoubleArray(AXES) { high[it] - low[it] }.toList()
        val thin = z / maxOf(mean, StrictMath.cbrt(a * b * z / n))
        val layers = if (thin >= 1) floor(thin) else 1.0
        val edge = maxOf(mean, sqrt(a * b * layers / n))
        for (axis in 0..1) {
            count[axis] = if (edge > 0) ((high[axis] - low[axis]) / edge).coerceIn(1.0, MOST).toInt() else 1
        }
        count[2] = layers.coerceAtMost(MOST).toInt()
        for (axis in 0 until AXES) width[axis] = (high[axis] - low[axis]) / count[axis]
    }

    /** The cell along [axis] at [place], of those at the ends beyond them. */
    fun cell(axis: Int, place: Double): Int {
        val cell = floor((place - low[axis]) / width[axis])
        return if (cell >= count[axis]) {
            count[axis] - 1
        } else if (cell > 0) {
            cell.toInt()
        } else {
            0
        }
    }

    private inline fun forEachCell(k: Int, use: (cell: Int) -> Unit) {
        val r = radius(k) * (1 + MARGIN)
        for (a in cell(0, centreA[k] - r)..cell(0, centreA[k] + r)) {
            for (b in cell(1, centreB[k] - r)..cell(1, centreB[k] + r)) {
                for (z in cell(2, z(k) - r)..cell(2, z(k) + r)) {
                    val da = beyond(0, a, centreA[k])
                    val db = beyond(1, b, centreB[k])
                    val dz = beyond(2, z, z(k))
                    if (da * da + db * db + dz * dz <= r * r) use((a * count[1] + b) * count[2] + z)
                }
            }
        }
    }

    /** How far [cell] along [axis] is from [place]; those at the ends go on. */
    private fun beyond(axis: Int, cell: Int, place: Double): Double {
        val from = low[axis] + cell * width[axis]
        val to = from + width[axis]
        return if (place < from) {
            from - place
        } else if (place > to) {
            place - to
        } else {
            0.0
        }
    }

    companion object {
        const val AXES = 3

        /** Cells along an axis, at most. */
        private const val MOST = 1000.0

        /** Part of a radius by which spheres are taken into further cells, for the rounding of rays. */
        private const val MARGIN = 1e-6
    }
}
