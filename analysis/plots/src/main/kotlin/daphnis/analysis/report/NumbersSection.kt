package daphnis.analysis.report

import daphnis.core.format.WholeFile
import java.nio.file.Files
import kotlin.math.PI

/** The table of numbers, on the page and as `tables/numbers.csv`; the rows of the [others] come last. */
internal class NumbersSection(private val study: Study, private val others: List<Section>) : Section {
    override val heading = "Numbers"
    override val over = study.overMotion

    override fun numbers(): List<NumberRow> =
        study.input.frequencies?.let { RingNumbers(study, it).rows() } ?: BoxNumbers(study).rows()

    /** All rows of the table; without errors where the run is not steady. */
    fun rows(): List<NumberRow> = study.judgement.shown(numbers() + others.flatMap { it.numbers() })

    override fun write(page: ReportPage) {
        val rows = rows()
        for (line in RunWarnings.of(study, rows)) page.paragraph(line)
        val notes = ArrayList<String>()
        if (rows.any { !it.error.isNaN() }) {
            notes +=
                "± is one standard error; numbers without it and without a mark follow from the particles and the " +
                "box themselves, or are conserved."
            if (study.physics?.particles?.sizes?.isContinuous == true) notes += DRAWN
        }
        val source = if (study.input.scenario == null) "file" else "scenario"
        if (rows.any { "unit" in it.unit }) notes += "Units without a name are those of the $source."
        if (notes.isNotEmpty()) page.paragraph(notes.joinToString(" "))
        for (line in steadiness()) page.paragraph(line)
        PerturbedSheet.remark(study)?.let(page::paragraph)
        page.numbers(rows)
        RunSection.longer(study, rows)?.let(page::paragraph)
        Files.createDirectories(study.tables)
        val lines = rows.map {
            val error = if (it.error.isNaN()) "" else it.error
            val remark = it.unknown?.remark.orEmpty()
            val reference = it.reference
            "${checkNotNull(it.key) { it.name }},${it.value},$error,${it.unit},${reference?.value ?: ""},$remark," +
                "${reference?.bound ?: ""}"
        }
        val header = "quantity,value,standard_error,unit,reference,remark,reference_bound"
        WholeFile.write(
            study.tables.resolve("numbers.csv"),
            (listOf(header) + lines).joinToString("\n", postfix = "\n"),
        )
    }

    /** Whether the averages are over a steady time, in sentences. */
    private fun steadiness(): List<String> {
        if (study.isGrowing) return listOf(Growth.remark(study))
        val orbit = study.input.omega?.let { 2 * PI / it }
        val unit = if (orbit != null) "orbit" else "unit of time"
        val text = SteadinessText(
            study.from,
            unit,
            orbit ?: 1.0,
            FreeCooling.isSeen(study.input),
            Unsteady.advice(study),
            Unsteady.growth(study),
        )
        return listOfNotNull(if (study.isStartFound) text.found() else null) + text.of(study.judgement.histories)
    }

    private companion object {
        const val DRAWN = "It is for the radii of this run: another seed draws others, so numbers of runs scatter more."
    }
}
