package daphnis.analysis.report

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import kotlin.math.abs

/** The boxes of the states that are averaged, which a file of another program may change from one to the next. */
internal class Boxes(val boundaries: List<BoundaryConditions>) {
    private val all: List<Box> = boundaries.map { it.box }

    /** Whether an edge of one differs from that of another by more than digits that a file may have lost. */
    val isChanging: Boolean = (0..2).any { axis ->
        all.any { abs(it.length(axis) - all[0].length(axis)) > SAME * all[0].length(axis) }
    }

    /** Mean over the boxes; that of one, to the last bit, where all are the same. */
    val mean: Box = box { of -> all[0].let(of) + all.sumOf { of(it) - of(all[0]) } / all.size }

    /** What is in every box, if anything is: bins over it are nowhere empty because a box ends there. */
    val common: Box = run {
        val low = DoubleArray(3) { axis -> all.maxOf { it.lower(axis) } }
        val high = DoubleArray(3) { axis -> all.minOf { it.upper(axis) } }
        if ((0..2).all { low[it] < high[it] }) Box(low[0], low[1], low[2], high[0], high[1], high[2]) else mean
    }

    /** [words] where boxes differ, else nothing. */
    fun ifChanging(words: String): String = if (isChanging) " The box changes: $words" else ""

    private inline fun box(mean: ((Box) -> Double) -> Double) = Box(
        mean { it.lowerX },
        mean { it.lowerY },
        mean { it.lowerZ },
        mean { it.upperX },
        mean { it.upperY },
        mean { it.upperZ },
    )

    private companion object {
        const val SAME = 1e-6
    }
}
