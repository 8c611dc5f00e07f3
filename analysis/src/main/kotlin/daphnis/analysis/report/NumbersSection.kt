package daphnis.analysis.report

import java.nio.file.Files

/** The table of numbers, on the page and as `tables/numbers.csv`. */
internal class NumbersSection(private val study: Study) : Section {
    override val heading = "Numbers"
    override val over = if (study.numbers.isFromTransport) {
        "Averages over the rows of transport.csv from time ${study.time(study.from)} on, and over ${study.averagedStates}."
    } else {
        study.overAverages
    }

    override fun write(page: ReportPage) {
        val rows = study.numbers.rows()
        val errors = "± is one standard error from block averaging; numbers without it follow from the particles themselves or from averages."
        val unnamed = "Units without a name are those of the ${if (study.input.scenario == null) "file" else "scenario"}."
        val notes = listOf(errors.takeIf { rows.any { !it.error.isNaN() } }, unnamed.takeIf { rows.any { "unit" in it.unit } })
        notes.filterNotNull().joinToString(" ").let { if (it.isNotEmpty()) page.paragraph(it) }
        page.numbers(rows)
        Files.createDirectories(study.tables)
        val lines = rows.map { "${it.what.replace(',', ';')},${it.value},${if (it.error.isNaN()) "" else it.error},${it.unit},${it.reference?.value ?: ""}" }
        Files.write(study.tables.resolve("numbers.csv"), listOf("quantity,value,standard_error,unit,reference") + lines)
    }
}
