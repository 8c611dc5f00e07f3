package daphnis.core.format

import java.nio.file.Path

/** Steps and times of the frames of an H5MD file: listed, or in fixed intervals. Without steps frames are counted. */
internal class H5mdTimes(private val source: H5Source, private val all: String, private val path: Path) {
    private val hasValues = source.has("$all/position/value")

    /** Whether the file has times; without, those of [times] are the steps. */
    val areKnown: Boolean = source.has("$all/position/time") || !hasValues

    fun steps(): LongArray {
        val name = "$all/position/step"
        if (!source.has(name) && hasValues) return LongArray(frames()) { it.toLong() }
        if (!source.isScalar(name)) return source.longs(name, one(name))
        return source.steps(name, frames())
    }

    /** Refuses what is stored at other [steps] than positions: it would be of other moments. */
    fun requireSame(part: String, steps: LongArray) {
        val name = "$all/$part/step"
        if (!source.has(name)) return
        val own = source.steps(name, steps.size)
        val k = steps.indices.find { own[it] != steps[it] } ?: return
        fail("$name is ${own[k]} in frame $k, where positions are of step ${steps[k]}")
    }

    /** @param steps of the same frames */
    fun times(steps: LongArray): DoubleArray {
        val name = "$all/position/time"
        if (!areKnown) return DoubleArray(steps.size) { steps[it].toDouble() }
        if (!source.isScalar(name)) return source.doubles(name, listOf(steps.size.toLong()))
        val interval = source.doubles(name, emptyList())[0]
        val offset = source.offset(name, "offset")
        return DoubleArray(steps.size) { offset + it * interval }
    }

    /** The number of frames, of which each has at least a number in the file. */
    private fun frames(): Int {
        val name = "$all/position/value"
        val shape = source.shape(name)
        val frames = shape.firstOrNull() ?: fail("$name has no axis")
        if (shape.any { it <= 0L }) fail("$name has the shape $shape; it must be [frames, particles, 3]")
        source.requireSize(name)
        return if (frames <= Int.MAX_VALUE) frames.toInt() else fail("$name has $frames frames")
    }

    /** The shape of [name], which must have one axis. */
    private fun one(name: String): List<Long> {
        val shape = source.shape(name)
        if (shape.size != 1) fail("$name has ${shape.size} axes; it must have 1, one number per frame")
        return shape
    }

    private fun fail(problem: String): Nothing = throw FormatException("$path: $problem")
}
