package daphnis.core.engine.horizon

import daphnis.core.population.SphereColumns

/**
 * Chooses which spheres are so large that they get no cell. A search looks as far around a path as the largest member
 * requires, so one body among ring particles would have every search look at most of them. Giants are few, and have a
 * coarse grid of their own.
 */
internal class MemberSizes {
    /** Spheres by how many octaves smaller than the largest they are, and the largest radius there. */
    private val counts = IntArray(OCTAVES)
    private val largest = DoubleArray(OCTAVES)

    /**
     * The largest radius of a member: that of which least work is expected.
     *
     * @param rms root mean square of the velocities along row axis, middle axis and slow axis
     */
    fun choose(spheres: SphereColumns, frame: EpochFrame, rms: DoubleArray): Double {
        val mean = measure(spheres, frame.largestRadius)
        var best = frame.largestRadius
        var least = Double.POSITIVE_INFINITY
        var giants = 0
        for (octave in 0 until OCTAVES) {
            val radius = largest[octave]
            if (counts[octave] == 0) continue
            if (radius < frame.leastMemberRadius && octave > 0) break
            val work = work(spheres.size, giants, mean, radius, frame, rms)
            if (work < least) {
                least = work
                best = radius
            }
            giants += counts[octave]
        }
        return best
    }

    /** @return the mean radius */
    private fun measure(spheres: SphereColumns, largestRadius: Double): Double {
        counts.fill(0)
        largest.fill(0.0)
        val top = Math.getExponent(largestRadius)
        var sum = 0.0
        for (i in 0 until spheres.size) {
            val r = spheres.radius[i]
            val octave = minOf(top - Math.getExponent(r), OCTAVES - 1)
            counts[octave]++
            if (r > largest[octave]) largest[octave] = r
            sum += r
        }
        return sum / spheres.size
    }

    /** Lines that a search looks at, on average, if members have a radius of at most [radius]; in units of a line. */
    private fun work(
        spheres: Int,
        giants: Int,
        mean: Double,
        radius: Double,
        frame: EpochFrame,
        rms: DoubleArray,
    ): Double {
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

        /** An expected length of epochs. */
        const val STEPS = 4

        /** In units of a line that is tested: to look for giants at all, and a giant in a list. */
        const val LISTS = 20.0
        const val ENTRY = 8.0
    }
}
