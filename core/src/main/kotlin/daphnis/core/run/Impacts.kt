package daphnis.core.run

import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns
import daphnis.core.table.UnitsOfDimensions

/** Bin [k] of the impact speeds in [statistics]. */
internal class ImpactBin(val statistics: CollisionStatistics, val k: Int)

/** The columns of `impacts.csv`, one row per bin. */
public object ImpactColumns : TableColumns {
    internal val rows = Columns<ImpactBin>("impacts.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val SPEED_FROM: Column = rows.number(
        "speed_from",
        "lower edge of a bin of impact speeds",
        Dimension.SPEED,
        Need.NEEDED,
    ) { CollisionStatistics.binEdge(it.k) }

    @JvmField
    public val SPEED_TO: Column = rows.number(
        "speed_to",
        "its upper edge",
        Dimension.SPEED,
        Need.NEEDED,
    ) { CollisionStatistics.binEdge(it.k + 1) }

    @JvmField
    public val COLLISIONS: Column = rows.whole(
        "collisions",
        "in the bin, since the start",
        Need.NEEDED,
    ) { it.statistics.speeds[it.k] }

    /** The whole file: from the first bin with a collision to the last. */
    internal fun table(statistics: CollisionStatistics, units: UnitsOfDimensions): ByteArray {
        val text = StringBuilder(rows.header(units)).append('\n')
        val filled = statistics.speeds.indices.filter { statistics.speeds[it] > 0 }
        if (filled.isNotEmpty()) {
            for (k in filled.first()..filled.last()) {
                rows.write(ImpactBin(statistics, k), text)
                text.append('\n')
            }
        }
        return text.toString().toByteArray(Charsets.UTF_8)
    }
}
