package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.analysis.report.ReportText.count
import daphnis.analysis.report.ReportText.short
import daphnis.analysis.table.UnitNames
import daphnis.core.run.ProgramRecord
import daphnis.core.run.Summary
import java.nio.file.Files
import kotlin.math.PI

/** What was run, in names and values. */
internal class RunParameters(private val input: AnalysisInput, private val last: State) {
    private val units = input.units

    fun rows(): List<Pair<String, String>> =
        state() + scenario() + states() + (input.summary?.let(::summary) ?: unfinished())

    private fun state(): List<Pair<String, String>> {
        val rows = ArrayList<Pair<String, String>>()
        val radius = last.population.radius
        val box = last.boundary.box
        rows += "spheres" to "${last.population.size}"
        val smallest = short(radius.min())
        val largest = short(radius.max())
        rows += if (smallest == largest) "radius" to length(smallest) else "radii" to length("$smallest to $largest")
        rows += "box" to length((0..2).joinToString(" × ") { short(box.length(it)) })
        rows += "boundary" to boundary()
        val omega = input.omega ?: return rows
        val orbit = UnitNames.amount(short(2 * PI / omega), units.time)
        rows += "angular speed Ω" to "${ReportText.plain(omega, 6)} ${units.rate}, orbit $orbit"
        return rows
    }

    private fun length(text: String) = UnitNames.amount(text, units.length)

    /** The scenario's word for it; a file without one has a periodic box or none. */
    private fun boundary(): String {
        val given = input.scenario?.boundary
        return when {
            given != null -> word(given)
            (0..2).any { last.boundary.hasImages(it) } -> "periodic"
            else -> "open; the box is where the spheres are"
        }
    }

    private fun scenario(): List<Pair<String, String>> {
        val scenario = input.scenario ?: return emptyList()
        val speed = "speed ${short(scenario.units.speedInCmPerSecond)} cm/s"
        val units = "units" to speed + (scenario.units.lengthInMetres?.let { ", length ${short(it)} m" } ?: "")
        val program = input.directory?.program
        if (program != null && Files.exists(program)) {
            // The scenario was given for space, time and units only.
            return listOf("restitution, forces" to "of ${ProgramRecord.read(program)}", units)
        }
        return listOf(
            "seed" to "${scenario.seed}",
            "restitution" to word(scenario.restitution),
            "forces" to scenario.forces.joinToString { word(it) }.ifEmpty { "none" },
            units,
        )
    }

    private fun states(): List<Pair<String, String>> {
        val first = short(input.times.first())
        val span = if (input.size == 1) first else "$first to ${short(input.times.last())}"
        return listOf("states" to "${input.size}, time ${UnitNames.amount(span, units.time)}")
    }

    private fun summary(summary: Summary) = listOf(
        "steps" to "${summary.steps}",
        "collisions" to "${summary.collisions}" + guarded(summary.guardActivations),
        "deepest overlap" to overlap(summary.maxOverlap),
        "engine" to "${summary.engine}, ${count(summary.threads, "thread")}, ${short(summary.wallSeconds)} s",
        "state digest" to summary.stateDigest,
        "version" to "daphnis ${summary.version}, ${summary.jvm}",
    )

    private fun overlap(part: Double) = if (part == 0.0) "none" else "${short(part)} of the sum of two radii"

    private fun guarded(collisions: Long) = if (collisions > 0) ", $collisions made elastic by the guard" else ""

    private fun unfinished() = if (input.directory == null) {
        emptyList()
    } else {
        listOf("summary" to "none yet: the run goes on or was interrupted")
    }

    /** A part of the scenario in the scenario's spelling: `hill-sheet`. */
    private fun word(part: Any): String =
        part.javaClass.simpleName.replace(Regex("(?<=[a-z])(?=[A-Z])"), "-").lowercase()
}
