package daphnis.core.run

import daphnis.core.closeAll
import daphnis.core.input.InputException
import daphnis.core.input.UnitsSpec
import daphnis.core.table.Columns
import daphnis.core.table.UnitsOfDimensions
import java.nio.file.Files
import java.nio.file.Path

/**
 * The tables that outputs of a run write into [directory], and what a checkpoint keeps about them (ADR 33).
 *
 * @param beginnings of tables, by name, to continue from; a table without one starts as a new file
 * @param snapshots checksums of the states that were written before, by step
 * @param units of the scenario, which stand in the heads of new tables; null when nobody knows them
 * @property writer does the writing; closed with this
 * @param clock nanoseconds; rows that have waited for a second are written
 */
internal class RunFiles(
    val directory: RunDirectory,
    private val beginnings: Map<String, Beginning> = emptyMap(),
    val writer: Writer = DirectWriter,
    private val clock: () -> Long = System::nanoTime,
    units: UnitsSpec? = null,
    snapshots: Map<Long, Long> = emptyMap(),
) : AutoCloseable {
    /** What the units of columns are called. */
    val units = UnitsOfDimensions(units)
    private val tables = LinkedHashMap<String, AppendedFile>()
    private val marks = LinkedHashMap<String, FileMark>()

    /** Checksums of the states that were written as snapshots, by step. For the writer. */
    val snapshots: MutableMap<Long, Long> = LinkedHashMap(snapshots)

    /** The marks of files that were written whole since the start. For the writer. */
    val whole: Map<String, FileMark> get() = marks

    /** Opens the table of [columns], which grows row by row and is closed with this. */
    fun table(columns: Columns<*>): AppendedFile {
        val name = columns.file
        val path = directory.path.resolve(name)
        if ((beginnings[name]?.length ?: 0L) > 0L) requireSame(path, columns)
        return AppendedFile(path, columns.header(units), beginnings[name], directory.files, writer, clock).also {
            tables[name] =
                it
        }
    }

    /**
     * A table that another version began would go on with rows of another width. Behind what the checkpoint knows,
     * bytes may be anything, also no characters, so no strict reader of text goes over them.
     */
    private fun requireSame(path: Path, columns: Columns<*>) {
        val header = Files.newInputStream(path).reader().buffered().use { it.readLine() }.orEmpty()
        val there = header.split(',').map { it.substringBefore(" [") }
        if (there != columns.columns.map { it.name }) {
            val what = "has other columns than this version of daphnis writes, so the run cannot go on; begin it anew"
            throw InputException("$path", null, what)
        }
    }

    /** Replaces a small file atomically. */
    fun writeWhole(name: String, bytes: ByteArray) {
        writer.rows(bytes.size.toLong()) {
            directory.files.writeAtomically(directory.path.resolve(name)) { Files.write(it, bytes) }
            marks[name] = FileMark.of(bytes)
        }
    }

    /** To be called after each step: writes rows that have waited for a second. */
    fun flushIfDue() {
        for (table in tables.values) table.flushIfDue()
    }

    /** Hands over all rows. */
    fun flush() {
        for (table in tables.values) table.flush()
    }

    /** Forces all tables to the disk, up to the last [flush]. For the writer. @return their marks, by name */
    fun force(): Map<String, FileMark> = tables.mapValues { it.value.force() }

    override fun close() {
        closeAll(tables.values + writer)
    }
}
