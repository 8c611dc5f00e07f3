package daphnis.app.bench

import daphnis.core.format.FormatException
import daphnis.core.format.WholeFile
import daphnis.core.format.reasonOf
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Timings as CSV: a row for each engine, number of threads and round. */
internal object TimingFile {
    /** What the first version had. */
    private const val FIRST = "scenario,spheres,engine,threads,steps,collisions,round,seconds"
    private const val HEADER = "$FIRST,processor_seconds,java"

    /** Writes [timings] to [path], replacing what is there. */
    fun write(path: Path, timings: List<Timing>) {
        val rows = timings.flatMap { t ->
            t.seconds.mapIndexed { round, s ->
                val work = "${quoted(t.scenario)},${t.spheres},${t.engine},${t.threads},${t.steps},${t.collisions}"
                val processor = t.processorSeconds[round].let { if (it.isNaN()) "" else "$it" }
                "$work,${round + 1},$s,$processor,${t.java}"
            }
        }
        WholeFile.write(path, (listOf(HEADER) + rows).joinToString("\n", postfix = "\n"))
    }

    /**
     * Reads what [write] wrote, or what it wrote before there were processor times.
     *
     * @throws FormatException when it cannot be read, naming the file and the line
     */
    fun read(path: Path): List<Timing> {
        val lines = try {
            Files.readAllLines(path)
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        }
        val header = lines.firstOrNull()
        if (header != HEADER && header != FIRST) {
            throw FormatException("$path: no timings of daphnis bench: $HEADER is missing")
        }
        val columns = header.count { it == ',' } + 1
        val rows = lines.drop(1).mapIndexed { k, line -> row(line, columns, "$path: line ${k + 2}") }
        if (rows.isEmpty()) throw FormatException("$path: has no timings")
        return rows.groupBy { listOf(it.scenario, it.engine, it.threads) }.values.map { same ->
            val t = same.first()
            if (same.any { it.spheres != t.spheres || it.steps != t.steps || it.collisions != t.collisions }) {
                throw FormatException("$path: rounds of ${t.engine} on ${t.scenario} are not of the same steps")
            }
            if (same.any { it.java != t.java }) {
                throw FormatException("$path: rounds of ${t.engine} on ${t.scenario} are not of the same Java")
            }
            val seconds = same.map { it.seconds.single() }
            val processor = same.map { it.processorSeconds.single() }
            Timing(t.scenario, t.spheres, t.engine, t.threads, t.steps, t.collisions, seconds, processor, t.java)
        }
    }

    private fun row(line: String, columns: Int, where: String): Timing {
        val cells = cells(line)
        if (cells.size != columns) throw FormatException("$where: has ${cells.size} cells; $columns are needed")
        fun bad(k: Int): Nothing = throw FormatException("$where: '${cells[k]}' is no number that can stand there")
        fun whole(k: Int) = cells[k].toLongOrNull()?.takeIf { it >= 0 } ?: bad(k)
        fun small(k: Int) = whole(k).takeIf { it <= Int.MAX_VALUE }?.toInt() ?: bad(k)
        whole(6)
        val seconds = cells[7].toDoubleOrNull()?.takeIf { it > 0 && it.isFinite() } ?: bad(7)
        val processor = cells.getOrElse(PROCESSOR) { "" }.let { cell ->
            if (cell.isEmpty()) Double.NaN else cell.toDoubleOrNull()?.takeIf { it in 0.0..MOST } ?: bad(PROCESSOR)
        }
        val java = cells.getOrElse(JAVA) { "" }
        val (spheres, threads) = small(1) to small(3)
        return Timing(
            cells[0], spheres, cells[2], threads, whole(4), whole(5), listOf(seconds), listOf(processor), java,
        )
    }

    private const val PROCESSOR = 8
    private const val JAVA = 9
    private const val MOST = Double.MAX_VALUE

    /** The name of a scenario may hold anything but a line's end. */
    private fun quoted(text: String): String {
        val line = text.replace(Regex("[\\r\\n]"), " ")
        return if (line.any { it in ",\"" }) "\"${line.replace("\"", "\"\"")}\"" else line
    }

    private fun cells(line: String): List<String> {
        if (!line.startsWith("\"")) return line.split(',')
        var end = 1
        while (end < line.length && (line[end] != '"' || line.getOrNull(end + 1) == '"')) {
            end += if (line[end] == '"') 2 else 1
        }
        val name = line.substring(1, minOf(end, line.length)).replace("\"\"", "\"")
        return listOf(name) + line.drop(end + 1).removePrefix(",").split(',')
    }
}
