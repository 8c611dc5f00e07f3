package daphnis.analysis.transport

import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.run.ImpactColumns
import daphnis.core.table.Column
import java.io.IOException
import java.nio.file.Path

/**
 * The distribution of impact speeds of a run, `impacts.csv`: one row per bin, ascending, in the run's units.
 *
 * @property from lower edge of each bin, > 0
 * @property to upper edge of each bin
 * @property collisions in each bin
 */
public class ImpactTable private constructor(
    public val from: DoubleArray,
    public val to: DoubleArray,
    public val collisions: DoubleArray,
) {
    /** Number of bins. */
    public val size: Int get() = from.size

    public companion object {
        /** Reads [path]. @throws FormatException naming file and line when it is no such file or damaged */
        @JvmStatic
        public fun read(path: Path): ImpactTable {
            val lines = try {
                PackedFile.text(path).lines().drop(1).dropLastWhile { it.isEmpty() }
            } catch (e: IOException) {
                throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
            }
            val rows = lines.mapIndexed { k, line -> row(line) ?: throw damaged(path, k + 2, line) }
            fun column(column: Column) = place(column).let { c -> DoubleArray(rows.size) { rows[it][c] } }
            return ImpactTable(
                column(ImpactColumns.SPEED_FROM),
                column(ImpactColumns.SPEED_TO),
                column(ImpactColumns.COLLISIONS),
            )
        }

        /** This file has had the same columns since there is one, and is read by their places. */
        private fun place(column: Column) = ImpactColumns.columns.indexOf(column)

        private fun row(line: String): DoubleArray? {
            val cells = line.split(',').map { it.toDoubleOrNull() ?: return null }
            if (cells.size != ImpactColumns.columns.size || !cells.all { it.isFinite() }) return null
            val (from, to, collisions) = cells
            return if (from > 0 && to > from && collisions >= 0) cells.toDoubleArray() else null
        }

        private fun damaged(path: Path, number: Int, line: String) = FormatException(
            "$path:$number: is '${line.take(40)}'; it must be two speeds, ascending, and a number of collisions",
        )
    }
}
