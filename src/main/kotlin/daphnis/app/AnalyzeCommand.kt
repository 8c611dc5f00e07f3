package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.report.Analysis
import daphnis.analysis.report.AnalysisOptions
import daphnis.analysis.report.AnalysisProgress
import daphnis.app.printing.noticeInFlags
import daphnis.app.printing.printLine
import daphnis.app.printing.warn
import daphnis.app.progress.ShownProgress
import daphnis.core.format.SnapshotFormats
import daphnis.core.input.InputException
import java.nio.file.Files

/** `daphnis analyze`: tables, plots and a report of a run or of a particle file. */
class AnalyzeCommand : CliktCommand(name = "analyze") {
    private val what by argument(
        "dir-or-file",
        help = "run directory, or a particle file: ${SnapshotFormats.known}",
        completionCandidates = Candidates.files,
    )
    private val scenario by option(
        "--scenario",
        help = "for a file, or the run of a program: scenario file or built-in name that says what box and frame are",
        completionCandidates = Candidates.scenario,
    )
    private val settings by option(
        "--set",
        metavar = "path=value",
        help = "with --scenario: replace any key of it",
        completionCandidates = Candidates.setting,
    ).multiple()
    private val timeStep by option(
        "--time-step",
        help = "for a file that has no times: time of a step, in the unit of its velocities",
    ).double()
    private val from by option(
        "--from",
        help = "averages begin at this time, in the scenario's unit of time (default: after 3/8 of the run)",
    ).double()
    private val slabs by option(
        "--slabs",
        help = "slabs of azimuth for streamlines (default: by the number of particles)",
    ).int()
    private val groups by option(
        "--groups",
        help = "groups of equal count in a slab (default: by the number of particles)",
    ).int()
    private val elevation by option(
        "--elevation",
        help = "elevation of the rays of the occultation above the x-y plane, degrees in 0.1..90 (default 28)",
    )
        .double().default(28.0)
    private val azimuth by option(
        "--azimuth",
        help = "direction in which these rays climb, from x toward y, degrees (default 0)",
    ).double().default(0.0)
    private val occultation by OccultationFlags()
    private val brightness by BrightnessFlags()
    private val clusterRatio by option(
        "--cluster-ratio",
        help = "spheres up to so many sums of radii apart are in one cluster, 1..100 (default: where they attract)",
    ).double()
    private val frames by option("--frames", help = "the most states that are averaged (default 40)").int().default(40)
    private val out by option(
        "--out",
        metavar = "dir",
        help = "where to write (default: into the run directory; FILE-analysis for a file)",
        completionCandidates = Candidates.files,
    )
    private val acceptLoss by option(
        "--accept-loss",
        help = "accept files that differ from what the run wrote, and report them",
    ).flag()
    private val quiet by option("--quiet", help = "no progress").flag()

    override fun help(context: Context) = "Write tables, plots and a report of a run."

    override fun run() {
        checkOptions()
        val light = occultation.options(brightness.isAsked)
        val bright = brightness.options()
        val path = pathOf(what, "dir-or-file")
        val given = scenario?.let { scenarioNamed(it, settings) }
        val input = if (Files.isRegularFile(path)) {
            AnalysisInput.ofFile(path, given, scenario.orEmpty(), timeStep)
        } else {
            timeStep?.let { throw InputException("--time-step", null, "is $it; it is for files, and runs have times") }
            AnalysisInput.ofRun(path, acceptLoss, given)
        }
        for (notice in input.notices) warn(noticeInFlags(notice))
        val directory =
            out?.let { pathOf(it, "--out") }
                ?: if (Files.isRegularFile(path)) path.resolveSibling("${path.fileName}-analysis") else path
        val options =
            AnalysisOptions(from, slabs ?: 0, groups ?: 0, elevation, frames, azimuth, light, clusterRatio, bright)
        val analysis = Analysis(input, options)
        val progress = if (quiet) AnalysisProgress { _, _, _ -> } else ShownProgress()
        LastWords { "analyze was interrupted; nothing was written to $directory" }.use {
            writingLater(directory) { analysis.write(directory, progress) }
        }
        analysis.missing?.let { warn("there are no PNG pictures in ${directory.resolve("plots")}, only SVG: $it") }
        printLine("report: ${directory.resolve("report.html")}")
    }

    private fun checkOptions() {
        fun wrong(option: String, value: Any, right: String): Nothing =
            throw InputException(option, null, "is $value; it must be $right")
        for ((option, value) in listOf("--slabs" to slabs, "--groups" to groups)) {
            if (value != null && value !in 1..MOST) wrong(option, value, "in 1..$MOST")
        }
        if (!(elevation >= LineOfSight.LOWEST && elevation <= 90)) {
            wrong("--elevation", elevation, "in ${LineOfSight.LOWEST}..90 degrees")
        }
        if (!(azimuth >= -360 && azimuth <= 360)) wrong("--azimuth", azimuth, "in -360..360 degrees")
        if (frames < 1) wrong("--frames", frames, "at least 1")
        if (scenario == null && settings.isNotEmpty()) {
            throw InputException("--set", null, "is ${settings.first()}, a key of a scenario; give it with --scenario")
        }
        from?.let { if (!it.isFinite()) wrong("--from", it, "a finite number") }
    }

    private companion object {
        const val MOST = 100_000
    }
}
