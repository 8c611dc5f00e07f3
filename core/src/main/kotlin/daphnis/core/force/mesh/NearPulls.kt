package daphnis.core.force.mesh

import kotlin.math.floor
import kotlin.math.sqrt

/**
 * What the mesh leaves out: the pull of spheres within the radius of a cloud, 1/(r² + ε²) less that of the cloud, image
 * by image. Each thread has its own.
 */
internal class NearPulls(private val cells: MeshCells, private val softening: Double) {
    private var points = MeshPoints(1, 1, 2, 1.0, 1.0, 1.0)
    private var reach2 = 1.0
    private var perReach = 1.0
    private var perReach2 = 1.0
    private var perReach3 = 1.0
    private var lift = 0.0

    /** Acceleration, Σ a_y Δx and minus the potential of the last sphere, divided by G. */
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
        // So that the potential of a pair ends at 0.
        lift = 1 / sqrt(a * a + softening * softening) - 1 / a
    }

    /** Sums over what is near the sphere at [place]. */
    fun sum(place: Int) {
        ax = 0.0
        ay = 0.0
        az = 0.0
        stress = 0.0
        depth = 0.0
        val x = cells.x[place]
        val hx = points.hx
        val first = floor((x - points.reach) / hx).toInt()
        val last = floor((x + points.reach) / hx).toInt()
        for (column in first..last) {
            val left = column * hx - x
            val right = x - (column + 1) * hx
            val gap = maxOf(left, right, 0.0)
            val rest = reach2 - gap * gap
            if (rest > 0) sumColumn(place, column, sqrt(rest))
        }
    }

    /** The spheres of a [column], which may be one of an image, within [half] along y. */
    private fun sumColumn(place: Int, column: Int, half: Double) {
        val boxes = Math.floorDiv(column, points.nx)
        val own = column - boxes * points.nx
        val ny = points.ny
        val y = cells.y[place] - boxes * cells.offset
        var row = floor((y - half) / points.hy).toInt()
        val last = floor((y + half) / points.hy).toInt()
        while (row <= last) {
            val around = Math.floorDiv(row, ny)
            val end = minOf(last, around * ny + ny - 1)
            val from = cells.start[own * ny + row - around * ny]
            val to = cells.start[own * ny + end - around * ny + 1]
            sumRun(from, to, cells.x[place] - boxes * points.lx, y - around * points.ly, cells.z[place])
            row = end + 1
        }
    }

    private fun sumRun(from: Int, to: Int, x: Double, y: Double, z: Double) {
        val sx = cells.x
        val sy = cells.y
        val sz = cells.z
        val sm = cells.mass
        val softening2 = softening * softening
        var ax = ax
        var ay = ay
        var az = az
        var stress = stress
        var depth = depth
        for (k in from until to) {
            val dx = sx[k] - x
            val dy = sy[k] - y
            val dz = sz[k] - z
            val d2 = dx * dx + dy * dy + dz * dz
            // The sphere itself is in the run.
            if (d2 >= reach2 || d2 == 0.0) continue
            val m = sm[k]
            val u2 = d2 * perReach2
            val s2 = d2 + softening2
            val inverse = 1 / sqrt(s2)
            val f = m * (inverse * inverse * inverse - perReach3 * CompactShape.pull(u2))
            ax += f * dx
            ay += f * dy
            az += f * dz
            stress += f * dy * dx
            depth += m * (inverse - perReach * CompactShape.depth(u2) - lift)
        }
        this.ax = ax
        this.ay = ay
        this.az = az
        this.stress = stress
        this.depth = depth
    }
}
