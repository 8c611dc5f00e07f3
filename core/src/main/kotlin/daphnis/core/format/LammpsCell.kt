package daphnis.core.format

/**
 * The cell of a LAMMPS file: [edges] by row from [origin].
 *
 * @property periodic whether it repeats along x, y, z
 * @property bounded whether it has faces along x, y, z that stay where they are, or fits itself to the particles
 */
internal class LammpsCell(
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
        val leaning = (0..8).filter { it / 3 != it % 3 && edges[it / 3][it % 3] != 0.0 }
        if (leaning.isEmpty()) return -1
        if (leaning.size > 1 || leaning[0] !in SLIDING) {
            fail(
                "the box leans in a way that sliding images do not; only xy, or y of the first edge, may differ from 0",
            )
        }
        return leaning[0] / 3
    }

    companion object {
        private const val ROUND_OFF = 1e-12

        /** Entries of the edges off the diagonal that may be other than 0: x of the second and y of the first. */
        private val SLIDING = setOf(3, 1)

        /** From bounds, along x and tilted by [tilt] = xy, xz, yz. */
        fun of(
            low: DoubleArray,
            high: DoubleArray,
            tilt: DoubleArray,
            periodic: BooleanArray,
            bounded: BooleanArray,
        ): LammpsCell {
            val edges = Array(3) { row -> DoubleArray(3) { if (it == row) high[row] - low[row] else 0.0 } }
            edges[1][0] = tilt[0]
            edges[2][0] = tilt[1]
            edges[2][1] = tilt[2]
            return LammpsCell(low, edges, periodic, bounded)
        }
    }
}
