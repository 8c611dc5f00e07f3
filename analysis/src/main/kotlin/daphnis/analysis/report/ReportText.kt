package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.PatchState
import java.util.Locale
import kotlin.math.PI

internal object ReportText {
    /** A number in few digits. */
    fun short(v: Double): String = if (v.isNaN()) {
        "–"
    } else if (v == Math.rint(v) && Math.abs(v) < 1e6) {
        v.toLong().toString()
    } else if (Math.abs(v) >= 1e-3 && Math.abs(v) < 1e6) {
        String.format(Locale.ROOT, "%.3g", v).let { if ('e' in it) String.format(Locale.ROOT, "%.0f", v) else it }
    } else {
        String.format(Locale.ROOT, "%.3g", v)
    }

    fun parameters(input: AnalysisInput, last: PatchState): List<Pair<String, String>> {
        val rows = ArrayList<Pair<String, String>>()
        val units = input.units
        val box = last.boundary.box
        rows += "particles" to "${last.population.size}"
        rows += "radii" to "${short(last.population.radius.min())} to ${short(last.population.radius.max())} ${units.length}"
        rows += "box" to (0..2).joinToString(" × ") { short(box.length(it)) } + " ${units.length}"
        rows += "boundary" to (input.scenario?.boundary ?: last.boundary).javaClass.simpleName
        val omega = input.omega
        if (omega != null) rows += "angular speed Ω" to "${String.format(Locale.ROOT, "%.6g", omega)} / ${units.time}, orbit ${short(2 * PI / omega)} ${units.time}"
        val scenario = input.scenario
        if (scenario != null) {
            rows += "seed" to "${scenario.seed}"
            rows += "restitution" to scenario.restitution.javaClass.simpleName
            rows += "forces" to scenario.forces.joinToString { it.javaClass.simpleName }.ifEmpty { "none" }
            rows += "units" to "speed ${short(scenario.units.speedInCmPerSecond)} cm/s" + (scenario.units.lengthInMetres?.let { ", length ${short(it)} m" } ?: "")
        }
        rows += "states" to "${input.size}, time ${short(input.times.first())} to ${short(input.times.last())} ${units.time}"
        val summary = input.summary
        if (summary != null) {
            rows += "steps" to "${summary.steps}"
            rows += "collisions" to "${summary.collisions}" + if (summary.guardActivations > 0) ", ${summary.guardActivations} made elastic by the guard" else ""
            rows += "deepest overlap" to "${short(summary.maxOverlap)} of the sum of two radii"
            rows += "engine" to "${summary.engine}, ${summary.threads} threads, ${short(summary.wallSeconds)} s"
            rows += "state digest" to summary.stateDigest
            rows += "version" to "daphnis ${summary.version}, ${summary.jvm}"
        } else if (input.directory != null) {
            rows += "summary" to "none yet: the run goes on or was interrupted"
        }
        return rows
    }
}
