package daphnis.analysis.report

import java.nio.file.Files

/** The table of numbers, on the page and as `tables/numbers.csv`; [further] rows come last. */
internal class NumbersSection(private val study: Study, private val further: List<NumberRow>) : Section {
    override val heading = "Numbers"
    override val over = if (study.numbers.isFromTransport) {
        "Averages over the rows of transport.csv from time ${study.time(study.from)} on, " +
            "and over ${study.averagedStates}."
    } else {
        study.overAverages
    }

    override fun write(page: ReportPage) {
        val rows = study.numbers.rows() + further
        val notes = ArrayList<String>()
        if (rows.any { !it.error.isNaN() }) {
            notes += "± is one standard error; numbers without it follow from the particles themselves."
        }
        val source = if (study.input.scenario == null) "file" else "scenario"
        if (rows.any { "unit" in it.unit }) notes += "Units without a name are those of the $source."
        if (notes.isNotEmpty()) page.paragraph(notes.joinToString(" "))
        for (line in study.numbers.steadiness()) page.paragraph(line)
        page.numbers(rows)
        Files.createDirectories(study.tables)
        val lines = rows.map {
            val error = if (it.error.isNaN()) "" else it.error
            val remark = if (it.isUncertain) "too few independent states" else ""
            "${it.what.replace(',', ';')},${it.value},$error,${it.unit},${it.reference?.value ?: ""},$remark"
        }
        val header = "quantity,value,standard_error,unit,reference,remark"
        Files.write(study.tables.resolve("numbers.csv"), listOf(header) + lines)
    }
}
