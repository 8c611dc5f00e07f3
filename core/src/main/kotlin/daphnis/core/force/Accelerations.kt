package daphnis.core.force

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Partition
import daphnis.core.population.Population

/**
 * Accelerations by index in a population, and the positions that they are of: a force need not be computed again when
 * no sphere has moved.
 */
internal class Accelerations {
    var x = DoubleArray(0)
        private set
    var y = DoubleArray(0)
        private set
    var z = DoubleArray(0)
        private set
    private var atX = DoubleArray(0)
    private var atY = DoubleArray(0)
    private var atZ = DoubleArray(0)
    private var time = Double.NaN
    private val isOther = DoubleArray(1)

    /** Whether they are those of [p] at [time], on every node of [partition]. */
    fun areOf(p: Population, time: Double, partition: Partition): Boolean {
        isOther[0] = if (areOf(p, time)) 0.0 else 1.0
        partition.max(isOther)
        return isOther[0] == 0.0
    }

    private fun areOf(p: Population, time: Double): Boolean = time == this.time &&
        atX.size == p.size &&
        atX.contentEquals(p.x) &&
        atY.contentEquals(p.y) &&
        atZ.contentEquals(p.z)

    /** Makes room for [size] spheres. Until [keep] these are of no positions: a failure leaves parts of both. */
    fun begin(size: Int) {
        time = Double.NaN
        if (z.size >= size) return
        x = DoubleArray(size)
        y = DoubleArray(size)
        // Assigned last, since its length says how many spheres there is room for: an allocation before it may fail.
        z = DoubleArray(size)
    }

    /** They are those of [p] at [time]. */
    fun keep(p: Population, time: Double) {
        if (atZ.size != p.size) {
            atX = DoubleArray(p.size)
            atY = DoubleArray(p.size)
            atZ = DoubleArray(p.size)
        }
        p.x.copyInto(atX)
        p.y.copyInto(atY)
        p.z.copyInto(atZ)
        this.time = time
    }

    /** Adds them times [duration] to the velocities of [p] on the threads of [loop]. */
    fun kick(p: Population, duration: Double, loop: RangeLoop) {
        loop.run(p.size) { _, from, to ->
            for (k in from until to) {
                p.vx[k] += x[k] * duration
                p.vy[k] += y[k] * duration
                p.vz[k] += z[k] * duration
            }
        }
    }
}
