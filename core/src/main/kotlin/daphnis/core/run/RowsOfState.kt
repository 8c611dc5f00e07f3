package daphnis.core.run

import daphnis.core.format.Snapshot
import daphnis.core.table.Column
import java.nio.file.Files
import java.nio.file.Path

/** One of the rows that a table has of a state, by the names of its columns. */
internal class RowsOfState private constructor(private val names: List<String>, private val row: List<String>) {
    /** The number in [column]; null where there is none. */
    operator fun get(column: Column): Double? = row.getOrNull(names.indexOf(column.name))?.toDoubleOrNull()

    companion object {
        /** Those of the table at [path] whose step is that of [state], and [time] too; none where there is no table. */
        fun read(path: Path, state: Snapshot, time: Column): List<RowsOfState> {
            if (!Files.exists(path)) return emptyList()
            Files.newBufferedReader(path).use { reader ->
                val names = reader.readLine()?.split(',')?.map { it.substringBefore(" [") } ?: return emptyList()
                return reader.lineSequence().filter { it.startsWith("${state.step},") }.map { it.split(',') }
                    .filter { it.size == names.size }.map { RowsOfState(names, it) }
                    .filter { it[time] == state.time }.toList()
            }
        }
    }
}
