package daphnis.drills

import daphnis.app.CommandResult
import daphnis.app.daphnis
import daphnis.core.population.stateDigest
import daphnis.core.run.RunDirectory
import daphnis.core.run.Summary
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.exists
import kotlin.io.path.name

/** The commands that read a run directory, and what they make of it. */
internal class RunCommands(private val base: Path) {
    /** A run of 12 steps with every file there is, from a particle file. */
    fun makeRun(home: Path) {
        val rows = (0 until 64).joinToString("\n") { k ->
            "${k % 4 * 2 - 3},${k / 4 % 4 * 2 - 3},${k / 16 * 2 - 3},${k % 5 - 2},${k % 7 - 3},${k % 3 - 1},0.5,1"
        }
        Files.writeString(home.resolve("start.csv"), "x,y,z,vx,vy,vz,radius,mass\n$rows\n")
        val scenario = home.resolve("scenario.json")
        Files.writeString(scenario, SCENARIO)
        val result = daphnis("run", scenario.toString(), "--out", base.toString(), "--quiet")
        check(result.code == 0) { result.err }
    }

    fun run(name: String, directory: Path): CommandResult = when (name) {
        "resume" -> daphnis("resume", "$directory", "--until", "2.0", "--quiet")
        "compare" -> daphnis("compare", "$base", "$directory")
        "export" -> daphnis("export", "$directory", "--format", "xyz", "--out", "$directory-out")
        else -> daphnis("analyze", "$directory", "--quiet", "--out", "$directory-out")
    }

    /**
     * What the command [name] has made, by name of file; of pictures and pages nothing, of a summary what does not
     * depend on the clock.
     */
    fun results(name: String, directory: Path, result: CommandResult): Map<String, String> = when (name) {
        "resume" -> ofRun(directory)
        "compare" -> mapOf("verdict" to result.out.substringBefore(':'))
        else -> Files.walk(Path.of("$directory-out")).use { files ->
            files.filter { Files.isRegularFile(it) && it.name.substringAfterLast('.') in setOf("csv", "xyz") }.toList()
                .associate { it.name to Files.readString(it) }
        }
    }

    private fun ofRun(directory: Path): Map<String, String> = buildMap {
        val run = RunDirectory(directory)
        for (table in listOf(
            run.series,
            run.transport,
            run.impacts,
            run.collisions,
        )) {
            if (table.exists()) put(table.name, Files.readString(table))
        }
        // States that were there before stay as they are; whoever reads a damaged one is told.
        val late = run.snapshotSteps().filter { it > 12 }
        for (step in late) put("$step", stateDigest(run.readSnapshot(step).population()))
        val summary = Summary.read(run.summary)
        put(
            "summary",
            "${summary.stateDigest} ${summary.steps} ${summary.collisions} ${summary.guardActivations} " +
                "${summary.energy} ${summary.maxOverlap}",
        )
    }

    companion object {
        val NAMES = listOf("resume", "compare", "export", "analyze")

        /** `resume` is at stake most; `analyze` takes longest. */
        fun draw(random: Random): String = when (random.nextInt(10)) {
            in 0..4 -> "resume"
            in 5..6 -> "compare"
            in 7..8 -> "export"
            else -> "analyze"
        }

        private const val SCENARIO = """{
          "name": "damage", "description": "to be damaged", "seed": 3,
          "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "lees-edwards", "shearRate": 0.7 },
          "placement": { "type": "file", "path": "start.csv" },
          "restitution": { "type": "constant", "coefficient": 0.6 },
          "engine": { "name": "serial" },
          "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1.2,
          "output": { "snapshotEvery": 4, "checkpointEvery": 5, "collisionLog": true, "transportEvery": 2 }
        }"""
    }
}
