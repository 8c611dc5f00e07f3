package daphnis.core.engine.horizon

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * How fast the spheres of an epoch are at its start, along row axis, middle axis and slow axis; along rows, relative to
 * the mean flow.
 */
internal class Speeds(private val frame: EpochFrame, private val loop: RangeLoop) {
    /** Root mean square of the velocities. */
    val rms = DoubleArray(AXES)

    /** Greatest velocity of any sphere. */
    val fastest = DoubleArray(AXES)

    /** The part of the spheres that are faster along an axis than [TAIL] times the [rms]. */
    var fastShare = 0.0
        private set

    /** By part of the spheres and axis: sum of squares, and greatest. */
    private var sums = DoubleArray(0)
    private var maxima = DoubleArray(0)

    /** Measures [spheres]. */
    fun measure(spheres: SphereColumns) {
        // Parts of the same length each time, whose sums are added in order: the same bits with any number of threads.
        val parts = (spheres.size - 1) / MEASURED_AT_ONCE + 1
        if (sums.size < AXES * parts) {
            maxima = DoubleArray(AXES * parts)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            sums = DoubleArray(AXES * parts)
        }
        loop.run(parts, 1) { _, from, to -> for (part in from until to) measure(spheres, part) }
        for (k in 0 until AXES) {
            var sum = 0.0
            var most = 0.0
            for (part in 0 until parts) {
                sum += sums[AXES * part + k]
                most = maxOf(most, maxima[AXES * part + k])
            }
            rms[k] = sqrt(sum / spheres.size)
            fastest[k] = most
        }
        loop.run(parts, 1) { _, from, to -> for (part in from until to) sums[part] = countFast(spheres, part) }
        var fast = 0.0
        for (part in 0 until parts) fast += sums[part]
        fastShare = fast / spheres.size
    }

    /** How many spheres of this part are faster along an axis than [TAIL] times the [rms]. */
    private fun countFast(spheres: SphereColumns, part: Int): Double {
        val from = part * MEASURED_AT_ONCE
        val normal = spheres.position(frame.axes[2])
        val v0 = spheres.velocity(frame.axes[0])
        val v1 = spheres.velocity(frame.axes[1])
        val v2 = spheres.velocity(frame.axes[2])
        var count = 0
        for (i in from until minOf(from + MEASURED_AT_ONCE, spheres.size)) {
            val isSlow = abs(v0[i] - frame.flowRate * normal[i]) <= TAIL * rms[0] &&
                abs(v1[i]) <= TAIL * rms[1] &&
                abs(v2[i]) <= TAIL * rms[2]
            if (!isSlow) count++
        }
        return count.toDouble()
    }

    private fun measure(spheres: SphereColumns, part: Int) {
        val from = part * MEASURED_AT_ONCE
        val to = minOf(from + MEASURED_AT_ONCE, spheres.size)
        val normal = spheres.position(frame.axes[2])
        for (k in 0 until AXES) {
            val velocity = spheres.velocity(frame.axes[k])
            val rate = if (k == 0) frame.flowRate else 0.0
            var sum = 0.0
            var most = 0.0
            for (i in from until to) {
                val own = velocity[i] - rate * normal[i]
                sum += own * own
                if (abs(own) > most) most = abs(own)
            }
            sums[AXES * part + k] = sum
            maxima[AXES * part + k] = most
        }
    }

    /** [rms], but not much less than along the fastest axis. */
    fun rmsAtLeast(k: Int): Double = maxOf(rms[k], LEAST_SHARE * maxOf(rms[0], rms[1], rms[2]))

    private companion object {
        const val AXES = 3
        const val MEASURED_AT_ONCE = 8192

        /** Along each axis [rmsAtLeast] is at least this part of that along the fastest axis. */
        const val LEAST_SHARE = 0.05

        /** In units of the root mean square: what counts as fast. */
        const val TAIL = 3.0
    }
}
