package daphnis.core.format

import java.nio.file.Path

/**
 * The box of an H5MD file, by frame or the same for all: a row of lengths, or edge vectors by row.
 *
 * @param isOwn whether daphnis wrote it, which says elsewhere how far the box leans
 */
internal class H5mdBox(private val source: H5Source, all: String, private val path: Path, private val isOwn: Boolean) {
    private val edges = "$all/box/edges"

    private val hasEdges = source.has(edges)
    private val isFixed = !source.has("$edges/value")
    private val name = if (isFixed) edges else "$edges/value"
    private val isMatrix = hasEdges && source.shape(name).size == (if (isFixed) 2 else 3)

    /** The cells of the frames after [steps]; their lengths are NaN when the file has no edges. */
    fun cells(steps: LongArray, periodic: BooleanArray): List<FileCell> {
        if (!hasEdges) {
            val nowhere = Array(3) { DoubleArray(3) }
            return steps.map { FileCell(DoubleArray(3), nowhere, periodic, BooleanArray(3)) }
        }
        val frames = if (isFixed) emptyList() else source.shape(name).take(1)
        val data = source.doubles(name, frames + if (isMatrix) listOf(3L, 3L) else listOf(3L))
        val rows = places(steps)
        return steps.indices.map { t ->
            val cell = cell(data, rows[t], periodic)
            // Of daphnis' own, the offset of sliding images is beside them.
            if (!isOwn) cell.normalAxis { throw FormatException("$path: frame $t: $name: $it") }
            cell
        }
    }

    private fun cell(data: DoubleArray, row: Int, periodic: BooleanArray): FileCell {
        val at = row * if (isMatrix) MATRIX else 3
        val vectors = Array(3) { a ->
            DoubleArray(3) { b ->
                if (isMatrix) {
                    data[at + 3 * a + b]
                } else if (a == b) {
                    data[at + a]
                } else {
                    0.0
                }
            }
        }
        return FileCell(DoubleArray(3) { -vectors[it][it] / 2 }, vectors, periodic)
    }

    /** The row of the edges for each frame, which may be stored less often than positions, or at other steps. */
    private fun places(steps: LongArray): IntArray {
        if (isFixed) return IntArray(steps.size)
        val count = source.shape(name)[0]
        val stepName = "$edges/step"
        val given = if (source.has(stepName)) source.steps(stepName, Math.toIntExact(count)) else steps
        if (given.size.toLong() != count) {
            throw FormatException("$path: $name has $count frames, positions have ${steps.size}")
        }
        if (given.contentEquals(steps)) return IntArray(steps.size) { it }
        return IntArray(steps.size) { t ->
            given.indexOf(steps[t]).also {
                if (it < 0) throw FormatException("$path: $name has no edges for step ${steps[t]}, of frame $t")
            }
        }
    }

    private companion object {
        const val MATRIX = 9
    }
}
