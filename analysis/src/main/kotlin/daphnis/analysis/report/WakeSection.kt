package daphnis.analysis.report

import daphnis.analysis.correlation.WavePattern
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import java.nio.file.Path
import kotlin.math.PI

/** Pitch angle and radial spacing of wakes, where there are any, beside Toomre's critical wavelength. */
internal class WakeSection(
    private val input: AnalysisInput,
    private val measures: ReportAverages,
    private val numbers: Numbers,
    private val tables: Path,
) {
    private val units = input.units

    fun write(page: ReportPage) {
        val pattern = WavePattern.of(measures.autocorrelations, measures.lagX, measures.lagY, measures.dx, measures.dy)
        table(pattern)
        if (pattern == null) {
            page.paragraph(
                "No pitch angle and no spacing of wakes: no single wave of the surface density stands out yet of those of its length in other directions.",
            )
            return
        }
        val critical = numbers.criticalWavelength
        val rows = ArrayList<NumberRow>()
        val pitch = scaled(pattern.pitch, 180 / PI)
        rows +=
            NumberRow(
                "pitch angle of the wakes",
                pitch.mean,
                pitch.error,
                "degrees",
                note = "from the orbit, trailing positive",
            )
        rows += NumberRow("radial spacing of the wakes", pattern.spacing.mean, pattern.spacing.error, units.length)
        if (!critical.isNaN()) {
            val ratio = scaled(pattern.spacing, 1 / critical)
            rows +=
                NumberRow(
                    "radial spacing over Toomre's critical wavelength",
                    ratio.mean,
                    ratio.error,
                    "",
                    note = "4π² G Σ/Ω²",
                )
        }
        page.numbers(rows)
    }

    private fun scaled(a: BlockAverage, factor: Double) = BlockAverage(a.mean * factor, a.error * factor, a.count)

    private fun table(pattern: WavePattern?) {
        fun one(value: Double?) = doubleArrayOf(value ?: Double.NaN)
        Table(
            "wakes",
            listOf(
                Column("pitch", "degrees", one(pattern?.let { Math.toDegrees(it.pitch.mean) })),
                Column("pitch_error", "degrees", one(pattern?.let { Math.toDegrees(it.pitch.error) })),
                Column("spacing", units.length, one(pattern?.spacing?.mean)),
                Column("spacing_error", units.length, one(pattern?.spacing?.error)),
                Column("critical_wavelength", units.length, one(numbers.criticalWavelength)),
            ),
        ).write(tables)
    }
}
