package daphnis.drills

import daphnis.app.daphnis
import daphnis.core.initial.SeededRandom
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively
import kotlin.io.path.extension

/**
 * Damaged and hostile files of particles, each taken to the doors that files come in by: a scenario is placed from it,
 * every few it is analysed, and HDF5 stands in for the snapshot of a run that is exported. It works, or is refused in
 * one line; soon.
 *
 * @param cases how many
 * @param seed of the files; a case is known by seed and number
 * @param home a directory for the files; those with faults stay there
 */
@OptIn(ExperimentalPathApi::class)
internal fun foreignFuzz(cases: Int, seed: Long, home: Path): FuzzCounts {
    val run = home.resolve("run")
    val small = arrayOf("elastic-gas", "--set", "particles.count=20", "--steps", "1", "--quiet", "--force")
    check(daphnis("run", *small, "--out", "$run").code == 0) { "no run to export from" }
    val snapshot = run.resolve("snapshots/0000000001.h5")
    return Fuzz(cases, seed).run { number, counts ->
        val file = ForeignMutation(SeededRandom(seed * 1_000_003 + number), home).file("$seed-$number")
        val before = counts.faults.size
        val doors = ArrayList<Boolean>()
        doors += counts.count(daphnis("describe", "${placed(file)}"), file)
        if (number % ANALYSED_EVERY == 0) {
            doors +=
                counts.count(daphnis("analyze", "$file", "--quiet", "--out", "${home.resolve("analysis")}"), file)
        }
        if (file.extension == "h5") {
            Files.copy(file, snapshot, java.nio.file.StandardCopyOption.REPLACE_EXISTING)
            val format = FORMATS[number % FORMATS.size]
            doors +=
                counts.count(daphnis("export", "$run", "--format", format, "--out", "${home.resolve("export")}"), file)
        }
        counts.worked += doors.count { it }
        if (counts.faults.size == before) {
            Files.delete(file)
            Files.delete(placed(file))
        }
        home.resolve("export").deleteRecursively()
    }
}

/** A scenario that is placed from [file], beside it. */
private fun placed(file: Path): Path {
    val scenario = file.resolveSibling("${file.fileName}.json")
    Files.writeString(
        scenario,
        """{ "box": { "lengths": [10, 9, 8] }, "boundary": { "type": "periodic" }, "placement": { "type": "file",
        "path": "${file.fileName}", "time": 0 },
            "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.001 },
            "until": 0.1 }""",
    )
    return scenario
}

private const val ANALYSED_EVERY = 10
private val FORMATS = listOf("xyz", "vtp", "h5md", "cartandrad", "lammps")
