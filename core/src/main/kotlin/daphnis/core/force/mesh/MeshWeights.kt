package daphnis.core.force.mesh

import daphnis.core.force.mesh.CubicSpline.POINTS
import kotlin.math.floor

/** Spreads masses over a [SheetMesh] and reads its potential at spheres. Each thread has its own. */
internal class MeshWeights(private val cells: MeshCells) {
    private val wx = DoubleArray(POINTS)
    private val wy = DoubleArray(POINTS)
    private val wz = DoubleArray(POINTS)
    private val gx = DoubleArray(POINTS)
    private val gy = DoubleArray(POINTS)
    private val gz = DoubleArray(POINTS)

    /** Acceleration and potential (positive) of the last sphere read, divided by G. */
    var ax = 0.0
        private set
    var ay = 0.0
        private set
    var az = 0.0
        private set
    var depth = 0.0
        private set

    /**
     * Fills a [column] of points with the masses around it, sphere by sphere in the order of the cells. Beyond the
     * faces images are taken, where they are.
     */
    fun fill(mesh: SheetMesh, column: Int) {
        val points = mesh.points
        val ny = points.ny
        val nz = points.nz
        val size = ny * nz
        mesh.values.fill(0.0, column * size, column * size + size)
        for (near in column - 2..column + 1) {
            val boxes = Math.floorDiv(near, points.nx)
            val own = near - boxes * points.nx
            val at = column * size
            for (place in cells.start[own * ny] until cells.start[own * ny + ny]) {
                CubicSpline.weights(cells.x[place] * points.perX - own, wx, 0)
                val share = wx[column - near + 1] * cells.mass[place]
                val y = rowsOf((cells.y[place] + boxes * cells.offset) * points.perY, ny)
                val z = planesOf(cells.z[place], points)
                for (b in 0 until POINTS) {
                    val row = if (y + b < ny) y + b else y + b - ny
                    val p = at + row * nz + z
                    val part = share * wy[b]
                    mesh.values[p] += part * wz[0]
                    mesh.values[p + 1] += part * wz[1]
                    mesh.values[p + 2] += part * wz[2]
                    mesh.values[p + 3] += part * wz[3]
                }
            }
        }
    }

    /** Weights along y of a sphere [place] spacings up; returns the first of its points, in 0 until [ny]. */
    private fun rowsOf(place: Double, ny: Int): Int {
        val row = floor(place)
        CubicSpline.weights(place - row, wy, 0)
        val first = row.toInt() - 1
        return if (first >= 0 && first < ny) first else Math.floorMod(first, ny)
    }

    private fun planesOf(z: Double, points: MeshPoints): Int {
        val place = z * points.perZ - 0.5
        val plane = floor(place)
        CubicSpline.weights(place - plane, wz, 0)
        return plane.toInt() - 1 + points.nz / 2
    }

    /** Reads the potential and its slopes at the sphere at [place]. */
    fun read(mesh: SheetMesh, place: Int) {
        val points = mesh.points
        val ny = points.ny
        val nz = points.nz
        val own = MeshCells.column(cells.x[place], points)
        val t = cells.x[place] * points.perX - own
        CubicSpline.weights(t, wx, 0)
        CubicSpline.slopes(t, gx, 0)
        val z = planesOf(cells.z[place], points)
        val up = cells.z[place] * points.perZ - 0.5
        CubicSpline.slopes(up - floor(up), gz, 0)
        var sumX = 0.0
        var sumY = 0.0
        var sumZ = 0.0
        var sum = 0.0
        var shifted = Int.MIN_VALUE
        var y = 0
        for (a in 0 until POINTS) {
            val column = own - 1 + a
            val boxes = if (column >= 0 && column < points.nx) 0 else Math.floorDiv(column, points.nx)
            if (boxes != shifted) {
                val along = (cells.y[place] - boxes * cells.offset) * points.perY
                y = rowsOf(along, ny)
                CubicSpline.slopes(along - floor(along), gy, 0)
                shifted = boxes
            }
            val at = (column - boxes * points.nx) * ny
            var value = 0.0
            var slopeY = 0.0
            var slopeZ = 0.0
            for (b in 0 until POINTS) {
                val row = if (y + b < ny) y + b else y + b - ny
                val p = (at + row) * nz + z
                val v0 = mesh.values[p]
                val v1 = mesh.values[p + 1]
                val v2 = mesh.values[p + 2]
                val v3 = mesh.values[p + 3]
                val v = wz[0] * v0 + wz[1] * v1 + wz[2] * v2 + wz[3] * v3
                value += wy[b] * v
                slopeY += gy[b] * v
                slopeZ += wy[b] * (gz[0] * v0 + gz[1] * v1 + gz[2] * v2 + gz[3] * v3)
            }
            sum += wx[a] * value
            sumX += gx[a] * value
            sumY += wx[a] * slopeY
            sumZ += wx[a] * slopeZ
        }
        ax = sumX * points.perX
        ay = sumY * points.perY
        az = sumZ * points.perZ
        depth = sum
    }
}
