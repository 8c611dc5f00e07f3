package daphnis.core.engine.horizon

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/**
 * Chooses which spheres are so large that they get no cell. A search looks as far around a path as the largest member
 * requires, so one body among ring particles would have every search look at most of them. Giants are few, and have a
 * coarse grid of their own.
 */
internal class MemberSizes {
    /** Spheres by how many octaves smaller than the largest they are, and the largest radius there. */
    private class Octaves {
        val counts = IntArray(OCTAVES)
        val largest = DoubleArray(OCTAVES)
        var sum = 0.0

        fun clear() {
            counts.fill(0)
            largest.fill(0.0)
            sum = 0.0
        }

        fun add(other: Octaves) {
            for (octave in 0 until OCTAVES) {
                counts[octave] += other.counts[octave]
                largest[octave] = maxOf(largest[octave], other.largest[octave])
            }
            sum += other.sum
        }
    }

    private val all = Octaves()

    /** Mean radius of the spheres that were measured last. */
    var mean = 0.0
        private set

    /** Of parts of the same length each time, so that sums are the same with any number of threads. */
    private val parts = ArrayList<Octaves>()

    /**
     * The largest radius of a member: that of which least work is expected.
     *
     * @param rms root mean square of the velocities along row axis, middle axis and slow axis
     */
    fun choose(spheres: SphereColumns, frame: EpochFrame, rms: DoubleArray, loop: RangeLoop): Double {
        measure(spheres, frame.largestRadius, loop)
        mean = all.sum / spheres.size
        var best = frame.largestRadius
        var least = Double.POSITIVE_INFINITY
        var giants = 0
        for (octave in 0 until OCTAVES) {
            val radius = all.largest[octave]
            if (all.counts[octave] == 0) continue
            if (radius < frame.leastMemberRadius && octave > 0) break
            val work = work(spheres.size, giants, radius, frame, rms)
            if (work < least) {
                least = work
                best = radius
            }
            giants += all.counts[octave]
        }
        return best
    }

    private fun measure(spheres: SphereColumns, largestRadius: Double, loop: RangeLoop) {
        val count = (spheres.size - 1) / RangeLoop.GRAIN + 1
        while (parts.size < count) parts.add(Octaves())
        loop.run(count, PARTS_A_PIECE) { _, from, to ->
            for (part in from until to) measure(spheres, largestRadius, part)
        }
        all.clear()
        for (part in 0 until count) all.add(parts[part])
    }

    private fun measure(spheres: SphereColumns, largestRadius: Double, part: Int) {
        val octaves = parts[part]
        octaves.clear()
        val top = Math.getExponent(largestRadius)
        val from = part * RangeLoop.GRAIN
        for (i in from until minOf(from + RangeLoop.GRAIN, spheres.size)) {
            val r = spheres.radius[i]
            val octave = minOf(top - Math.getExponent(r), OCTAVES - 1)
            octaves.counts[octave]++
            if (r > octaves.largest[octave]) octaves.largest[octave] = r
            octaves.sum += r
        }
    }

    /** Lines that a search looks at, on average, if members have a radius of at most [radius]; in units of a line. */
    private fun work(spheres: Int, giants: Int, radius: Double, frame: EpochFrame, rms: DoubleArray): Double {
        val members = (spheres - giants).toDouble()
        val near = members * share(mean + radius, frame, rms)
        if (giants == 0) return near
        // The giants' grid is looked at cell by cell, and they themselves look at members far around.
        val listed = giants * share(2 * (mean + frame.largestRadius), frame, rms)
        val ofGiants = giants.toDouble() / spheres * members * share(radius + frame.largestRadius, frame, rms)
        return near + LISTS + ENTRY * listed + ofGiants
    }

    /** The part of the box within [distance] and the way of a sphere in some steps. */
    private fun share(distance: Double, frame: EpochFrame, rms: DoubleArray): Double {
        var share = 1.0
        for (k in 0 until AXES) {
            val range = 2 * (distance + rms[k] * STEPS * frame.duration)
            if (range < frame.length[k]) share *= range / frame.length[k]
        }
        return share
    }

    private companion object {
        const val AXES = 3
        const val OCTAVES = 16
        const val PARTS_A_PIECE = 4

        /** An expected length of epochs. */
        const val STEPS = 4

        /** In units of a line that is tested: to look for giants at all, and a giant in a list. */
        const val LISTS = 20.0
        const val ENTRY = 8.0
    }
}
