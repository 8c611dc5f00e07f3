package daphnis.core.format

import daphnis.core.format.hdf5.Datatype
import daphnis.core.format.hdf5.GrowingDataset
import daphnis.core.format.hdf5.Hdf5File
import java.io.IOException

/**
 * The edges of the box by time, as MDAnalysis requires: lengths, or edge vectors by row when images slide. Which, the
 * last state may decide, so four numbers are kept of each.
 */
internal class H5mdEdges {
    private var numbers = DoubleArray(FIRST * WIDTH)
    private var count = 0
    private var slid = false

    // Which axis slides is that of the first state, for all.
    private var normalAxis = 0
    private var slideAxis = 0

    fun add(state: Snapshot) {
        if (count == 0) {
            normalAxis = state.normalAxis
            slideAxis = state.slideAxis
        }
        if (WIDTH * count == numbers.size) numbers = numbers.copyOf(2 * numbers.size)
        state.lengths.copyInto(numbers, WIDTH * count)
        numbers[WIDTH * count++ + 3] = state.shearOffset
        slid = slid || state.shearOffset != 0.0
    }

    /** A dataset of them in [file]. */
    @Throws(IOException::class)
    fun dataset(file: Hdf5File): GrowingDataset {
        val frame = if (slid) intArrayOf(3, 3) else intArrayOf(3)
        val dataset = GrowingDataset(file, Datatype.DOUBLE, frame, isPacked = false)
        for (t in 0 until count) {
            dataset.append { buffer, _, _ ->
                for (row in 0..2) {
                    if (slid) {
                        vector(
                            t,
                            row,
                        ).forEach(buffer::putDouble)
                    } else {
                        buffer.putDouble(length(t, row))
                    }
                }
            }
        }
        return dataset
    }

    private fun length(t: Int, axis: Int) = numbers[WIDTH * t + axis]

    private fun vector(t: Int, row: Int) = DoubleArray(3) { axis ->
        when {
            axis == row -> length(t, row)
            row == normalAxis && axis == slideAxis -> numbers[WIDTH * t + 3]
            else -> 0.0
        }
    }

    private companion object {
        const val WIDTH = 4
        const val FIRST = 4
    }
}
