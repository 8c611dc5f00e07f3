package daphnis.core.force.mesh

import kotlin.math.floor
import kotlin.math.sqrt

/**
 * What the mesh leaves out: the pull of spheres within the radius of a cloud, 1/(r² + ε²) less that of the cloud, image
 * by image. Each thread has its own.
 */
internal class NearPulls(private val cells: MeshCells, private val softening: Double) {
    private var points = MeshPoints(1, 1, 2, 1.0, 1.0, 1.0, 1.0)
    private var reach2 = 1.0
    private var perReach = 1.0
    private var perReach2 = 1.0
    private var perReach3 = 1.0
    private var least2 = 0.0
    private var lift = 0.0
    private var pullAtEnd = 0.0
    private val softening2 = softening * softening

    /** Acceleration by [pull], Σ a_y Δx and minus the potential by [measure], of the last sphere, divided by G. */
    var ax = 0.0
        private set
    var ay = 0.0
        private set
    var az = 0.0
        private set
    var stress = 0.0
        private set
    var depth = 0.0
        private set

    fun begin(points: MeshPoints) {
        this.points = points
        val a = points.reach
        reach2 = a * a
        perReach = 1 / a
        perReach2 = 1 / (a * a)
        perReach3 = 1 / (a * a * a)
        least2 = reach2 * LEAST
        // So that force and potential of a pair end at 0 with softening, too.
        val end = a * a + softening2
        lift = 1 / sqrt(end) - 1 / a
        pullAtEnd = 1 / (end * sqrt(end)) - perReach3
    }

    /** Sums the acceleration over what is near the sphere at [place]. */
    fun pull(place: Int) {
        ax = 0.0
        ay = 0.0
        az = 0.0
        sum(place, false)
    }

    /** Sums stress and potential over what is near the sphere at [place]. */
    fun measure(place: Int) {
        stress = 0.0
        depth = 0.0
        sum(place, true)
    }

    private fun sum(place: Int, isMeasure: Boolean) {
        val x = cells.x[place]
        val hx = points.hx
        val first = floor((x - points.reach) * points.perX).toInt()
        val last = floor((x + points.reach) * points.perX).toInt()
        for (column in first..last) {
            val left = column * hx - x
            val right = x - (column + 1) * hx
            val gap = maxOf(left, right, 0.0)
            val rest = reach2 - gap * gap
            if (rest > 0) sumColumn(place, column, sqrt(rest), isMeasure)
        }
    }

    /** The spheres of a [column], which may be one of an image, within [half] along y. */
    private fun sumColumn(place: Int, column: Int, half: Double, isMeasure: Boolean) {
        val ny = points.ny
        val boxes = if (column >= 0 && column < points.nx) 0 else Math.floorDiv(column, points.nx)
        val own = column - boxes * points.nx
        val y = cells.y[place] - boxes * cells.offset
        var row = floor((y - half) * points.perY).toInt()
        val last = floor((y + half) * points.perY).toInt()
        while (row <= last) {
            val around = if (row >= 0 && row < ny) 0 else Math.floorDiv(row, ny)
            val end = minOf(last, around * ny + ny - 1)
            val from = cells.start[own * ny + row - around * ny]
            val to = cells.start[own * ny + end - around * ny + 1]
            val x = cells.x[place] - boxes * points.lx
            if (isMeasure) {
                measureRun(from, to, x, y - around * points.ly, cells.z[place])
            } else {
                pullRun(from, to, x, y - around * points.ly, cells.z[place])
            }
            row = end + 1
        }
    }

    private fun pullRun(from: Int, to: Int, x: Double, y: Double, z: Double) {
        val sx = cells.x
        val sy = cells.y
        val sz = cells.z
        val sm = cells.mass
        var ax = ax
        var ay = ay
        var az = az
        for (k in from until to) {
            val dx = sx[k] - x
            val dy = sy[k] - y
            val dz = sz[k] - z
            // Beyond the reach nothing is left but round-off. No branch, since which are beyond is no pattern. The sphere
            // itself is in the run; its distance is 0.
            val d2 = Math.min(Math.max(dx * dx + dy * dy + dz * dz, least2), reach2)
            val s2 = d2 + softening2
            val f = sm[k] * (1 / (s2 * sqrt(s2)) - perReach3 * CompactShape.pull(d2 * perReach2) - pullAtEnd)
            ax += f * dx
            ay += f * dy
            az += f * dz
        }
        this.ax = ax
        this.ay = ay
        this.az = az
    }

    private fun measureRun(from: Int, to: Int, x: Double, y: Double, z: Double) {
        for (k in from until to) {
            val dx = cells.x[k] - x
            val dy = cells.y[k] - y
            val dz = cells.z[k] - z
            val d2 = dx * dx + dy * dy + dz * dz
            if (d2 >= reach2 || d2 == 0.0) continue
            val u2 = d2 * perReach2
            val s2 = d2 + softening2
            val m = cells.mass[k]
            stress += m * (1 / (s2 * sqrt(s2)) - perReach3 * CompactShape.pull(u2) - pullAtEnd) * dy * dx
            depth += m * (1 / sqrt(s2) - perReach * CompactShape.depth(u2) - lift - 0.5 * pullAtEnd * (reach2 - d2))
        }
    }

    private companion object {
        /** Square of a distance over the reach that no two spheres have, whose inverse cube still is a number. */
        const val LEAST = 1e-60
    }
}
