package daphnis.core.initial

import daphnis.core.boundary.Box
import java.util.Locale
import kotlin.math.ceil
import kotlin.math.sqrt

/**
 * A lattice stretched to fit the box, with as many cells along each axis as leave the spheres farthest apart. Sites
 * that are left empty beyond [vacancies], if there are more than needed, are spread evenly. Face-centred cubic reaches
 * a filling factor of 0.6 and more in boxes that take whole cells. In a flat box the lattice is hexagonal or square.
 *
 * @param vacancies share of the sites that stay empty, in [0, 1); which ones is drawn
 */
public class LatticePlacement @JvmOverloads constructor(
    private val lattice: Lattice = Lattice.FACE_CENTRED_CUBIC,
    private val vacancies: Double = 0.0,
) : Placement {
    init {
        require(vacancies >= 0 && vacancies < 1) { "the share of vacancies is $vacancies; it must be in [0, 1)" }
    }

    override fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions {
        require(lattice.isPlane == box.space.isPlane) { "lattice $lattice does not fit into a box of ${box.space}" }
        val n = radii.size
        val largest = radii.max()
        val wanted = wantedFor(n)
        val taken = if (wanted == n) null else drawn(n, wanted, random)
        val cells = bestCells(wanted, largest, box, walled)
            ?: throw PlacementException(
                "$n spheres of radius up to $largest ${if (wanted == n) "" else "and ${wanted - n} vacancies "}" +
                    "do not fit into the box as a lattice (filling factor ${fillingFactor(radii, box)}); " +
                    "take fewer, smaller, or a box whose edges have simple ratios",
            )
        val basis = lattice.basis
        val sites = cells[0].toLong() * cells[1] * cells[2] * basis.size
        val width = DoubleArray(3) { width(it, cells[it], largest, box, walled) }
        val axes = box.space.dimensions
        val low =
            DoubleArray(3) {
                if (walled[it]) box.lower(it) + largest - lattice.inset(it) * width[it] else box.lower(it)
            }
        val p = Array(3) { DoubleArray(n) }
        for (k in 0 until n) {
            val site = (taken?.get(k) ?: k) * sites / wanted
            val b = basis[(site % basis.size).toInt()]
            var cell = site / basis.size
            for (axis in 0 until axes) {
                val c = cell % cells[axis]
                cell /= cells[axis]
                // A single site between walls is in the middle, and its cell has no width.
                p[axis][k] =
                    if (width[axis].isInfinite()) middle(axis, box) else low[axis] + (c + b[axis]) * width[axis]
            }
        }
        return Positions(p[0], p[1], p[2])
    }

    /**
     * One line about the lattice of [place] where cells are stretched by more than 5 %, or more than 1 % of the sites
     * stay empty besides [vacancies]; otherwise null.
     */
    internal fun remark(radii: DoubleArray, box: Box, walled: BooleanArray): String? {
        val wanted = wantedFor(radii.size)
        val cells = bestCells(wanted, radii.max(), box, walled) ?: return null
        val axes = box.space.dimensions
        val width = List(axes) { width(it, cells[it], radii.max(), box, walled) }
        val sites = cells[0].toLong() * cells[1] * cells[2] * lattice.basis.size
        // Of an infinite width there is one layer, which nothing stretches.
        val upright = List(axes) { width[it] / lattice.shape[it] }.filter { it.isFinite() }
        // In the plane cells may lie along y as well.
        val turned = if (upright.size == 2 && axes == 2) List(axes) { width[it] / lattice.shape[1 - it] } else null
        fun stretch(edges: List<Double>) = (edges.maxOrNull() ?: 1.0) / (edges.minOrNull() ?: 1.0)
        val edges = listOfNotNull(upright, turned).minBy(::stretch)
        val stretch = stretch(edges)
        val empty = sites - wanted
        if (stretch <= MOST_STRETCH && empty <= MOST_EMPTY * sites) return null
        val name = lattice.name.lowercase().replace('_', ' ')
        val shape = if (edges.isEmpty()) "" else edges.joinToString(" : ") { "%.3g".format(Locale.ROOT, it / edges[0]) }
        return "${cells.take(axes).joinToString(" × ")} cells of $name, stretched $shape; ${sites - radii.size} of " +
            "$sites sites are empty" + if (wanted == radii.size) "" else ", ${wanted - radii.size} of them as asked"
    }

    private fun wantedFor(n: Int): Int =
        if (vacancies == 0.0) n else Math.rint(n / (1 - vacancies)).coerceAtMost(MOST_SITES).toInt()

    /** [n] of the numbers from 0 until [all], each as likely, in order. */
    private fun drawn(n: Int, all: Int, random: SeededRandom): IntArray {
        val numbers = IntArray(all) { it }
        for (k in 0 until n) {
            val j = k + random.nextInt(all - k)
            numbers[k] = numbers[j].also { numbers[j] = numbers[k] }
        }
        return numbers.copyOf(n).apply { sort() }
    }

    private fun middle(axis: Int, box: Box) = box.lower(axis) + box.length(axis) / 2

    /** Infinite if there is a single site between two walls. */
    private fun width(axis: Int, cells: Int, radius: Double, box: Box, walled: BooleanArray): Double =
        if (walled[axis]) {
            (box.length(axis) - 2 * radius) / (cells - 2 * lattice.inset(axis))
        } else {
            box.length(axis) /
                cells
        }

    /**
     * The numbers of cells, at least enough for [n], that keep neighbours farthest apart; null when even those touch.
     */
    private fun bestCells(n: Int, radius: Double, box: Box, walled: BooleanArray): IntArray? {
        if (box.space.isPlane) return bestInPlane(n, radius, box, walled)
        val shape = lattice.shape
        val ideal = StrictMath.cbrt(box.volume * lattice.basis.size / n / (shape[0] * shape[1] * shape[2]))
        var best: IntArray? = null
        var bestDistance = 2 * radius * (1 + 1e-12)
        val guess = IntArray(3) { (box.length(it) / (ideal * shape[it])).coerceIn(1.0, 1e6).toInt() }
        for (a in choices(guess[0])) {
            for (b in choices(guess[1])) {
                val c = ceil(n.toDouble() / (a.toDouble() * b * lattice.basis.size)).coerceIn(1.0, 1e6).toInt()
                val w =
                    doubleArrayOf(
                        width(0, a, radius, box, walled),
                        width(1, b, radius, box, walled),
                        width(2, c, radius, box, walled),
                    )
                val distance = lattice.nearest(w)
                val isEnough = a.toDouble() * b * c * lattice.basis.size >= n
                if (isEnough && w.all { it > 0 } && distance >= bestDistance) {
                    bestDistance = distance
                    best = intArrayOf(a, b, c)
                }
            }
        }
        return best
    }

    /** The same in a flat box, for cells whose longer side is along x or along y. */
    private fun bestInPlane(n: Int, radius: Double, box: Box, walled: BooleanArray): IntArray? {
        val ideal = sqrt(box.volume * lattice.basis.size / n / lattice.shape[1])
        var best: IntArray? = null
        var bestDistance = 2 * radius * (1 + 1e-12)
        val guesses = setOf(ideal, lattice.shape[1] * ideal).map { (box.length(0) / it).coerceIn(1.0, 1e6).toInt() }
        for (a in guesses.flatMap { choices(it) }) {
            val b = ceil(n.toDouble() / (a.toDouble() * lattice.basis.size)).coerceIn(1.0, 1e6).toInt()
            val w = doubleArrayOf(width(0, a, radius, box, walled), width(1, b, radius, box, walled))
            val distance = lattice.nearest(w)
            val isEnough = a.toDouble() * b * lattice.basis.size >= n
            if (isEnough && w.all { it > 0 } && distance >= bestDistance) {
                bestDistance = distance
                best = intArrayOf(a, b, 1)
            }
        }
        return best
    }

    private fun choices(guess: Int) = maxOf(1, guess - SPREAD)..guess + SPREAD

    private companion object {
        const val SPREAD = 3
        const val MOST_SITES = 1e9

        /** What may be between edges, and be empty, before it is told. */
        const val MOST_STRETCH = 1.05
        const val MOST_EMPTY = 0.01
    }
}

