package daphnis.core.table

import daphnis.core.GeneratedPage
import daphnis.core.run.PeriodicOutputs
import daphnis.core.run.SeriesColumns
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** `docs/reference/columns.md` is made of the declarations of the columns that runs write. */
@Tag("jdk-neutral")
class ColumnsPageTest {
    private val tables = PeriodicOutputs.all.flatMap { it.tables }

    /** All that there can be; those of a material and of a source once. */
    private fun columns(table: TableColumns): List<Column> = if (table == SeriesColumns) {
        SeriesColumns.of(true, listOf("NAME"), true, ALL_FACES, true, 1).columns
    } else {
        table.columns
    }

    /** A row for those next to each other that have the same meaning. */
    private fun rows(columns: List<Column>): String {
        val groups = ArrayList<MutableList<Column>>()
        for (column in columns) {
            val last = groups.lastOrNull()?.last()
            if (last != null && column.meaning == last.meaning && column.dimension == last.dimension) {
                groups.last() += column
            } else {
                groups += arrayListOf(column)
            }
        }
        return groups.joinToString("") { group ->
            val dimension = group[0].dimension.replace("^2", "²").replace("^3", "³")
            GeneratedPage.row(group.joinToString { "`${it.name}`" }, dimension, group[0].meaning)
        }
    }

    private fun section(table: TableColumns) = "## `${table.file}`\n\n" +
        GeneratedPage.head("column", "dimension", "what") + rows(columns(table)) +
        NOTES[table.file]?.let { "\n$it\n" }.orEmpty()

    @Test
    fun `the page has every column that is declared`() {
        assertTrue(NOTES.keys.all { file -> tables.any { it.file == file } })
        val text = (listOf(HEAD) + tables.map { section(it) } + ENERGY).joinToString("\n")
        GeneratedPage("docs/reference/columns.md", "Columns of the tables of a run", "the declarations of the columns")
            .check(text, javaClass, "core")
    }

    @Test
    fun `every column has a name of its own in its table and a meaning`() {
        for (table in tables) {
            val columns = columns(table)
            assertEquals(columns.map { it.name }.distinct(), columns.map { it.name }) { table.file }
            assertEquals(emptyList<Column>(), columns.filter { it.meaning.isBlank() || it.meaning.endsWith('.') })
            assertTrue(columns.containsAll(table.columns)) { table.file }
        }
    }

    private companion object {
        val ALL_FACES = (0..5).toSet()
        val HEAD = """
            |What tables in a [run directory](../runs.md#the-run-directory) have, in the scenario's units. The head of a
            |column is its name and its unit, `time [s]`, or `time [units of time]` where the scenario does not know its
            |units; pure numbers have none. Every engine and every number of threads writes the same digits. `NaN` marks
            |a quantity which has no meaning. What symbols mean: [quantities](../analysis.md#quantities).
            |
        """.trimMargin()
        val NOTES = mapOf(
            "series.csv" to """
                |See [materials](../physics.md#materials), of which NAME is one, [growth](../scenario.md#growth),
                |[pistons](../scenario.md#walls), [interactions](../scenario.md#interactions),
                |[sources](../scenario.md#sources-and-sinks) and [energies](#energy).
            """.trimMargin(),
            "transport.csv" to """
                |`kinetic_…` gives the kinetic part of the pressure tensor, `virial_…` the collisional part. See
                |[rough spheres](../physics.md#rough-spheres), [walls](../scenario.md#walls) and
                |[gases at rest](../analysis.md#transport-coefficients-of-a-gas-at-rest).
            """.trimMargin(),
            "modes.csv" to """
                |A mode of q is 2 ⟨(q − ⟨q⟩) exp(−i k x)⟩ over the particles, by mass; the row of m = 0 has ⟨q⟩. So the
                |sum of `re` cos k x − `im` sin k x over all modes is (q − ⟨q⟩) Σ/⟨Σ⟩, Σ the surface density. That is
                |about q − ⟨q⟩ in waves of small amplitude only: in steep ones crests of Σ count more, and v_x itself is
                |smaller. x is 0 in the middle of the box. A wave that goes outward has a phase atan2(`im`, `re`) that
                |falls with time. c of the local temperature is around the field of all these modes, but for c_z, so
                |`temperature_re` of m = 0 is ⟨c²⟩/3 without the waves, up to what is steeper than the modes
                |([ADR 142](../adr/0142-modes-are-summed-in-the-run.md)). In Lees–Edwards boxes modes are along y.
            """.trimMargin(),
            "bodies.csv" to """
                |Orbit elements use Ω, κ and ν of the frame, and are NaN without one. A push P moves the guiding centre
                |by 2 P Ω/(m κ²), and free motion does not, so `gravity_push` is what the change of `guiding_x` leaves
                |to explain.
            """.trimMargin(),
        )
        val ENERGY = """
            |## Energy
            |
            |`granular_temperature` is `temperature` of the summary, (`c_xx` + `c_yy` + `c_zz`)/3 in `transport.csv`, and
            |the temperature of the report. `rms_component_speed`, the paper's measure, contains the mean flow
            |and the bodies, so it is not a temperature.
            |
            || force | its part of `potential_energy` |
            ||---|---|
            || uniform acceleration a | −Σ m a·r, 0 at the origin; NaN if the box repeats along a: spheres fall for ever |
            || self-gravity | ½ Σ m Φ with images, 0 where the force ends; 2 % too shallow in `self-gravity-wakes` by its opening angle |
            || body gravity | Σ over pairs, nearest images |
            || satellite | of the satellite at its position at that time, without images |
            || interactions | of all pairs within an edge; 0 for bridges |
            |
            |What is conserved:
            |
            |- `total_energy`, by elastic collisions and at edges of stepped potentials, by gravity between spheres as well
            |  as the step and the opening angle allow, and by uniform gravity to round-off, with elastic walls at rest too.
            |  Where walls move or are thermal it grows by `wall_work` of `transport.csv` less `dissipated`.
            |- `hill_energy` of free particles, to round-off, until one is wrapped radially: the work of the shear s is
            |  ±m ½ (s/Ω) κ² (L X ∓ L²/2), X the guiding centre; ¾Ω²L X ∓ ⅜Ω²L² around a point mass.
            |
            |A satellite that drifts past does work too.
            |
        """.trimMargin()
    }
}
