package daphnis.analysis.sweep

import daphnis.core.format.WholeFile
import java.io.IOException
import java.nio.file.Path

/** The numbers of a [sweep] as CSV. NaN is an empty cell; one with a comma or a quotation mark is in quotation marks. */
public class SweepTables(private val sweep: Sweep) {
    /**
     * A row for each point and quantity: the values of the keys, then `quantity,unit,mean,standard_error,runs,remark`.
     * `runs` is how many have the number, `remark` says which runs of the point failed and why, and for an average in
     * which of them it is not steady.
     */
    @Throws(IOException::class)
    public fun writeMeans(path: Path) {
        val rows = sweep.points.flatMap { point ->
            fun remark(key: String?) = point.remarks(key).joinToString("; ")
            if (sweep.quantities.isEmpty()) {
                listOf(point.values + listOf("", "", "", "", "0", remark(null)))
            } else {
                sweep.quantities.map {
                    val m = point.mean(it.key)
                    point.values + listOf(it.key, it.unit, text(m.mean), text(m.error), "${m.count}", remark(it.key))
                }
            }
        }
        write(path, sweep.keys + listOf("quantity", "unit", "mean", "standard_error", "runs", "remark"), rows)
    }

    /** A row for each run: its name, the values of the keys, seed, all its numbers, and `remark`. */
    @Throws(IOException::class)
    public fun writeRuns(path: Path) {
        val rows = sweep.runs.map { run ->
            val numbers = sweep.quantities.map { q -> text(run.numbers.find { it.key == q.key }?.value ?: Double.NaN) }
            val remark = run.failure?.let { "failed: $it" } ?: run.remark ?: run.ofSteadiness.orEmpty()
            listOf(run.name) + run.values + "${run.seed}" + numbers + remark
        }
        val names = sweep.quantities.map { if (it.unit.isEmpty()) it.key else "${it.key} [${it.unit}]" }
        write(path, listOf("run") + sweep.keys + "seed" + names + "remark", rows)
    }

    private fun write(path: Path, header: List<String>, rows: List<List<String>>) {
        val lines = (listOf(header) + rows).map { row -> row.joinToString(",") { quoted(it) } }
        WholeFile.write(path, lines.joinToString("\n", postfix = "\n"))
    }

    private fun text(value: Double) = if (value.isNaN()) "" else "$value"

    private fun quoted(cell: String): String {
        val line = cell.replace(Regex("[\\r\\n]+"), " ")
        return if (line.any { it in ",\"" }) "\"${line.replace("\"", "\"\"")}\"" else line
    }
}
