package daphnis.core.format

/**
 * The box of a text file: [edges] by row from [origin].
 *
 * @property periodic whether it repeats along x, y, z
 * @property bounded whether it has faces along x, y, z that stay where they are, or fits itself to the particles
 */
internal class FileCell(
    val origin: DoubleArray,
    val edges: Array<DoubleArray>,
    val periodic: BooleanArray,
    val bounded: BooleanArray = BooleanArray(3) { true },
) {
    /** Edges along the axes; NaN where there are no faces. */
    val lengths: DoubleArray get() = DoubleArray(3) { if (bounded[it]) edges[it][it] else Double.NaN }

    /** What [position] has to be moved by so that the box is centred on the origin; no more than round-off is 0. */
    fun centre(axis: Int): Double {
        if (!bounded[axis]) return 0.0
        val shift = origin[axis] + edges[axis][axis] / 2
        return if (Math.abs(shift) > ROUND_OFF * edges[axis][axis]) shift else 0.0
    }

    /** The place of scaled coordinates. */
    fun place(scaled: DoubleArray, axis: Int): Double =
        origin[axis] + scaled[0] * edges[0][axis] + scaled[1] * edges[1][axis] + scaled[2] * edges[2][axis]

    /**
     * @return the axis across which images slide, or −1 when no edge leans
     * @param fail refuses a cell that leans in another way than sliding images do
     */
    fun normalAxis(fail: (String) -> Nothing): Int {
        val leaning = leaning()
        if (leaning.isEmpty()) return -1
        if (leaning.size > 1 || leaning[0] % 3 == 2) {
            fail("the box leans in a way that sliding images do not; only one of its edges may lean, along x or y")
        }
        return leaning[0] / 3
    }

    /** The axis along which images slide across [normal]; x when they do not. */
    fun slideAxis(normal: Int): Int = if (normal < 0) 0 else leaning().first() % 3

    /** Entries of the edges off the diagonal that are more than round-off. */
    private fun leaning() = (0..8).filter {
        it / 3 != it % 3 && Math.abs(edges[it / 3][it % 3]) > ROUND_OFF * Math.abs(edges[it % 3][it % 3])
    }

    companion object {
        private const val ROUND_OFF = 1e-12

        /** Open space. */
        fun open(): FileCell = FileCell(DoubleArray(3), Array(3) { DoubleArray(3) }, BooleanArray(3), BooleanArray(3))

        /** From bounds, along x and tilted by [tilt] = xy, xz, yz. */
        fun of(
            low: DoubleArray,
            high: DoubleArray,
            tilt: DoubleArray,
            periodic: BooleanArray,
            bounded: BooleanArray,
        ): FileCell {
            val edges = Array(3) { row -> DoubleArray(3) { if (it == row) high[row] - low[row] else 0.0 } }
            edges[1][0] = tilt[0]
            edges[2][0] = tilt[1]
            edges[2][1] = tilt[2]
            return FileCell(low, edges, periodic, bounded)
        }
    }
}

/** By how much the image one box along [normalAxis] is displaced along [slideAxis]. */
internal class Lean(val offset: Double, val normalAxis: Int, val slideAxis: Int) {
    companion object {
        /** That of a [cell] of which one edge may lean. */
        fun of(cell: FileCell): Lean {
            val normal = cell.normalAxis { throw IllegalArgumentException(it) }
            val slide = cell.slideAxis(normal)
            return if (normal < 0) Lean(0.0, 1, 0) else Lean(cell.edges[normal][slide], normal, slide)
        }
    }
}
