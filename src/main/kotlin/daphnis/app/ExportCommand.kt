package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.double
import daphnis.app.printing.printLine
import daphnis.core.format.ExportOptions
import daphnis.core.format.Exported
import daphnis.core.format.FormatException
import daphnis.core.format.Kept.Presence
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.format.WritableFormat
import daphnis.core.input.InputException
import daphnis.core.input.SiUnits
import daphnis.core.input.WayOut
import daphnis.core.run.ProgramRecord
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunRecord
import daphnis.core.run.Version
import daphnis.core.scenario.ScenarioJson
import java.nio.file.Files

/** `daphnis export`: the snapshots of a run in a format of the community. */
class ExportCommand : CliktCommand(name = "export") {
    private val directory by argument("dir", help = "run directory", completionCandidates = Candidates.files)
    private val format by option("--format", help = listed(FORMATS.map { "${it.word} (${it.programs})" }))
        .choice(*FORMATS.map { it.word to it }.toTypedArray()).required()
    private val out by option(
        "--out",
        metavar = "dir",
        help = "where to write (default: DIR/export)",
        completionCandidates = Candidates.files,
    )
    private val units by option(
        "--units",
        help = "of ${UNITS.joinToString { it.word }}: as the scenario's, without names (default), or si, with names",
    ).choice("scenario", "si")
    private val scale by option(
        "--scale",
        help = "factor on lengths in ${SCALED.joinToString { it.word }} " +
            "(default: 1, or 1 / mean radius for boxes no longer than 4)",
    ).double()

    override fun help(context: Context) = "Write the snapshots of a run as ${listed(FORMATS.map { it.word })}."

    override fun run() {
        checkOptions()
        val run = RunDirectory(pathOf(directory, "dir"))
        run.requireRun()
        val steps = run.snapshotSteps()
        if (steps.isEmpty()) {
            throw InputException(directory, null, "has no snapshots", WayOut.WRITE_SNAPSHOTS)
        }
        val target = out?.let { pathOf(it, "--out") } ?: run.path.resolve("export")
        val written = writing(target) {
            val options = ExportOptions(Version.text, scale, if (units == "si") siOf(run) else null)
            format.export(sameParticles(steps.asSequence().map { run.readSnapshot(it) }), target, options)
        }
        remarks(written).forEach(::printLine)
        printLine("${if (steps.size == 1) "1 snapshot" else "${steps.size} snapshots"} to ${written.path}")
    }

    private fun checkOptions() {
        fun onlyFor(formats: List<WritableFormat>) = "it is for --format ${formats.joinToString { it.word }} only"
        scale?.let {
            if (!format.takesScale) {
                val kept = "${format.word} keeps all lengths as they are"
                throw InputException("--scale", null, "is $it; ${onlyFor(SCALED)}, $kept")
            }
            if (!(it > 0 && it.isFinite())) throw InputException("--scale", null, "is $it; it must be > 0")
        }
        if (units != null && !format.takesUnits) {
            throw InputException("--units", null, "is $units; ${onlyFor(UNITS)}")
        }
    }

    /** [snapshots], refused where they are of different particles and the format cannot hold that. */
    private fun sameParticles(snapshots: Sequence<Snapshot>): Sequence<Snapshot> {
        if (format.keeps.changingParticles) return snapshots
        var first: IntArray? = null
        var step = 0L
        return snapshots.onEach { snapshot ->
            val ids = first ?: snapshot.id.also {
                first = it
                step = snapshot.step
            }
            if (snapshot.id.contentEquals(ids)) return@onEach
            val others = FORMATS.filter { it.keeps.changingParticles && it.keeps.ids != Presence.NEVER }
            throw InputException(
                "--format",
                null,
                "is ${format.word}, which needs the same particles in every state; those of steps $step and " +
                    "${snapshot.step} differ; ${others.dropLast(1).joinToString {
                        it.word
                    }} and ${others.last().word} do not",
            )
        }
    }

    /** The units of the scenario in the directory, if it is the one that the run was made with. */
    private fun siOf(run: RunDirectory): SiUnits {
        if (Files.exists(run.program)) {
            val why = "holds a run of ${ProgramRecord.read(run.program)}, without a scenario that says its units"
            throw InputException("--units", null, "is si; $directory $why")
        }
        val scenario = ScenarioJson.read(run.scenario)
        RunRecord.of(run).changes(scenario).firstOrNull()?.let {
            throw FormatException("$it; bring it back to have SI units")
        }
        return scenario.units.si ?: throw InputException(
            "--units",
            null,
            "is si; the scenario in $directory does not say units.lengthInMetres",
        )
    }

    private fun remarks(written: Exported): List<String> {
        val isAsked = scale != null
        val why = " (one mean radius is 1), so that readers do not interpret them as fractions of the box; " +
            "--scale 1 leaves them unchanged"
        val scaled = "lengths and velocities are multiplied by ${written.scale}" + if (isAsked) "" else why
        return listOfNotNull(scaled.takeIf { written.scale != 1.0 }, written.remark)
    }

    private companion object {
        val FORMATS = SnapshotFormats.writable
        val SCALED = FORMATS.filter { it.takesScale }
        val UNITS = FORMATS.filter { it.takesUnits }

        /** `a, b or c`. */
        fun listed(words: List<String>): String = words.dropLast(1).joinToString() + " or " + words.last()
    }
}
