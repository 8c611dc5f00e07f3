package daphnis.core.engine.horizon

/**
 * The lines that a [LineFilter] has kept, by block of [Lines.LANES]: a mark for each block in which there are any, with
 * the slot of its first line above eight bits, one for each line of the block. Marks of many runs are collected before
 * anybody looks at them, since a branch for each line that is kept would be foreseen wrongly nearly every time.
 */
internal class KeptLines {
    /** Room for marks; [size] of them count. Written by filters, which see to it with [reserve]. */
    @JvmField
    var marks = LongArray(INITIAL)

    @JvmField
    var size = 0

    fun clear() {
        size = 0
    }

    /** Makes room for the marks of a run of so many [lines], and for one that does not count. */
    fun reserve(lines: Int) {
        val most = size + lines + 1
        if (marks.size < most) marks = marks.copyOf(2 * most)
    }

    /** Calls [use] with the slots of the lines, in the order in which they were kept. */
    inline fun forEach(use: (slot: Int) -> Unit) {
        for (k in 0 until size) {
            val mark = marks[k]
            val block = (mark ushr Lines.LANES).toInt()
            var lanes = mark.toInt() and ALL_LANES
            while (lanes != 0) {
                use(block + Integer.numberOfTrailingZeros(lanes))
                lanes = lanes and (lanes - 1)
            }
        }
    }

    companion object {
        const val ALL_LANES = (1 shl Lines.LANES) - 1
        private const val INITIAL = 256
    }
}
