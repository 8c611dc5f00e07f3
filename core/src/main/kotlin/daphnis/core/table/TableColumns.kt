@file:JvmName("NeededColumns")

package daphnis.core.table

import java.util.function.ToDoubleFunction
import java.util.function.ToLongFunction

/** The columns of a file that runs write. */
public interface TableColumns {
    /** Name of the file in the run directory. */
    public val file: String

    /** The columns in the order of the file. */
    public val columns: List<Column>
}

/** Names of the columns without which a file is not such a table. */
@get:JvmName("of")
public val TableColumns.needed: List<String> get() = columns.filter { it.need == Need.NEEDED }.map { it.name }

/**
 * The columns of [file], each with how it is computed from a [Row]. They are in the file in the order of declaration.
 * Writing allocates only what the line grows by.
 */
internal class Columns<Row>(override val file: String) : TableColumns {
    private val cells = ArrayList<Cell<Row>>()
    override val columns = ArrayList<Column>()

    /** The first line of the file: names, each with its unit. */
    fun header(units: UnitsOfDimensions): String =
        columns.joinToString(",") { UnitsOfDimensions.head(it.name, units.of(it.dimension)) }

    /** Declares the column of steps. */
    fun step(value: ToLongFunction<Row>): Column = whole("step", "steps since the start of the run", value = value)

    /** Declares the column of times. */
    fun time(value: ToDoubleFunction<Row>): Column =
        number("time", "at the end of the step", Dimension.TIME, Need.NEEDED, value)

    /** Declares the column of the number of spheres. */
    fun particles(value: ToLongFunction<Row>): Column =
        whole("particles", "spheres, bodies included", Need.NEEDED, value)

    /** Declares a column of whole numbers. */
    fun whole(name: String, meaning: String, need: Need = Need.OPTIONAL, value: ToLongFunction<Row>): Column =
        add(Column(name, meaning, Dimension.NUMBER, need)) { line, row -> line.append(value.applyAsLong(row)) }

    /** Declares a column of numbers. */
    fun number(
        name: String,
        meaning: String,
        dimension: String = Dimension.NUMBER,
        need: Need = Need.OPTIONAL,
        value: ToDoubleFunction<Row>,
    ): Column = add(Column(name, meaning, dimension, need)) { line, row -> line.append(value.applyAsDouble(row)) }

    /** Declares a column for each of the components [names] of a quantity, of which those in [needed] are needed. */
    fun each(
        names: List<String>,
        meaning: String,
        dimension: String,
        needed: Set<String> = emptySet(),
        value: Component<Row>,
    ): List<Column> = names.mapIndexed { k, name ->
        number(name, meaning, dimension, if (name in needed) Need.NEEDED else Need.OPTIONAL) { value.of(it, k) }
    }

    /** Component `k` of a quantity of several numbers. */
    fun interface Component<Row> {
        fun of(row: Row, k: Int): Double
    }

    /** The same table without the columns [left]. */
    fun without(left: Set<Column>): Columns<Row> = Columns<Row>(file).also { rest ->
        for (k in cells.indices) if (columns[k] !in left) rest.add(columns[k], cells[k])
    }

    private fun add(column: Column, cell: Cell<Row>): Column {
        columns += column
        cells += cell
        return column
    }

    /** Appends the line of [row], without its end. */
    fun write(row: Row, line: StringBuilder) {
        for (k in cells.indices) {
            if (k > 0) line.append(',')
            cells[k].append(line, row)
        }
    }

    private fun interface Cell<Row> {
        fun append(line: StringBuilder, row: Row)
    }
}
