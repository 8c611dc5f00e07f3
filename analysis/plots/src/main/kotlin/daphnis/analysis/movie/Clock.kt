package daphnis.analysis.movie

import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import java.util.Locale
import kotlin.math.ceil
import kotlin.math.log10

/** The time as it is written on frames: orbits in Hill's frame; with as many digits as tell the [times] apart. */
internal class Clock(private val scale: PlotScale, times: DoubleArray) {
    private val decimals: Int = if (times.size < 2) {
        2
    } else {
        val least = (times.last() - times.first()) / (times.size - 1) / scale.time
        ceil(-log10(least) - 1e-9).takeIf { it.isFinite() }?.toInt()?.coerceIn(0, MOST_DECIMALS) ?: 2
    }

    fun text(time: Double): String {
        val number = String.format(Locale.ROOT, "%.${decimals}f", time / scale.time)
        return "t = " + UnitNames.amount(number, UnitNames.raised(scale.timeName))
    }

    private companion object {
        const val MOST_DECIMALS = 6
    }
}
