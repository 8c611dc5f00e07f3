package daphnis.analysis.report

import daphnis.analysis.plot.NamedMarks
import daphnis.analysis.plot.Ticks

/** The rows of a table of what was observed, as a chart and a table name them. */
internal object ObservedRows {
    private const val MOST_NAMES = 8
    private const val BESIDE = 0.4
    private const val PER_DEGREE = 1e10

    /** Some of the rows, by their [angles] in radians. */
    fun marks(angles: List<List<Double>>, most: Int = MOST_NAMES): NamedMarks {
        val n = angles.size
        val shown = (0 until n step (n + most - 1) / most).toList()
        val names = shown.map { k -> angles[k].joinToString { ReportText.short(degrees(it)) } }
        return NamedMarks(Ticks(shown.map { it + 1.0 }, names), 1 - BESIDE, n + BESIDE)
    }

    /** 30 of what was read as 30: the way to radians and back misses by the last digits. */
    fun degrees(radians: Double) = Math.rint(Math.toDegrees(radians) * PER_DEGREE) / PER_DEGREE
}
