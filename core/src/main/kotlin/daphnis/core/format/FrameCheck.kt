package daphnis.core.format

import kotlin.math.abs

/**
 * Whether the numbers of a frame can be a state: what every format promises, asked in one place. Sizes and places are kept so far from the
 * ends of what a double holds that volumes and squared distances neither vanish nor overflow.
 */
internal object FrameCheck {
    /**
     * @param where file, and line or frame, for messages
     * @throws FormatException for the first number that is wrong
     */
    fun check(frame: Frame, where: String) {
        fun must(ok: Boolean, problem: () -> String) {
            if (!ok) throw FormatException("$where: ${problem()}")
        }
        must(frame.time.isFinite()) { "the time is ${frame.time}; it must be a finite number" }
        must(frame.step >= 0) { "the step is ${frame.step}; it must be >= 0" }
        val n = frame.size
        for (k in 0 until n) must(frame.id[k] in 0 until ParticleCsv.MOST_ID) { "id ${frame.id[k]} must be in 0..${ParticleCsv.MOST_ID - 1}" }
        repeated(frame.id)?.let { must(false) { "id $it occurs twice" } }
        for (k in 0 until n) {
            must(frame.radius[k] in LEAST..MOST) { "the radius of particle ${frame.id[k]} is ${frame.radius[k]}; it must be > 0, $LEAST to $MOST" }
            must(frame.mass[k] > 0 && frame.mass[k].isFinite()) { "the mass of particle ${frame.id[k]} is ${frame.mass[k]}; it must be > 0 and finite" }
        }
        box(frame, ::must)
        places(frame, ::must)
    }

    private fun box(frame: Frame, must: (Boolean, () -> String) -> Unit) {
        val widest = if (frame.hasRadius) 2 * (frame.radius.maxOrNull() ?: 0.0) else 0.0
        for (axis in 0..2) {
            val name = "xyz"[axis]
            val length = frame.lengths[axis]
            if (length.isNaN()) continue
            must(length in LEAST..MOST) { "the edge of the box along $name is $length; it must be > 0, $LEAST to $MOST" }
            if (!frame.periodic[axis]) continue
            must(length > widest) { "the edge of the periodic box along $name is $length; it must exceed the largest diameter, $widest" }
        }
        must(abs(frame.shearOffset) <= FARTHEST) { "the offset of sliding images is ${frame.shearOffset}; it must be a number within ±$FARTHEST" }
    }

    private fun places(frame: Frame, must: (Boolean, () -> String) -> Unit) {
        for (axis in 0..2) {
            val name = "xyz"[axis]
            val farthest = if (frame.periodic[axis] && !frame.lengths[axis].isNaN()) frame.lengths[axis] * MOST_BOXES else Double.POSITIVE_INFINITY
            for (k in 0 until frame.size) {
                val p = frame.position[axis][k]
                val v = frame.velocity[axis][k]
                must(abs(p) <= FARTHEST) { "$name of particle ${frame.id[k]} is $p; it must be a number within ±$FARTHEST" }
                must(abs(p) <= farthest) {
                    "$name of particle ${frame.id[k]} is $p, more than $MOST_BOXES boxes of ${frame.lengths[axis]} away; nothing is left of its place within the box"
                }
                must(abs(v) <= FARTHEST) { "v$name of particle ${frame.id[k]} is $v; it must be a number within ±$FARTHEST" }
            }
        }
    }

    private fun repeated(id: IntArray): Int? {
        val sorted = id.copyOf().apply { sort() }
        return (1 until sorted.size).find { sorted[it] == sorted[it - 1] }?.let { sorted[it] }
    }

    /** Bounds on sizes; their cubes are normal numbers. */
    const val LEAST = 1e-100
    const val MOST = 1e100

    /** Bound on coordinates and speeds, whose squares are finite. */
    private const val FARTHEST = 1e150
    private const val MOST_BOXES = 1e9
}
