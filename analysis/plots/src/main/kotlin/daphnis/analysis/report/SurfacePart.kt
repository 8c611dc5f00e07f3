package daphnis.analysis.report

import daphnis.analysis.correlation.CentralRidge
import daphnis.analysis.correlation.SurfaceMap
import daphnis.analysis.correlation.WavePattern
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import kotlin.math.PI

/**
 * The autocorrelation of the surface density of what lies in a layer, of lags up to half the patch; in Hill's frame also pitch angle and radial
 * spacing of wakes, where there are any, beside Toomre's critical wavelength.
 */
internal class SurfacePart(private val study: Study) : Part {
    private val units = study.units
    private val box = study.boxes.mean
    private val cell: Double =
        maxOf(2 * study.bulk.typicalRadius, maxOf(box.length(0), box.length(1)) / MOST_CELLS)

    // As many cells in every state: their maps are averaged, also where the box changes.
    private val nx = cells(0)
    private val ny = cells(1)
    private val lagX = nx / 2
    private val lagY = ny / 2
    private val dx = box.length(0) / nx
    private val dy = box.length(1) / ny
    private val autocorrelations = ArrayList<DoubleArray>()
    private val pattern by lazy { WavePattern.of(autocorrelations, lagX, lagY, dx, dy) }
    private val ridge by lazy {
        if (pattern == null) CentralRidge.of(autocorrelations, lagX, lagY, dx, dy) else null
    }

    /** Without it nothing makes wakes, though clumps may look so. */
    private val hasGravity get() = study.input.scenario == null || study.bulk.criticalWavelength > 0

    private fun cells(axis: Int) = Math.rint(box.length(axis) / cell).toInt().coerceAtLeast(1)

    /** A box that is filled, or a bed in it, has no surface to look down on; of a file nobody knows. */
    private val isLayer = study.isRing || study.last.boundary.space.isPlane || study.input.scenario == null

    override fun add(state: State) {
        if (!isLayer) return
        autocorrelations += SurfaceMap.of(state, nx, ny).autocorrelation(lagX, lagY)
    }

    override fun write(page: ReportPage) {
        if (autocorrelations.isEmpty() || lagX < 2 || lagY < 2) return
        autocorrelation(page)
        if (study.isRing) wakes(page)
    }

    private fun autocorrelation(page: ReportPage) {
        val count = autocorrelations.size
        val a = DoubleArray(autocorrelations[0].size) { k -> autocorrelations.sumOf { it[k] } / count }
        val x = DoubleArray(2 * lagX + 1) { (it - lagX) * dx }
        val y = DoubleArray(2 * lagY + 1) { (it - lagY) * dy }
        // The centre is the noise of counting and would hide the rest.
        val shown = a.copyOf().also { it[lagX * y.size + lagY] = 0.0 }
        val figure = Chart.map(
            x,
            y,
            shown,
            UnitNames.axis("Δy", units.length),
            UnitNames.axis("Δx", units.length),
            "autocorrelation A",
        )
        val caption = "Autocorrelation A of the surface density, ⟨δΣ δΣ⟩/⟨Σ⟩², the centre left out." +
            study.boxes.ifChanging("lags are parts of each box, given in the mean one.") +
            if (study.mayFreeze) ProfilesSection.PLANES else ""
        study.draw(page, figure, "autocorrelation", "autocorrelation of the surface density", caption, HEIGHT)
        Table(
            "autocorrelation",
            listOf(
                Column("dx", units.length, DoubleArray(a.size) { x[it / y.size] }),
                Column("dy", units.length, DoubleArray(a.size) { y[it % y.size] }),
                Column("A", "", a),
            ),
        ).write(study.tables)
    }

    private fun wakes(page: ReportPage) {
        table()
        if (pattern == null && hasGravity) {
            page.paragraph(
                "No pitch angle and no spacing of wakes: the strongest wave of the surface density goes along the " +
                    "orbit, is about as long as the patch is wide, or is no stronger than those in other directions.",
            )
        }
        val rows = rows()
        if (rows.isNotEmpty()) {
            page.numbers(rows)
            page.paragraph(ASSUMED)
        }
        smallPatch()?.let { page.paragraph(it) }
    }

    /** Of the wakes, or of the central ridge where they are no wave; none in a box, or where neither is seen. */
    fun rows(): List<NumberRow> {
        if (!study.isRing || autocorrelations.isEmpty()) return emptyList()
        val rows = NumberRows()
        pattern?.let { ofWave(rows, it) } ?: ridge?.takeIf { hasGravity }?.let {
            val note = "from the orbit, trailing positive; where A falls off most slowly"
            rows.average(null, "pitch angle of the central ridge of A", it.pitch * (180 / PI), "degrees", note)
        }
        return study.judgement.shown(rows.list())
    }

    private fun ofWave(rows: NumberRows, wave: WavePattern) {
        val (pitch, spacing) = wave.pitch to wave.spacing
        val note = "from the orbit, trailing positive"
        rows.average(null, "pitch angle of the wakes", pitch * (180 / PI), "degrees", note)
        rows.average(null, "radial spacing of the wakes", spacing, units.length)
        val critical = study.bulk.criticalWavelength
        if (critical.isNaN()) return
        val name = "radial spacing over Toomre's critical wavelength"
        rows.average(null, name, spacing * (1 / critical), "", "4π² G Σ/κ²")
    }

    /** How many critical wavelengths the patch is long, with self-gravity. */
    private fun smallPatch(): String? {
        val wavelength = study.bulk.criticalWavelength
        if (!(wavelength > 0)) return null
        val fits = (0..1).map { box.length(it) / wavelength }
        val said = "The patch is ${fits.joinToString(" × ") { ReportText.short(it) }} critical wavelengths large"
        return if (fits.min() < 1) {
            "$said: it has no room for one wake, and what it does is decided by its size. $ENOUGH"
        } else {
            "$said. $ENOUGH"
        }
    }

    private fun table() {
        fun one(value: Double?) = doubleArrayOf(value ?: Double.NaN)
        Table(
            "wakes",
            listOf(
                Column("pitch", "degrees", one(pattern?.let { Math.toDegrees(it.pitch.mean) })),
                Column("pitch_error", "degrees", one(pattern?.let { Math.toDegrees(study.judgement.error(it.pitch)) })),
                Column("spacing", units.length, one(pattern?.spacing?.mean)),
                Column("spacing_error", units.length, one(pattern?.let { study.judgement.error(it.spacing) })),
                Column("critical_wavelength", units.length, one(study.bulk.criticalWavelength)),
                Column("ridge_pitch", "degrees", one(ridge?.let { Math.toDegrees(it.pitch.mean) })),
                Column(
                    "ridge_pitch_error",
                    "degrees",
                    one(ridge?.let { Math.toDegrees(study.judgement.error(it.pitch)) }),
                ),
            ),
        ).write(study.tables)
    }

    private companion object {
        const val MOST_CELLS = 64
        const val HEIGHT = 560
        const val ENOUGH = "Daisaka, Tanaka & Ida (2001) take 4 or more."

        /** What the errors of wakes rest on. */
        const val ASSUMED =
            "States count for as many independent ones as the correlation of their autocorrelations in " +
                "time leaves; no ± is given for fewer than eight."
    }
}
