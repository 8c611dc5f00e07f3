package daphnis.analysis.occultation

import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.sin
import kotlin.math.sqrt
import kotlin.math.tan

/**
 * Drops the shadows of the spheres of [state], and of their images, onto a [lattice] that is turned: its axis u has the
 * direction ([c], [s]) in the plane, v is to the left of it, and its middle is that of the box.
 *
 * A sphere of radius r shadows an ellipse with the semi-axes r/sin B along the azimuth A of the rays and r beside it.
 * With α = A − the direction of u, a row of rays at the distance p from the middle of the shadow is blocked where
 * |u − k p| ≤ ((r² − κ p²)/β)^½, with β = cos²α sin²B + sin²α, k = cos α sin α cos²B/β and κ = sin²B/β.
 */
internal class ShadowCaster(
    private val state: State,
    line: LineOfSight,
    private val c: Double,
    private val s: Double,
    val lattice: Lattice,
) {
    private val box = state.boundary.box
    private val images = PlaneImages(state.boundary, state.time)
    private val sine = sin(line.elevation)
    private val cotangent = if (line.elevation == PI / 2) 0.0 else 1 / tan(line.elevation)
    private val towardX = cos(line.azimuth)
    private val towardY = sin(line.azimuth)
    private val alongU = towardX * c + towardY * s
    private val alongV = towardY * c - towardX * s
    private val beta = alongU * alongU * sine * sine + alongV * alongV
    private val lean = alongU * alongV * (1 - sine * sine) / beta
    private val kappa = sine * sine / beta
    private val highest = 1 / sqrt(kappa)
    private val lengthU = lattice.places * lattice.nu * lattice.stepU
    private val lengthV = lattice.tracks * lattice.nv * lattice.stepV
    private val mask = lattice.mask()

    fun cast(): ShadowMask {
        val p = state.population
        var largest = 0.0
        for (k in 0 until p.size) largest = maxOf(largest, p.radius[k])
        val shifts = shifts(largest / sine)
        val shiftU = DoubleArray(shifts.size) { shifts[it][0] * c + shifts[it][1] * s }
        val shiftV = DoubleArray(shifts.size) { shifts[it][1] * c - shifts[it][0] * s }
        val middleX = box.lowerX + box.length(0) / 2
        val middleY = box.lowerY + box.length(1) / 2
        val pause = maxOf(FEWEST_BETWEEN, p.size / PAUSES)
        for (k in 0 until p.size) {
            // At low elevations few spheres leave no point free, each by many images.
            if (k % pause == 0 && mask.isFull()) break
            var x = p.x[k] - p.z[k] * cotangent * towardX - middleX
            var y = p.y[k] - p.z[k] * cotangent * towardY - middleY
            // Into the box, first from row to row of images, then along the row.
            val rows = boxes(if (images.across == 0) x else y, images.across)
            x -= rowX(rows)
            y -= rowY(rows)
            val within = boxes(if (images.along == 0) x else y, images.along) * box.length(images.along)
            if (images.along == 0) x -= within else y -= within
            val u = x * c + y * s + lengthU / 2
            val v = y * c - x * s + lengthV / 2
            for (i in shiftU.indices) drop(u + shiftU[i], v + shiftV[i], p.radius[k])
        }
        return mask
    }

    /** Edges along [axis] between the middle of the box and that in which [place] is; 0 at faces without images. */
    private fun boxes(place: Double, axis: Int) =
        if (images.repeats(axis)) Math.rint(place / box.length(axis)).toInt() else 0

    private fun rowX(row: Int) = row * if (images.across == 0) box.length(0) else images.offset

    private fun rowY(row: Int) = row * if (images.across == 0) images.offset else box.length(1)

    /** Displacements (x, y) of all images that a shadow within [reach] of its middle may fall onto the lattice from. */
    private fun shifts(reach: Double): List<DoubleArray> {
        val edges = DoubleArray(2) { box.length(it) }
        // Half of what the lattice covers along x and y.
        val covered = doubleArrayOf(
            (lengthU * abs(c) + lengthV * abs(s)) / 2,
            (lengthU * abs(s) + lengthV * abs(c)) / 2,
        )
        val (across, along) = images.across to images.along
        fun most(axis: Int) = ceil((edges[axis] / 2 + covered[axis] + reach) / edges[axis]).toInt()
        val found = ArrayList<DoubleArray>()
        val rows = if (images.repeats(across)) most(across) else 0
        for (row in -rows..rows) {
            val slid = row * images.offset / edges[along]
            val (from, to) = if (images.repeats(along)) {
                floor(-slid - most(along)).toInt() to ceil(-slid + most(along)).toInt()
            } else {
                0 to 0
            }
            for (place in from..to) {
                val beside = place * edges[along]
                val x = rowX(row) + if (along == 0) beside else 0.0
                val y = rowY(row) + if (along == 1) beside else 0.0
                if (mayFall(x, y, covered, reach)) found += doubleArrayOf(x, y)
            }
        }
        return found
    }

    /** Whether the image of the box displaced by ([x], [y]) comes within [reach] of the lattice: along all four axes. */
    private fun mayFall(x: Double, y: Double, covered: DoubleArray, reach: Double): Boolean {
        val (halfX, halfY) = box.length(0) / 2 to box.length(1) / 2
        return abs(x) <= halfX + covered[0] + reach &&
            abs(y) <= halfY + covered[1] + reach &&
            abs(x * c + y * s) <= halfX * abs(c) + halfY * abs(s) + lengthU / 2 + reach &&
            abs(y * c - x * s) <= halfX * abs(s) + halfY * abs(c) + lengthV / 2 + reach
    }

    private fun drop(u: Double, v: Double, r: Double) {
        val high = r * highest
        val stepV = lattice.stepV
        val firstRow = maxOf(0, ceil((v - high) / stepV - 0.5).toInt())
        val lastRow = minOf(mask.rows - 1, floor((v + high) / stepV - 0.5).toInt())
        if (firstRow > lastRow) return
        val long = r / sine
        if (u + long < 0 || u - long > lengthU) return
        for (row in firstRow..lastRow) {
            val p = (row + 0.5) * stepV - v
            val half = sqrt(maxOf(0.0, (r * r - kappa * p * p) / beta))
            val middle = u + lean * p
            val from = maxOf(0, ceil((middle - half) / lattice.stepU - 0.5).toInt())
            val to = minOf(mask.places - 1, floor((middle + half) / lattice.stepU - 0.5).toInt())
            if (from <= to) mask.block(row, from, to)
        }
    }

    private companion object {
        /** How often it is asked whether a point is free, and between how many spheres at least. */
        const val PAUSES = 64
        const val FEWEST_BETWEEN = 64
    }
}
