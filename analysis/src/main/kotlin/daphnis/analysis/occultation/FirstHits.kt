package daphnis.analysis.occultation

import kotlin.math.sqrt

/**
 * Where the rays of a [RayCasting] meet the sphere that is nearest to the eye, toward which they climb. Rays are at
 * `i · ny + j`, as in [RayCasting.Shadow].
 *
 * @property nx rays along x; [ny] along y
 */
internal class FirstHits(val nx: Int, val ny: Int) {
    /** Index of the sphere; −1 where nothing is met. */
    val sphere = IntArray(nx * ny) { -1 }

    /** Unit normals of the sphere where they meet it, along x, y and z. */
    val normalX = DoubleArray(nx * ny)
    val normalY = DoubleArray(nx * ny)
    val normalZ = DoubleArray(nx * ny)

    /** Distance of that place along the ray from the plane z = 0. */
    private val distance = DoubleArray(nx * ny)

    /**
     * Takes in that [ray], whose direction is [toEye], meets the sphere [k] of the radius [r] at the height [z]. The
     * ray passes the plane z = 0 at ([dx], [dy]) from where the ray through the centre does.
     */
    fun offer(ray: Int, k: Int, dx: Double, dy: Double, z: Double, r: Double, toEye: DoubleArray) {
        val along = dx * toEye[0] + dy * toEye[1]
        val out = sqrt(maxOf(0.0, along * along - dx * dx - dy * dy + r * r)) - along
        val place = out + z / toEye[2]
        if (sphere[ray] >= 0 && place <= distance[ray]) return
        sphere[ray] = k
        distance[ray] = place
        normalX[ray] = (dx + out * toEye[0]) / r
        normalY[ray] = (dy + out * toEye[1]) / r
        normalZ[ray] = out * toEye[2] / r
    }

    /** Rays that meet none. */
    val free: Int get() = sphere.count { it < 0 }
}
