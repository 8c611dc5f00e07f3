package daphnis.analysis.report

import java.nio.file.Files

/** The table of numbers, on the page and as `tables/numbers.csv`. */
internal class NumbersSection(private val study: Study) : Section {
    override val heading = "Numbers"
    override val over = if (study.numbers.isFromTransport) {
        "Averages over the rows of transport.csv from time ${study.time(study.from)} on, " +
            "and over ${study.averagedStates}."
    } else {
        study.overAverages
    }

    override fun write(page: ReportPage) {
        val rows = study.numbers.rows()
        val notes = ArrayList<String>()
        if (rows.any { !it.error.isNaN() }) {
            notes += "± is one standard error from block averaging; numbers without it follow from the particles " +
                "themselves or from averages."
        }
        val source = if (study.input.scenario == null) "file" else "scenario"
        if (rows.any { "unit" in it.unit }) notes += "Units without a name are those of the $source."
        if (notes.isNotEmpty()) page.paragraph(notes.joinToString(" "))
        page.numbers(rows)
        Files.createDirectories(study.tables)
        val lines = rows.map {
            val error = if (it.error.isNaN()) "" else it.error
            "${it.what.replace(',', ';')},${it.value},$error,${it.unit},${it.reference?.value ?: ""}"
        }
        Files.write(study.tables.resolve("numbers.csv"), listOf("quantity,value,standard_error,unit,reference") + lines)
    }
}
