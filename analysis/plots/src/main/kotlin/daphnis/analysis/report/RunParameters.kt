package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.analysis.report.ReportText.count
import daphnis.analysis.report.ReportText.short
import daphnis.analysis.table.UnitNames
import daphnis.core.boundary.ContactFaces
import daphnis.core.run.ProgramRecord
import daphnis.core.run.Summary
import daphnis.core.scenario.BoundarySpec
import daphnis.core.scenario.Scenario
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
        rows += (if (box.space.isPlane) "discs" else "spheres") to "${last.population.size}"
        val smallest = short(radius.min())
        val largest = short(radius.max())
        rows += if (smallest == largest) "radius" to length(smallest) else "radii" to length("$smallest to $largest")
        val open = (0 until box.space.dimensions).filter { last.boundary.contactFaces(it) == ContactFaces.OPEN }
        val isOpen = input.scenario != null && open.isNotEmpty() && last.boundary.walls.surfaces.isEmpty()
        val beyond = if (isOpen) ", open along ${open.joinToString { "xyz"[it].toString() }}" else ""
        rows += "box" to length((0 until box.space.dimensions).joinToString(" × ") { short(box.length(it)) }) + beyond
        boundary()?.let { rows += "boundary" to it }
        if (!input.hasVelocities) rows += "velocities" to "the file has no velocities"
        val omega = input.omega ?: return rows
        val orbit = UnitNames.amount(short(2 * PI / omega), units.time)
        rows += "angular speed Ω" to "${UnitNames.amount(ReportText.plain(omega, 6), units.rate)}, orbit $orbit"
        return rows
    }

    private fun length(text: String) = UnitNames.amount(text, units.length)

    /** Of a file without a scenario, by axis; a scenario says it with its values. */
    private fun boundary(): String? {
        if (input.scenario != null) return null
        val (periodic, open) = (0 until last.dimensions).partition { last.boundary.hasImages(it) }
        val lengths = input.snapshot(input.size - 1).lengths
        val around = if (open.any { lengths[it].isNaN() }) AROUND else ""
        fun along(axes: List<Int>) = axes.joinToString { "${"xyz"[it]}" }
        return when {
            open.isEmpty() -> "periodic"
            periodic.isEmpty() -> "open$around"
            else -> "periodic along ${along(periodic)}; open along ${along(open)}$around"
        }
    }

    private fun scenario(): List<Pair<String, String>> {
        val scenario = input.scenario ?: return emptyList()
        val units = "units" to units(scenario)
        val program = input.directory?.program
        if (program != null && Files.exists(program)) {
            // The scenario was given for space, time and units only.
            val boundary = "boundary" to around(scenario, scenario.boundary.inWords({ short(it) }, { short(it) }))
            return listOf(boundary, "restitution, forces" to "of ${ProgramRecord.read(program)}", units)
        }
        val words = ScenarioWords(scenario).rows()
        return words.map { (name, text) -> name to if (name == "boundary") around(scenario, text) else text } + units
    }

    private fun around(scenario: Scenario, boundary: String) = if (scenario.boundary.isOpen) "open$AROUND" else boundary

    /** Without a length nothing is known in SI units but speeds and, for what it is worth, masses. */
    private fun units(scenario: Scenario): String {
        val units = scenario.units
        val speed = scenario.cmPerSecond ?: if (units.massInKg == 1.0) return "none" else units.speedInCmPerSecond
        val length = units.lengthInMetres?.let { "${short(it)} m" } ?: "not given"
        val time = units.timeInSeconds?.let { ", time ${short(it)} s" }.orEmpty()
        return "speed ${short(speed)} cm/s, length $length, mass ${short(units.massInKg)} kg$time"
    }

    private fun states(): List<Pair<String, String>> {
        val span = ReportText.span(input.times.first(), input.times.last())
        return listOf("states" to "${input.size}, time ${UnitNames.amount(span, units.time)}")
    }

    private fun summary(summary: Summary) = listOfNotNull(
        "steps" to "${summary.steps}" + end(summary),
        "collisions" to
            "${summary.collisions}" + guarded(summary.guardActivations) + merged(summary.mergers) +
            atEdges(summary.edgeEvents) + broken(summary.broken),
        swaps(summary)?.let { "swaps" to it },
        "deepest overlap" to overlap(summary.maxOverlap),
        "engine" to "${summary.engine}, ${count(summary.threads, "thread")}, ${short(summary.wallSeconds)} s",
        "state digest" to summary.stateDigest,
        "version" to "daphnis ${summary.version}, ${summary.jvm}",
    )

    private fun swaps(summary: Summary): String? {
        val tried = summary.swapAttempts
        return if (tried == 0L) null else "${summary.swaps} of $tried tried, ${short(100.0 * summary.swaps / tried)} %"
    }

    private fun broken(spheres: Long) = if (spheres > 0) ", $spheres spheres broke in them" else ""

    private fun merged(mergers: Long) = if (mergers > 0) ", $mergers of them mergers" else ""

    private fun atEdges(events: Long) = if (events > 0) "; $events events at edges of interactions" else ""

    private fun end(summary: Summary): String {
        if (!summary.finished) return ", interrupted before the end of the scenario"
        val scenario = input.scenario ?: return ""
        val growth = scenario.growth ?: return ""
        val until = scenario.until ?: return ""
        val hasGoal = growth.untilFillingFactor != null || growth.untilPressure != null
        // Steps up to the end may fall short of it by rounding.
        val isEarly = hasGoal && summary.time < until * (1 - ROUNDING)
        return if (isEarly) ", ended before time ${short(until)} by an end of growth" else ""
    }

    private fun overlap(part: Double) = if (part == 0.0) "none" else "${short(part)} of the sum of two radii"

    private fun guarded(collisions: Long) = if (collisions > 0) ", $collisions made elastic by the guard" else ""

    private fun unfinished() = if (input.directory == null) {
        emptyList()
    } else {
        listOf("summary" to "none yet: the run goes on or was interrupted")
    }

    private companion object {
        /** Of a box whose open faces nobody gave. */
        const val AROUND = "; the box is where the spheres are"
        const val ROUNDING = 1e-9
    }
}
