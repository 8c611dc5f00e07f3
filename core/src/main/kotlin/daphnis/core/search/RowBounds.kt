package daphnis.core.search

import daphnis.core.api.EngineApi
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.parallel.RangeLoop
import java.lang.invoke.MethodHandles
import java.lang.invoke.VarHandle

/**
 * For each row of a [Grid] the least and greatest velocity, along each axis, that any sphere which started there has
 * had in this step: a closer bound on the places of other spheres than the [Reach], which is the same for all. In a
 * shear flow it moves with the flow.
 *
 * **Why nothing is missed though the bounds grow within the step.** When a collision gives a sphere k a velocity beyond
 * the bounds of its row, the bounds are widened, and only then k searches. A sphere that searches later sees the wider
 * bounds and finds k. A sphere that searched before may have missed the place where k now goes. If it has moved since,
 * it has searched again and finds k from its side; if not, it is where it was, and k's own search finds it.
 */
@EngineApi
public class RowBounds {
    /**
     * Six numbers per row: least and greatest velocity along the row axis, the middle and the slow axis. Least is above
     * greatest where no sphere started.
     */
    internal var values = DoubleArray(0)
        private set

    /**
     * Whether closer bounds are worth their cost in this step: where a search has few candidates, looking up rows costs
     * more than checking spheres.
     */
    public var isInUse: Boolean = false
        private set

    /** Length of the step. */
    internal var duration = 0.0
        private set

    private var rowOf = IntArray(0)
    private var axes = IntArray(3)

    /**
     * Measures the spheres of [rows], which [grid] has sorted, before any has collided.
     *
     * @param fewest the least number of candidates of a search with which the bounds are used
     */
    @JvmOverloads
    public fun measure(
        grid: Grid,
        rows: StepRows,
        duration: Double,
        loop: RangeLoop,
        fewest: Double = WORTH_CANDIDATES,
    ) {
        isInUse = grid.levels.candidates() >= fewest || grid.levels.haveFlow
        if (!isInUse) return
        this.duration = duration
        val levels = grid.levels
        axes = levels[0].axes
        val count = levels.rowCount
        if (values.size < count * WIDTH) values = DoubleArray((count + count / 4) * WIDTH)
        if (rowOf.size < rows.size) rowOf = IntArray(rows.size)
        loop.run(count, ROWS_A_PIECE) { _, from, to ->
            for (row in from until to) {
                val layout = levels[levels.ofRow(row)]
                val cell = layout.firstCell + (row - layout.firstRow) * layout.cells[0]
                measureRow(row, grid.cellStart[cell], grid.cellStart[cell + layout.cells[0]], rows)
            }
        }
    }

    /** There are no rows of cells in this step. */
    internal fun rest() {
        isInUse = false
    }

    private fun measureRow(row: Int, from: Int, to: Int, rows: StepRows) {
        for (slot in from until to) rowOf[slot] = row
        for (k in 0..2) {
            val v = VX + axes[k]
            var low = Double.POSITIVE_INFINITY
            var high = Double.NEGATIVE_INFINITY
            for (slot in from until to) {
                val u = rows.state[slot * STRIDE + v]
                low = Math.min(low, u)
                high = Math.max(high, u)
            }
            values[row * WIDTH + 2 * k] = low
            values[row * WIDTH + 2 * k + 1] = high
        }
    }

    /**
     * Widens the bounds for the velocity in row [place] of [rows], of a sphere whose slot is [slot]. To be called
     * before that sphere searches; any number of threads at once.
     */
    public fun include(slot: Int, rows: StepRows, place: Int) {
        if (!isInUse) return
        val p = rowOf[slot] * WIDTH
        for (k in 0..2) {
            val u = rows.state[place * STRIDE + VX + axes[k]]
            if (u < values[p + 2 * k]) lower(p + 2 * k, u)
            if (u > values[p + 2 * k + 1]) raise(p + 2 * k + 1, u)
        }
    }

    private fun lower(entry: Int, u: Double) {
        while (true) {
            val before = values[entry]
            if (before <= u || ENTRY.compareAndSet(values, entry, before, u)) return
        }
    }

    private fun raise(entry: Int, u: Double) {
        while (true) {
            val before = values[entry]
            if (before >= u || ENTRY.compareAndSet(values, entry, before, u)) return
        }
    }

    internal companion object {
        const val WIDTH = 6

        /** Measured: half the time of a step at 260 candidates, no gain at 40, a loss at 20. */
        const val WORTH_CANDIDATES = 80.0

        /** The same where rows flow together, so that bounds leave a few of them. */
        const val WORTH_IN_FLOW = 20.0
        private const val ROWS_A_PIECE = 32
        private val ENTRY: VarHandle = MethodHandles.arrayElementVarHandle(DoubleArray::class.java)
    }
}
