package daphnis.core.format

import daphnis.core.input.SiUnits
import java.io.IOException
import java.nio.file.Path

/**
 * A format of files that hold states of particles. Each format is an object in its own file and is listed in
 * [SnapshotFormats].
 */
public interface SnapshotFormat {
    /** The name of the format, such as `extended XYZ`. */
    public val title: String

    /** What a file of this format keeps of a state besides positions and radii. */
    public val keeps: Kept
}

/**
 * What files of a format keep of a state.
 *
 * @property masses whether always, only if the writer of the file put them there, or never
 * @property velocities likewise
 * @property ids likewise; without them particles are numbered in the order of the file
 * @property severalStates whether a file can hold more than one state
 * @property keepsOrder whether particles without ids are in the same order in every state
 * @property changingParticles whether the states of one export may be of different particles
 */
public class Kept @JvmOverloads constructor(
    public val masses: Presence,
    public val velocities: Presence,
    public val ids: Presence,
    public val severalStates: Boolean,
    public val changingParticles: Boolean = true,
    public val keepsOrder: Boolean = true,
) {
    public enum class Presence { ALWAYS, IF_THERE, NEVER }
}

/** A format from which states are read, to start a scenario or to be analysed. */
public interface ReadableFormat : SnapshotFormat {
    /** Endings of file names, without the dot, lower case; the first is the preferred one. */
    public val extensions: List<String>

    /**
     * A word, lower case, that identifies the format anywhere in the name of a file; null when only the ending does.
     */
    public val mark: String? get() = null

    /** How names of files begin, lower case, where neither an ending nor a [mark] tells their format; null for none. */
    public val prefix: String? get() = null

    /** Whether files are lines of text, where nothing but the end of the last one tells that they are whole. */
    public val isText: Boolean get() = false

    /**
     * Reads every state of [path], in the order of the file. Where it has no masses ([Snapshot.hasMass]), they are
     * those of density 1, or 1 each in extended XYZ.
     *
     * @throws FormatException for what is wrong, in one line
     * @throws IOException when the file cannot be read
     */
    @Throws(IOException::class)
    public fun read(path: Path): List<Snapshot> = read(path, ArrayList())

    /**
     * The same.
     *
     * @param notices receives what the file holds and daphnis does not use, a line each
     */
    @Throws(IOException::class)
    public fun read(path: Path, notices: MutableList<String>): List<Snapshot>
}

/** A format to which the snapshots of a run are exported. */
public interface WritableFormat : SnapshotFormat {
    /** The word by which it is chosen, such as `xyz`. */
    public val word: String

    /** Programs that read it. */
    public val programs: String

    /** Whether lengths can be scaled, [ExportOptions.scale]. */
    public val takesScale: Boolean get() = false

    /** Whether numbers can be in SI units, [ExportOptions.units]. */
    public val takesUnits: Boolean get() = false

    /**
     * Writes [snapshots] into [directory], which exists, replacing what is there. Each is taken once, in order.
     *
     * @throws IOException when a file cannot be written
     */
    @Throws(IOException::class)
    public fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported

    /** The same for Java, for example with [daphnis.core.run.RecordedRun.states]. */
    @Throws(IOException::class)
    public fun export(snapshots: Iterable<Snapshot>, directory: Path, options: ExportOptions): Exported =
        export(snapshots.asSequence(), directory, options)
}

/**
 * How snapshots are to be written.
 *
 * @property version the version of daphnis to name as creator
 * @property scale factor on lengths and velocities; null for the default of the format
 * @property units the scenario's units in SI units; then numbers are written in SI units
 */
public class ExportOptions @JvmOverloads constructor(
    public val version: String,
    public val scale: Double? = null,
    public val units: SiUnits? = null,
)

/**
 * What was written.
 *
 * @property path the file to open, or the directory with the files
 * @property scale factor by which lengths and velocities were multiplied
 * @property remark one line on what a user should know about the files; null when there is nothing
 */
public class Exported @JvmOverloads constructor(
    public val path: Path,
    public val scale: Double = 1.0,
    public val remark: String? = null,
)
