package daphnis.core.format

import java.nio.file.Path

/**
 * The box of an H5MD file, by frame or the same for all: a row of lengths, or edge vectors by row.
 *
 * @param isOwn whether daphnis wrote it, which says elsewhere how far the box leans
 */
internal class H5mdBox(private val source: H5Source, all: String, private val path: Path, private val isOwn: Boolean) {
    private val edges = "$all/box/edges"

    /** The lengths of [count] frames; NaN when the file has none. */
    fun lengths(count: Int): List<DoubleArray> {
        if (!source.has(edges)) return List(count) { DoubleArray(3) { Double.NaN } }
        val isFixed = !source.has("$edges/value")
        val name = if (isFixed) edges else "$edges/value"
        val frames = if (isFixed) emptyList() else listOf(count.toLong())
        val isMatrix = source.shape(name).size == frames.size + 2
        val data = source.doubles(name, frames + if (isMatrix) listOf(3L, 3L) else listOf(3L))
        val rows = if (isMatrix) MATRIX else 3
        if (isMatrix && !isOwn) requireStraight(name, data)
        return List(count) { t ->
            val at = if (isFixed) 0 else t * rows
            DoubleArray(3) { data[at + if (isMatrix) 4 * it else it] }
        }
    }

    private fun requireStraight(name: String, data: DoubleArray) {
        for (k in data.indices) {
            val entry = k % MATRIX
            if (entry / 3 == entry % 3 || data[k] == 0.0) continue
            throw FormatException("$path: $name leans; edges must be along x, y and z")
        }
    }

    private companion object {
        const val MATRIX = 9
    }
}