/**
 * Crystal lattices by their basis, in fractions of a cell.
 *
 * @property shape edges of a cell that is not stretched, in those along x
 */
public enum class Lattice(
    internal val basis: List<DoubleArray>,
    internal val shape: DoubleArray = doubleArrayOf(1.0, 1.0, 1.0),
) {
    SIMPLE_CUBIC(listOf(doubleArrayOf(0.5, 0.5, 0.5))),
    FACE_CENTRED_CUBIC(
        listOf(
            doubleArrayOf(0.25, 0.25, 0.25),
            doubleArrayOf(0.75, 0.75, 0.25),
            doubleArrayOf(0.75, 0.25, 0.75),
            doubleArrayOf(0.25, 0.75, 0.75),
        ),
    ),
    BODY_CENTRED_CUBIC(listOf(doubleArrayOf(0.25, 0.25, 0.25), doubleArrayOf(0.75, 0.75, 0.75))),

    /** Layers across z, each with rows along x. */
    HEXAGONAL_CLOSE_PACKED(
        listOf(
            doubleArrayOf(0.25, 1.0 / 12, 0.25),
            doubleArrayOf(0.75, 7.0 / 12, 0.25),
            doubleArrayOf(0.75, 11.0 / 12, 0.75),
            doubleArrayOf(0.25, 5.0 / 12, 0.75),
        ),
        doubleArrayOf(1.0, sqrt(3.0), sqrt(8.0 / 3)),
    ),

    /** Of discs in the plane. */
    SQUARE(listOf(doubleArrayOf(0.5, 0.5))),

    /** Of discs in the plane, by cells of two whose sides are as 1 to √3; fills 0.9069 at most. */
    HEXAGONAL(listOf(doubleArrayOf(0.25, 0.25), doubleArrayOf(0.75, 0.75)), doubleArrayOf(1.0, sqrt(3.0), 1.0)),
    ;

    /** Least distance of a site from a face across [axis], in fractions of a cell. */
    internal fun inset(axis: Int): Double = basis.minOf { it.getOrElse(axis) { 0.0 } }

    /** Whether it is one of discs. */
    internal val isPlane: Boolean get() = basis[0].size == 2

    /** Distance of nearest neighbours for cells of the given widths, over faces too. */
    internal fun nearest(w: DoubleArray): Double = when (this) {
        SIMPLE_CUBIC -> minOf(w[0], w[1], w[2])
        SQUARE -> minOf(w[0], w[1])
        HEXAGONAL -> minOf(w[0], w[1], half(w[0], w[1]))
        FACE_CENTRED_CUBIC -> minOf(
            minOf(w[0], w[1], w[2]),
            minOf(half(w[0], w[1]), half(w[0], w[2]), half(w[1], w[2])),
        )
        BODY_CENTRED_CUBIC, HEXAGONAL_CLOSE_PACKED -> nearestOf(w)
    }

    /** Of all sites and their images. */
    private fun nearestOf(w: DoubleArray): Double {
        var least = minOf(w[0], w[1], w[2])
        for (a in basis) {
            for (b in basis) {
                if (a === b) continue
                var square = 0.0
                for (axis in 0..2) {
                    val apart = b[axis] - a[axis]
                    val d = w[axis] * (apart - Math.rint(apart))
                    square += d * d
                }
                least = minOf(least, sqrt(square))
            }
        }
        return least
    }

    private fun half(a: Double, b: Double): Double = 0.5 * sqrt(a * a + b * b)
}
