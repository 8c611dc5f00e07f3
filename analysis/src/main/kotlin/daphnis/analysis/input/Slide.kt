package daphnis.analysis.input

import daphnis.core.format.Snapshot
import daphnis.core.input.WayOut
import java.nio.file.Path
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * How the images of a file slide, which no format says: the velocity V of the image one box along [normalAxis] fits
 * the displacements o of images in the states, V (t − t₀) = o − o₀ up to whole boxes. Which whole number of boxes it is,
 * the velocities of the particles tell, whose gradient times the box is about V.
 *
 * @property rate shear rate, V over the box; 0 where images stand still, or where nothing tells it
 * @property from what it follows from
 */
internal class Slide private constructor(
    val normalAxis: Int,
    val slideAxis: Int,
    val rate: Double,
    private val from: From,
) {
    private enum class From { LEAN, UPRIGHT, SLOWEST, VELOCITIES, NOTHING }

    /** Whether images slide, at a rate that may not be known. */
    val isMoving: Boolean get() = rate != 0.0 || from == From.NOTHING

    /** One line about the file at [path]. */
    fun words(path: Path): String {
        val way = "along ${"xyz"[slideAxis]} across ${"xyz"[normalAxis]}"
        if (!isMoving) return "$path: the box leans $way, and no flow is seen: images are taken to stand still"
        val number = "%.6g".format(java.util.Locale.ROOT, rate)
        val from = when (from) {
            From.VELOCITIES -> "about $number, from the velocities of the particles"
            From.LEAN -> "$number, from how far the box leans in each state"
            From.UPRIGHT -> "$number, from the velocities of the particles, as the box is upright in every state"
            From.SLOWEST -> "$number, the slowest with which the box leans as it does in each state"
            From.NOTHING ->
                return "$path: images slide $way, and nothing tells how fast: temperatures are around the " +
                    "line that fits the velocities, and there is no diffusion along it; ${WayOut.GIVE_SCENARIO.words}"
        }
        return "$path: images slide $way, and the file does not say how fast: the shear rate is taken as $from; " +
            WayOut.GIVE_SCENARIO.words
    }

    /** The gradient of the velocities along [slide] across [normal], and its standard error, over the [states]. */
    private class Gradient(states: List<Snapshot>, normal: Int, slide: Int) {
        val value: Double
        val error: Double

        init {
            val each = states.map { of(it.position[normal], it.velocity[slide]) }
            value = each.map { it[0] }.average()
            // States may be as good as the same.
            error = sqrt(each.map { it[1] * it[1] }.average())
        }

        private fun of(y: DoubleArray, v: DoubleArray): DoubleArray {
            val n = y.size
            val middle = y.average()
            val mean = v.average()
            var yy = 0.0
            var yv = 0.0
            for (k in 0 until n) {
                yy += (y[k] - middle) * (y[k] - middle)
                yv += (y[k] - middle) * (v[k] - mean)
            }
            if (n < FEWEST || yy == 0.0) return doubleArrayOf(0.0, 0.0)
            val slope = yv / yy
            var rest = 0.0
            for (k in 0 until n) {
                val r = v[k] - mean - slope * (y[k] - middle)
                rest += r * r
            }
            return doubleArrayOf(slope, sqrt(rest / (n - 2) / yy))
        }
    }

    companion object {
        /** Particles below which velocities tell no gradient. */
        private const val FEWEST = 10

        /** Standard errors within which a velocity must be that of the gradient. */
        private const val WITHIN = 4.0

        /** Standard errors beyond which a gradient is a flow, in a box that does not lean. */
        private const val FLOW = 10.0

        /** The part of a box by which displacements may miss a steady slide. */
        private const val STEADY = 0.01

        /** How images slide in [states]; null when there is no sign that they do. */
        fun of(path: Path, states: List<Snapshot>, hasTimes: Boolean): Slide? {
            val leaning = leaningState(path, states)
            return if (leaning == null) upright(states, hasTimes) else leaning(leaning, states, hasTimes)
        }

        private fun leaning(state: Snapshot, states: List<Snapshot>, hasTimes: Boolean): Slide {
            val normal = state.normalAxis
            val slide = state.slideAxis
            val knowsFlow = states.all { it.hasVelocity }
            val gradient = Gradient(states, normal, slide)
            val exact = if (hasTimes && knowsFlow) fitted(states, normal, slide, gradient) else null
            if (exact != null) return Slide(normal, slide, exact, From.LEAN)
            val isFlow = knowsFlow && abs(gradient.value) > WITHIN * gradient.error
            if (isFlow) return Slide(normal, slide, gradient.value, From.VELOCITIES)
            if (!isChanging(states, normal, slide)) return Slide(normal, slide, 0.0, From.LEAN)
            // Where velocities are there and do not tell whole boxes apart, the slowest rate may be off by some.
            val slowest = if (hasTimes && !knowsFlow && states.size > 2) fitted(states, normal, slide, null) else null
            return Slide(normal, slide, slowest ?: 0.0, if (slowest == null) From.NOTHING else From.SLOWEST)
        }

        /** Whether images are displaced otherwise, by more than whole boxes, in one state than in another. */
        private fun isChanging(states: List<Snapshot>, normal: Int, slide: Int): Boolean {
            val first = offset(states[0], normal) / states[0].lengths[slide]
            return states.any { abs(Math.IEEEremainder(offset(it, normal) / it.lengths[slide] - first, 1.0)) > STEADY }
        }

        private fun offset(state: Snapshot, normal: Int) = if (state.normalAxis == normal) state.shearOffset else 0.0

        /** Images may have slid by whole boxes in every state. */
        private fun upright(states: List<Snapshot>, hasTimes: Boolean): Slide? {
            if (!hasTimes || states.size < 2 || states.any { !it.hasVelocity }) return null
            return flows(states).firstNotNullOfOrNull { (normal, slide, gradient) ->
                val rate = fitted(states, normal, slide, gradient)
                if (rate == null || rate == 0.0) null else Slide(normal, slide, rate, From.UPRIGHT)
            }
        }

        /**
         * What to say of the file at [path] where velocities change across a box as they do where images slide, and
         * nothing tells whether they do; null for nothing.
         */
        fun doubt(path: Path, states: List<Snapshot>): String? {
            val (normal, slide, gradient) = flows(states).firstOrNull() ?: return null
            val number = "%.3g".format(java.util.Locale.ROOT, gradient.value)
            return "$path: velocities along ${"xyz"[slide]} change by $number per unit length across " +
                "${"xyz"[normal]}, and the box does not lean; if images slide, a scenario has to say how"
        }

        /** The axes, across and along, between which a flow is seen that images may follow. */
        private fun flows(states: List<Snapshot>): List<Triple<Int, Int, Gradient>> = (0..5).mapNotNull {
            val normal = it / 2
            val slide = it % 2
            if (slide == normal || states.any { s -> !s.repeats(normal) || !s.repeats(slide) }) return@mapNotNull null
            val gradient = Gradient(states, normal, slide)
            if (abs(gradient.value) > FLOW * gradient.error) Triple(normal, slide, gradient) else null
        }

        /**
         * The rate that fits the displacements; null when none does, or several do.
         *
         * @param gradient that of the velocities; null for the slowest rate that fits
         */
        private fun fitted(states: List<Snapshot>, normal: Int, slide: Int, gradient: Gradient?): Double? {
            if (states.size < 2) return null
            val height = states[0].lengths[normal]
            val length = states[0].lengths[slide]
            if (states.any { it.lengths[normal] != height || it.lengths[slide] != length }) return null
            val error = if (gradient == null) Double.POSITIVE_INFINITY else WITHIN * gradient.error * height
            val base = (1 until states.size).minBy { states[it].time - states[it - 1].time } - 1
            fun offset(k: Int) = offset(states[k], normal)
            var velocity = (gradient?.value ?: 0.0) * height
            val first = states[base + 1].time - states[base].time
            // Whole boxes between two states must be told apart by the velocities of the particles.
            if (gradient != null && 2.5 * error * first > length) return null
            var longest = 0.0
            val others = states.indices.filter { it != base }.sortedBy { abs(states[it].time - states[base].time) }
            for (k in others) {
                val span = states[k].time - states[base].time
                val slid = offset(k) - offset(base)
                val boxes = Math.rint((velocity * span - slid) / length)
                val fits = (slid + boxes * length) / span
                val isNear = if (longest == 0.0) {
                    abs(fits - velocity) <= error + STEADY * length / first
                } else {
                    abs((fits - velocity) * span) <= STEADY * length * maxOf(1.0, abs(span) / longest)
                }
                if (!isNear) return null
                velocity = fits
                longest = abs(span)
            }
            return velocity / height
        }
    }
}
