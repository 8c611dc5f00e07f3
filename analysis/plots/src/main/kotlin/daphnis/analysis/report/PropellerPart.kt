package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.analysis.moonlet.MoonletMap
import daphnis.analysis.moonlet.Propeller
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import java.util.Locale

/** The ring around the moonlet [body]: surface density in axes that move with it, and the gaps of its propeller. */
internal class PropellerPart(private val study: Study, private val body: Moonlet) : Part {
    private val units = study.units
    private val box = study.boxes.mean
    private val map = MoonletMap(body.id, cells(0), cells(1), box.length(0), box.length(1))

    /** Of Hill radii along the orbit, from the near end of the gaps on. */
    private val near = NEAR * body.hillRadius
    private val far = minOf(FAR * body.hillRadius, box.length(1) / 2)
    private val stretch get() = "${ReportText.short(NEAR)} to ${plain(far / body.hillRadius)}"
    private val propeller: Propeller? by lazy {
        if (near < far) map.gaps(near, far, REACH * body.hillRadius) else null
    }

    /** To a tenth, without a zero behind it. */
    private fun plain(value: Double) = String.format(Locale.ROOT, "%.1f", value).removeSuffix(".0")

    /** Cells of a particle's diameter or more, and of a fifth of a Hill radius where there is one; an odd number. */
    private fun cells(axis: Int): Int {
        val fine = maxOf(2 * study.bulk.typicalRadius, if (body.hillRadius > 0) body.hillRadius / FINE else 0.0)
        return (box.length(axis) / fine).toInt().coerceIn(1, MOST_CELLS - 1) / 2 * 2 + 1
    }

    override fun add(state: State): Unit = map.add(state)

    fun numbers(): List<NumberRow> {
        val rows = NumberRows()
        rows.exact("moonlet_hill_radius", "Hill radius r_H of the first moonlet", body.hillRadius, units.length)
        val found = propeller?.takeIf { !it.isLane } ?: return rows.list()
        fun row(key: String, name: String, value: Double, error: Double, unit: String, note: String) =
            NumberRow(name, value, error, unit, null, note, Unknown.TOO_FEW.takeIf { error.isNaN() }, key)
        val where = "centres of the gaps, $stretch r_H along the orbit"
        return rows.list() + listOf(
            row(
                "propeller_separation",
                "radial distance of the gaps of the propeller",
                found.separation / body.hillRadius,
                found.separationError / body.hillRadius,
                "r_H",
                where,
            ),
            row(
                "propeller_depth",
                "part of the surface density missing in them",
                found.depth,
                found.depthError,
                "",
                "weighted like the centres",
            ),
        )
    }

    override fun write(page: ReportPage) {
        if (map.states == 0) return
        val x = DoubleArray(map.nx) { map.x(it) }
        val y = DoubleArray(map.ny) { map.y(it) }
        val excess = map.excess()
        val across = UnitNames.axis("azimuth from the moonlet", units.length)
        val radial = UnitNames.axis("radial distance", units.length)
        val figure = Chart.map(x, y, excess, across, radial, "Σ/⟨Σ⟩ − 1", most = 1.0)
        val caption = "Surface density around the first moonlet, in axes that move with it, over its mean, less 1: " +
            "${ReportText.count(map.states, "state")}. Cells above 1 have the colour of 1. Orbital motion to the " +
            "right, outward up."
        study.draw(page, figure, "moonlet", "surface density around the moonlet", caption, HEIGHT)
        val wake = map.wake(near, far)
        Table(
            "moonlet-map",
            listOf(
                Column("dx", units.length, DoubleArray(excess.size) { x[it / y.size] }),
                Column("dy", units.length, DoubleArray(excess.size) { y[it % y.size] }),
                Column("excess", "", excess),
            ),
        ).write(study.tables)
        if (!(near < far)) return
        val curve = Curve("excess", DoubleArray(x.size) { x[it] / body.hillRadius }, wake)
        val chart = Chart.lines(listOf(curve), "radial distance [r_H]", "Σ/⟨Σ⟩ − 1", horizontal = 0.0)
        val what = "The same $stretch Hill radii " +
            "downstream: behind the moonlet outside its orbit, ahead of it inside."
        study.draw(page, chart, "moonlet-wake", "surface density downstream of the moonlet", what)
        Table(
            "moonlet-wake",
            listOf(Column("dx", units.length, x), Column("excess", "", wake)),
        ).write(study.tables)
        val found = propeller
        if (found == null) {
            page.paragraph("No propeller: on one side at least no tenth of the ring is missing.")
        } else if (found.isLane) {
            page.paragraph(
                "A lane, not the two gaps of a propeller: Σ at the moonlet's orbit does not stand above that on both " +
                    "sides by more than its error.",
            )
        }
    }

    private companion object {
        const val NEAR = 2.0
        const val FAR = 8.0
        const val REACH = 4.0
        const val FINE = 5
        const val MOST_CELLS = 160
        const val HEIGHT = 420
    }
}
