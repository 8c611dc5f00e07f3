package daphnis.core.run

import daphnis.core.format.FormatException
import daphnis.core.format.H5md
import daphnis.core.format.H5mdChecksum
import daphnis.core.format.PackedFile
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.format.WholeFile
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** The files of one run and where they are. `docs/runs.md` has the table. */
public class RunDirectory internal constructor(public val path: Path, internal val files: FileOperations) {
    public constructor(path: Path) : this(path, FileOperations())

    public val scenario: Path get() = path.resolve(SCENARIO)

    /** In place of [scenario] in the run of a [Program]. */
    public val program: Path get() = path.resolve(PROGRAM)
    public val summary: Path get() = path.resolve(SUMMARY)
    public val series: Path get() = path.resolve(SeriesColumns.file)
    public val collisions: Path get() = path.resolve(CollisionColumns.file)

    /** Moments and sums for transport coefficients; only when the scenario asks for them. */
    public val transport: Path get() = path.resolve(TransportColumns.file)

    /** Distribution of impact speeds, beside [transport]. */
    public val impacts: Path get() = path.resolve(ImpactColumns.file)

    /** Fourier modes; only when the scenario asks for them. */
    public val modes: Path get() = path.resolve(ModeColumns.file)

    /** Places and orbits of the scenario's bodies; only when the scenario asks for them. */
    public val bodies: Path get() = path.resolve(BodyColumns.file)
    public val snapshots: Path get() = path.resolve(SNAPSHOTS)
    public val plots: Path get() = path.resolve("plots")
    public val tables: Path get() = path.resolve("tables")
    public val report: Path get() = path.resolve("report.html")

    /** Copy of the particle file a scenario started from, if it did. */
    internal fun initial(original: Path): Path = path.resolve(
        "initial." + SnapshotFormats.of(original).extensions.first() +
            if (original.name.endsWith(PackedFile.ENDING, ignoreCase = true)) PackedFile.ENDING else "",
    )

    /** The state of another run from which this one started, if it did. */
    internal val initial: Path get() = path.resolve("initial.${H5md.extensions.first()}")

    internal val checkpoint: Path get() = path.resolve("checkpoint")
    internal val previousCheckpoint: Path get() = path.resolve("checkpoint.previous")
    internal val newCheckpoint: Path get() = path.resolve("checkpoint.new")

    /** What a run writes, except for its scenario and the files in subdirectories. */
    internal fun ownFiles(): List<Path> {
        val outputs = PeriodicOutputs.all.flatMap { it.files }.map { path.resolve(it) }
        val reports = listOf(report, report.resolveSibling("${report.name}${WholeFile.ENDING}"))
        return listOf(summary, checkpoint, previousCheckpoint, newCheckpoint) + reports + outputs
    }

    /** The subdirectories that outputs of a run fill. */
    internal val folders: List<Path> get() = PeriodicOutputs.folders.map { path.resolve(it) }

    /** The file for the snapshot after [step]. */
    public fun snapshot(step: Long): Path = snapshots.resolve("%010d.h5".format(java.util.Locale.ROOT, step))

    /** The same, after somebody packed it. */
    private fun packed(step: Long): Path = snapshot(step).let { it.resolveSibling("${it.name}${PackedFile.ENDING}") }

    /**
     * Steps that have a snapshot, ascending.
     *
     * @throws InputException when the directory cannot be read
     */
    public fun snapshotSteps(): List<Long> = try {
        val files = if (snapshots.isDirectory()) snapshots.listDirectoryEntries("*.{h5,h5.gz}").toSet() else emptySet()
        val steps = files.mapNotNull { PackedFile.plainName(it).removeSuffix(".h5").toLongOrNull() }.distinct()
        steps.filter { snapshot(it) in files || packed(it) in files }.sorted()
    } catch (e: IOException) {
        throw InputException(snapshots.toString(), null, "cannot be read: ${reasonOf(e, snapshots)}")
    }

    /**
     * Reads the snapshot after [step].
     *
     * @throws FormatException when it cannot be read, is damaged or belongs to another step
     */
    public fun readSnapshot(step: Long): Snapshot {
        val file = snapshot(step).let { if (it.exists()) it else packed(step).takeIf(Path::exists) ?: it }
        val snapshot = try {
            H5md.read(file).firstOrNull() ?: throw FormatException("$file: holds no state")
        } catch (e: FormatException) {
            throw FormatException("${e.message}; remove the file to continue without this snapshot")
        } catch (e: IOException) {
            throw FormatException("$file: cannot be read: ${reasonOf(e, file)}")
        }
        if (snapshot.step != step) {
            throw FormatException("$file: holds the state after step ${snapshot.step}; its name says $step")
        }
        val known = checksum(step)
        if (known != null && known != H5mdChecksum.of(listOf(snapshot))) {
            throw FormatException(
                "$file: is a state of another run than the one here; remove the file, or bring it back",
            )
        }
        return snapshot
    }

    /** Of the state after [step], as the run wrote it; null where no checkpoint says it. */
    private fun checksum(step: Long): Long? {
        if (step !in checksums) checksums = RunRecord.of(this).snapshots
        return checksums[step]
    }

    @Volatile
    private var checksums: Map<Long, Long> = emptyMap()

    /** The two files of which one marks a run; an interrupted start leaves its file beside it. */
    internal val origins: List<Path> get() = listOf(scenario, program)

    internal fun holdsRun(): Boolean = origins.any { it.exists() }

    /** @throws InputException when there is no run here, or it is not the run of a scenario */
    public fun requireScenario() {
        requireRun()
        if (scenario.exists()) return
        val made = ProgramRecord.read(program)
        throw InputException("$path", null, "holds a run of $made; only it can continue the run")
    }

    /** @throws InputException when there is no run here */
    public fun requireRun() {
        if (!path.exists()) throw InputException(path.toString(), null, "no such file or directory")
        if (!path.isDirectory()) throw InputException(path.toString(), null, "is no directory")
        if (!Files.isExecutable(path) || !Files.isReadable(path)) {
            throw InputException(path.toString(), null, "cannot be read: permission denied")
        }
        if (holdsRun()) return
        val isCutShort = origins.any { files.besideOf(it).exists() }
        val missing = "it has neither $SCENARIO nor $PROGRAM"
        val why = if (isCutShort) "its start was cut short, run the scenario again" else missing
        throw InputException(path.toString(), null, "is no run directory: $why")
    }

    internal companion object {
        const val SCENARIO = "scenario.json"
        const val PROGRAM = "run.json"
        const val SUMMARY = "summary.json"
        const val SNAPSHOTS = "snapshots"
    }
}
