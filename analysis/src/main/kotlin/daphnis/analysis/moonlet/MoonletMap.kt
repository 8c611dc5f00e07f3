package daphnis.analysis.moonlet

import daphnis.analysis.insitu.State
import daphnis.core.boundary.prepare
import daphnis.core.space.Images
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The surface density of the ring around a body, averaged over states in axes that move with it: entry `i · ny + j` of
 * [excess] for the cell i along x, j along y. Of each particle the nearest image counts, so the map is as large as the
 * box. Bodies are left out.
 *
 * A body whose gravity clears part of the ring leaves two gaps, one on each side of its orbit, where the shear carries
 * away what it has scattered: a propeller (Spahn & Sremčević 2000, A&A 358, 368; Seiß, Spahn, Sremčević & Salo 2005,
 * GRL 32, L11205).
 *
 * @param body id
 * @property nx cells along x, [ny] along y; both odd, so that the body is in the middle of a cell
 * @property width of the map along x, [length] along y
 */
public class MoonletMap(
    private val body: Int,
    public val nx: Int,
    public val ny: Int,
    public val width: Double,
    public val length: Double,
) {
    private val images = Images()

    // Mass in each cell, by group of states.
    private val groups = ArrayList<DoubleArray>()

    /** States taken in. */
    public val states: Int get() = groups.size

    init {
        require(nx % 2 == 1 && ny % 2 == 1 && nx > 0 && ny > 0) { "$nx x $ny cells; both numbers must be odd" }
        require(width > 0 && length > 0) { "the map is $width x $length; both must be > 0" }
    }

    /** Middle of cell [i] along x, from the body. */
    public fun x(i: Int): Double = (i - nx / 2) * width / nx

    /** Middle of cell [j] along y. */
    public fun y(j: Int): Double = (j - ny / 2) * length / ny

    /** Takes in one more state; one without the body is left out. */
    public fun add(state: State) {
        val p = state.population
        val at = p.indexOf(body)
        if (at < 0) return
        images.prepare(state.boundary, state.time)
        val mass = DoubleArray(nx * ny)
        val d = DoubleArray(3)
        for (k in 0 until p.size) {
            if (!state.isParticle(k)) continue
            d[0] = p.x[k] - p.x[at]
            d[1] = p.y[k] - p.y[at]
            d[2] = 0.0
            images.toNearest(d)
            val i = Math.floor(d[0] / width * nx + nx * 0.5).toInt()
            val j = Math.floor(d[1] / length * ny + ny * 0.5).toInt()
            if (i in 0 until nx && j in 0 until ny) mass[i * ny + j] += p.mass[k]
        }
        groups += mass
    }

    /** Surface density over its mean, less 1; NaN of no states. */
    public fun excess(): DoubleArray = excess(groups)

    private fun excess(of: List<DoubleArray>): DoubleArray {
        val sum = DoubleArray(nx * ny) { k -> of.sumOf { it[k] } }
        val mean = sum.sum() / sum.size
        return DoubleArray(sum.size) { sum[it] / mean - 1 }
    }

    /**
     * Excess along x where the shear carries away what passed the body, averaged over distances from [near] to [far]
     * along y: behind it outside its orbit, ahead of it inside. 0 where there is no cell.
     */
    public fun wake(near: Double, far: Double): DoubleArray = wake(excess(), near, far)

    private fun wake(excess: DoubleArray, near: Double, far: Double) = DoubleArray(nx) { i ->
        val side = if (i > nx / 2) -1 else 1
        val cells = (0 until ny).filter { y(it) * side in near..far }
        if (cells.isEmpty()) 0.0 else cells.sumOf { excess[i * ny + it] } / cells.size
    }

    /**
     * The two gaps of a propeller in [wake], each between the body's orbit and [reach]: the mean distance
     * of its cells weighted by the third power of what is missing there, which leaves out the noise of the others
     * without an edge. Null where on one side less than a tenth of the ring is missing in every cell. What lies between
     * them tells a propeller from a lane ([Propeller.isLane]): the cells within an eighth of their distance from the
     * body's orbit, beside those within as much of each centre.
     *
     * The error is that of the jackknife over up to [BLOCKS] blocks of consecutive states; NaN for fewer than four.
     */
    public fun gaps(near: Double, far: Double, reach: Double): Propeller? {
        if (groups.isEmpty()) return null
        val wake = wake(excess(), near, far)
        val whole = gaps(wake, reach) ?: return null
        val blocks = minOf(BLOCKS, groups.size)
        val without = if (blocks < FEWEST) {
            emptyList()
        } else {
            List(blocks) { b ->
                wake(excess(groups.filterIndexed { k, _ -> k * blocks / groups.size != b }), near, far)
            }
        }
        val found = without.mapNotNull { gaps(it, reach) }
        val errors = List(2) { which -> if (found.size < blocks) Double.NaN else jackknife(found.map { it[which] }) }
        val isLane = listOf(-1, 1).any { side ->
            val error = if (without.isEmpty()) 0.0 else jackknife(without.map { rise(it, whole[0], side) })
            !(rise(wake, whole[0], side) > error)
        }
        return Propeller(whole[0], errors[0], whole[1], errors[1], isLane)
    }

    /** Standard error of what has these [values] without each block. */
    private fun jackknife(values: List<Double>): Double {
        val mean = values.average()
        return sqrt((values.size - 1.0) / values.size * values.sumOf { (it - mean) * (it - mean) })
    }

    /** By how much [wake] is larger near the body's orbit than in the gap at one [side], half of [separation] away. */
    private fun rise(wake: DoubleArray, separation: Double, side: Int): Double {
        fun around(place: Double): Double {
            // Of the cell in the middle half lies upstream.
            val cells = (0 until nx).filter { it != nx / 2 }
            val reach = maxOf(separation / 8, cells.minOf { abs(x(it) - place) })
            return cells.filter { abs(x(it) - place) <= reach }.map { wake[it] }.average()
        }
        return around(0.0) - around(side * separation / 2)
    }

    /** Distance of the two gaps, and their mean depth. */
    private fun gaps(wake: DoubleArray, reach: Double): DoubleArray? {
        var distance = 0.0
        var depth = 0.0
        for (side in listOf(-1, 1)) {
            val cells = (0 until nx).filter { x(it) * side > 0 && abs(x(it)) <= reach && wake[it] < 0 }
            if (cells.none { wake[it] < -LEAST }) return null
            val sum = cells.sumOf { cube(wake[it]) }
            distance += cells.sumOf { cube(wake[it]) * abs(x(it)) } / sum
            depth -= cells.sumOf { cube(wake[it]) * wake[it] } / sum / 2
        }
        return doubleArrayOf(distance, depth)
    }

    private fun cube(x: Double) = x * x * x

    private companion object {
        const val LEAST = 0.1
        const val BLOCKS = 16
        const val FEWEST = 4
    }
}

/**
 * The two gaps of a propeller.
 *
 * @property separation radial distance between their centres, length
 * @property separationError one standard error; NaN when not known
 * @property depth part of the surface density that is missing in them, weighted as the centres are
 * @property depthError likewise
 * @property isLane whether they are one trough around the body's orbit: the surface density between them does not stand
 *   above that in both of them by more than the error of the difference
 */
public class Propeller internal constructor(
    public val separation: Double,
    public val separationError: Double,
    public val depth: Double,
    public val depthError: Double,
    public val isLane: Boolean,
)
