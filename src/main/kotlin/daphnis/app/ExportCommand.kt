package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.double
import daphnis.core.format.CartAndRad
import daphnis.core.format.ExtendedXyz
import daphnis.core.format.FormatException
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.format.Vtp
import daphnis.core.run.ProgramRecord
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunRecord
import daphnis.core.run.Version
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.WayOut
import java.nio.file.Files
import java.nio.file.Path

/** `daphnis export`: the snapshots of a run in a format of the community. */
class ExportCommand : CliktCommand(name = "export") {
    private val directory by argument("dir", help = "run directory")
    private val format by option(
        "--format",
        help = "xyz (OVITO, ASE), vtp (ParaView), h5md (h5py, MDAnalysis) or cartandrad (SwiftVis)",
    ).choice("xyz", "vtp", "h5md", "cartandrad").required()
    private val out by option("--out", metavar = "dir", help = "where to write (default: DIR/export)")
    private val units by option(
        "--units",
        help = "of h5md: as the scenario's, without names (default), or si, with names",
    ).choice("scenario", "si")
    private val scale by option(
        "--scale",
        help = "factor on lengths in xyz (default: 1, or 1 / mean radius for boxes no longer than 4)",
    ).double()

    override fun help(context: Context) = "Write the snapshots of a run as xyz, vtp, h5md or cartandrad."

    override fun run() {
        checkOptions()
        val run = RunDirectory(pathOf(directory, "dir"))
        run.requireRun()
        val steps = run.snapshotSteps()
        if (steps.isEmpty()) {
            throw InputException(directory, null, "has no snapshots", WayOut.WRITE_SNAPSHOTS)
        }
        val target = out?.let { pathOf(it, "--out") } ?: run.path.resolve("export")
        Files.createDirectories(target)
        val frames = steps.asSequence().map { run.frame(it) }
        val written = when (format) {
            "xyz" -> xyz(frames, target)
            "vtp" -> vtp(frames, target)
            "h5md" -> h5md(frames, run, target)
            else -> cartAndRad(frames, target)
        }
        println("${if (steps.size == 1) "1 snapshot" else "${steps.size} snapshots"} to $written")
    }

    private fun checkOptions() {
        scale?.let {
            if (format != "xyz") {
                throw InputException(
                    "--scale",
                    null,
                    "is $it; it is for --format xyz only, $format keeps all lengths as they are",
                )
            }
            if (!(it > 0 && it.isFinite())) throw InputException("--scale", null, "is $it; it must be > 0")
        }
        if (units != null && format != "h5md") {
            throw InputException("--units", null, "is $units; it is for --format h5md only")
        }
    }

    private fun h5md(frames: Sequence<Snapshot>, run: RunDirectory, target: Path): Path {
        val si = if (units == "si") {
            scenario(run).units.si
                ?: throw InputException(
                    "--units",
                    null,
                    "is si; the scenario in $directory does not say units.lengthInMetres",
                )
        } else {
            null
        }
        val file = target.resolve(if (si == null) "trajectory.h5" else "trajectory-si.h5")
        val all = frames.toList()
        all.find { !it.id.contentEquals(all[0].id) }?.let {
            val where = "those of steps ${all[0].step} and ${it.step} differ"
            throw InputException(
                "--format",
                null,
                "is h5md, which needs the same particles in every state; $where; xyz and vtp do not",
            )
        }
        H5md.write(all, file, Version.text, si)
        val nameless = "units are the scenario's and have no names; MDAnalysis opens the file with convert_units=False"
        println(if (si == null) nameless else "units are m, s, m s-1 and kg")
        return file
    }

    /** The scenario in the directory, if it is the one that the run was made with. */
    private fun scenario(run: RunDirectory): Scenario {
        if (Files.exists(run.program)) {
            val why = "holds a run of ${ProgramRecord.read(run.program)}, without a scenario that says its units"
            throw InputException("--units", null, "is si; $directory $why")
        }
        val scenario = ScenarioJson.read(run.scenario)
        RunRecord.of(run).changes(scenario).firstOrNull()?.let {
            throw FormatException("$it; bring it back to have SI units")
        }
        return scenario
    }

    private fun xyz(frames: Sequence<Snapshot>, target: Path): Path {
        val file = target.resolve("trajectory.xyz")
        var factor = scale
        Files.newBufferedWriter(file).use { out ->
            for (frame in frames) {
                if (factor == null) factor = ExtendedXyz.suitableScale(frame)
                ExtendedXyz.write(frame, out, factor)
            }
        }
        if (factor != 1.0) {
            println(
                "lengths and velocities are multiplied by $factor" +
                    if (scale == null) {
                        " (one mean radius is 1), so that no reader takes them for fractions of the box; --scale 1 leaves them"
                    } else {
                        ""
                    },
            )
        }
        return file
    }

    private fun vtp(frames: Sequence<Snapshot>, target: Path): Path {
        val names = frames.map { frame ->
            val name = "%010d.vtp".format(java.util.Locale.ROOT, frame.step)
            Vtp.write(frame, target.resolve(name))
            name to frame.time
        }.toList()
        return target.resolve("trajectory.pvd").also { Vtp.writeIndex(names, it) }
    }

    private fun cartAndRad(frames: Sequence<Snapshot>, target: Path): Path {
        for (frame in frames) CartAndRad.write(frame.population(), target.resolve("CartAndRad.${frame.step}.bin"))
        println(
            "CartAndRad has no place for masses and ids: they are left out, spheres stand in the order of their ids",
        )
        return target
    }
}
