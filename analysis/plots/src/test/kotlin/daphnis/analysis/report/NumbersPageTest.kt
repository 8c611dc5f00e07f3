package daphnis.analysis.report

import daphnis.core.GeneratedPage
import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files
import kotlin.io.path.name
import kotlin.io.path.readText

/** The pages of the numbers and of the tables of a report are what their declarations say. */
@Tag("jdk-neutral")
class NumbersPageTest {
    private fun section(group: KeyGroup): String {
        val rows = group.keys.joinToString("") {
            GeneratedPage.row("`${it.key}`", it.meaning, it.unit, it.only, it.whence)
        }
        return "## ${group.heading}\n\n${group.runs}.\n\n" +
            GeneratedPage.head("key", "number", "unit", "needs", "source") + rows
    }

    private fun known(): String {
        val rows = KnownNumber.all.joinToString("") {
            GeneratedPage.row(it.state, it.numbers, it.source, it.within, it.bound)
        }
        return KNOWN + GeneratedPage.head("state", "numbers", "source", "within", "bound") + rows
    }

    private fun section(heading: String, tables: List<ReportTable>): String {
        val rows = tables.joinToString("") { GeneratedPage.row("`${it.name}.csv`", it.meaning) }
        val further = tables.filter { it.columns.isNotEmpty() }.joinToString("") { table ->
            val columns = table.columns.joinToString("") { (name, what) -> GeneratedPage.row(name, what) }
            "\n### `${table.name}.csv`\n\n" + GeneratedPage.head("column", "what") + columns
        }
        return "## $heading\n\n" + GeneratedPage.head("file", "what") + rows + further
    }

    @Test
    fun `the page of numbers has what is declared`() {
        val text = (listOf(HEAD) + ReportKeys.groups.map { section(it) } + known()).joinToString("\n")
        GeneratedPage("docs/reference/numbers.md", "Numbers of the report", "`ReportKeys`")
            .check(text, javaClass, "analysis/plots")
    }

    @Test
    fun `the page of tables has what is declared`() {
        val text = (listOf(TABLES) + ReportTables.groups.map { (heading, all) -> section(heading, all) })
        GeneratedPage("docs/reference/tables.md", "Tables of the report", "`ReportTables`")
            .check(text.joinToString("\n"), javaClass, "analysis/plots")
    }

    @Test
    fun `a key with a name of the run is found, and none that is not declared`() {
        assertEquals("partial_temperature_NAME", ReportKeys.of("partial_temperature_ice")?.key)
        assertEquals("temperature_ratio_FIRST_NAME", ReportKeys.of("temperature_ratio_ice_rock")?.key)
        assertEquals("sourceK_rate", ReportKeys.of("source12_rate")?.key)
        for (key in ReportKeys.all) assertEquals(key, ReportKeys.of(key.key))
        assertNull(ReportKeys.of("partial_temperature_"))
        assertNull(ReportKeys.of("sigma_w"))
    }

    @Test
    fun `a table is found by its name, and none that is not declared`() {
        assertEquals("profile-AXIS", ReportTables.of("profile-z")?.name)
        assertEquals("pair-correlation-by-KIND", ReportTables.of("pair-correlation-by-size")?.name)
        assertEquals("pair-correlation", ReportTables.of("pair-correlation")?.name)
        assertNull(ReportTables.of("profile"))
    }

    @Test
    fun `every table that the sources name is declared, and they name every one that is`() {
        val folder = Repository.root.resolve("analysis/plots/src/main/kotlin/daphnis/analysis/report")
        val sources = Files.list(folder).use { all -> all.filter { it.name != "ReportTables.kt" }.toList() }
            .joinToString("\n") { it.readText() }
        val named = Regex("""\bTable\(\s*"([a-z-]+)"""").findAll(sources).map { it.groupValues[1] }.toSet()
        assertTrue(named.size > 30) { "$named" }
        assertEquals(emptyList<String>(), named.filter { ReportTables.of(it) == null })
        val declared = ReportTables.groups.values.flatten().map { it.name }
        val unnamed = declared.filter { name ->
            val begin = name.takeWhile { !it.isUpperCase() }
            listOf("\"$name\"", "\"$name.csv\"", "\"$begin\$").none { it in sources } && name !in BY_KIND
        }
        assertEquals(emptyList<String>(), unnamed)
    }

    private companion object {
        /** Their names are put together. */
        val BY_KIND = setOf("pair-correlation-by-KIND", "structure-factor-by-KIND", "streamlines-KEY")
        val HEAD = """
            |The first column of `tables/numbers.csv`, and columns of `sweep.csv` and `runs.csv`. Keys stay as they are from
            |version to version, whatever the words in the report, so a script looks a number up by its key. Words in
            |capitals stand for a name or number of the run. Units are the scenario's; Ω is the angular speed of the frame,
            |r the mean radius. Averages are over particles, without moonlets (`bodies`). c is the velocity around the
            |measured mean flow, w that around the imposed one ([two velocities](../analysis.md#two-velocities)). How ± are
            |made, and when there is none: [errors](../analysis.md#errors).
            |
        """.trimMargin()
        val KNOWN = """
            |## Known numbers
            |
            |Beside measured numbers the report puts known ones, if everything that decides them is the same: sizes, masses,
            |the restitution law and its scale, the vertical factor, faces, no other forces, bodies or guard that is felt.
            |A difference is given as a part of the reference and in σ, the ± of the run alone, and is "within" or "beyond"
            |what the bound and three of these allow; of a number without ± none is given.
            |
            |
        """.trimMargin()
        val TABLES = """
            |Files in `tables/` of a run that was analysed. The header has units in brackets, an empty cell is NaN, and
            |columns `…_error` are standard errors. A section that is left out writes none. Words in capitals stand for
            |others. What symbols mean: [quantities](../analysis.md#quantities).
            |
        """.trimMargin()
    }
}
