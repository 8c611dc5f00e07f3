package daphnis.analysis.report

import daphnis.analysis.moonlet.BodyTable
import daphnis.analysis.moonlet.RandomWalk
import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.BodyColumns
import daphnis.core.table.Column
import kotlin.math.PI

/** Where moonlets went, and what pushed them: from `bodies.csv`. */
internal class WalkPart(private val study: Study) : Part {
    private val units = study.units
    private val all = study.input.bodies.filter { it.id >= 0 }

    /** Whether there are rows. */
    val isKnown: Boolean = all.isNotEmpty()
    private val charts = OrbitCharts(study, all, "moonlet")
    private val late = all.map { it.from(study.from) }
    private val orbit = study.input.omega?.let { 2 * PI / it } ?: 1.0
    private val walk: RandomWalk? by lazy {
        val time = late.map { it[BodyColumns.TIME] }
        val isLong = time.any { it.size > 2 && it.last() - it[0] >= 2 * MEMORY * orbit * (1 + ROUNDING) }
        if (isLong) RandomWalk.settled(time, late.map { it[BodyColumns.GUIDING_X] }, MEMORY * orbit) else null
    }

    fun numbers(): List<NumberRow> {
        val rows = NumberRows()
        late.firstOrNull()?.let { first ->
            val unit = units.of("mass length/time^2")
            force(rows, first, "moonlet_force_impacts", "impacts", BodyColumns.IMPACT_PUSH, unit)
            force(rows, first, "moonlet_force_gravity", "gravity", BodyColumns.GRAVITY_PUSH, unit)
            val e = first[BodyColumns.ECCENTRICITY]
            rows.average("moonlet_eccentricity", "a·e of the first moonlet, mean", BlockAverage.of(e), units.length)
        }
        return rows.list() + walk?.let { of(it) }.orEmpty()
    }

    /** What is known of the walk that was [found]. */
    fun of(found: RandomWalk): List<NumberRow> {
        val length = "${ReportText.short(found.length / orbit)} orbits"
        val blocks = "${ReportText.count(found.times, "time")} of $length"
        val distance = units.length
        val century = HUNDRED * orbit
        val drift =
            row("moonlet_drift", "drift of the moonlets' a", found.drift, found.driftError, orbit, "$distance/orbit")
        val diffusion = "diffusion of their a, ½ ⟨Δa²⟩/t"
        if (!found.isSettled) {
            val correlation = ReportText.short(found.correlation)
            val why = "not known: changes over $length depend on those before (correlation $correlation), $LONGER"
            val unknown = Double.NaN
            val key = "moonlet_diffusion"
            return listOf(drift, NumberRow(diffusion, unknown, unknown, "${units.area}/orbit", note = why, key = key))
        }
        return listOf(
            drift,
            row(
                "moonlet_diffusion",
                diffusion,
                found.diffusion,
                found.diffusionError,
                orbit,
                "${units.area}/orbit",
                blocks,
            ),
            row(
                "moonlet_walk",
                "random walk of their a in 100 orbits, √(2Dt)",
                found.amplitude(century),
                found.amplitudeError(century),
                1.0,
                distance,
            ),
        )
    }

    private fun force(rows: NumberRows, body: BodyTable, key: String, by: String, column: Column, unit: String) {
        val series = body.force(column).filter { it.isFinite() }.toDoubleArray()
        if (series.isEmpty()) return
        val note = "times the distance from the planet: torque"
        rows.average(key, "mean force along the orbit by $by", BlockAverage.of(series), unit, note)
    }

    private fun row(
        key: String,
        name: String,
        value: Double,
        error: Double,
        scale: Double,
        unit: String,
        note: String = "",
    ): NumberRow {
        val unknown = Unknown.TOO_FEW.takeIf { error.isNaN() }
        return NumberRow(name, value * scale, error * scale, unit, null, note, unknown, key)
    }

    override fun write(page: ReportPage) {
        if (!isKnown) {
            page.paragraph("Where moonlets went is not known: bodies.csv was not written (output.bodiesEvery).")
            return
        }
        charts.write(page)
    }

    private companion object {
        /** The least of orbits over which pushes are forgotten: an epicycle is damped, and what passed is gone. */
        const val MEMORY = 2.0
        const val LONGER = "a longer run is needed"
        const val HUNDRED = 100
        const val ROUNDING = 1e-9
    }
}
