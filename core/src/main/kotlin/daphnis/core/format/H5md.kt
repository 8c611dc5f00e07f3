package daphnis.core.format

import daphnis.core.format.Kept.Presence.IF_THERE
import daphnis.core.format.hdf5.Hdf5File
import daphnis.core.input.SiUnits
import daphnis.core.population.SphereQuantity.Change.NEVER
import java.io.IOException
import java.nio.file.Path

/**
 * H5MD 1.1 (de Buyl, Colberg & Höfling 2014, Comput. Phys. Commun. 185, 1546): HDF5 that h5py, MDAnalysis and ParaView
 * read. One particle group `all`: position, velocity and image as `{step, time, value[T][N][3]}`; id, mass, radius
 * and species as plain datasets, or as `{step, time, value[T][N]}` where they change; radius is our addition. Species are
 * there where there are materials, whose names are the attribute `materials` of the group `parameters`; `box/edges` of a box
 * centred on the origin. Units are the scenario's and have no names, or are SI with H5MD's module `units`. The attribute
 * `crc32c` of the group `parameters` is a checksum over everything that is read ([H5mdChecksum]).
 */
public object H5md : ReadableFormat, WritableFormat {
    override val title: String = "H5MD"
    override val extensions: List<String> = listOf("h5", "h5md")
    override val keeps: Kept =
        Kept(IF_THERE, IF_THERE, IF_THERE, severalStates = true, changingParticles = false)
    override val word: String = "h5md"
    override val programs: String = "h5py, MDAnalysis"
    override val takesUnits: Boolean = true

    /** Writes `trajectory.h5`, or `trajectory-si.h5` in SI units. One state is in memory at a time. */
    override fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported {
        val si = options.units != null
        val file = directory.resolve(if (si) "trajectory-si.h5" else "trajectory.h5")
        wholeFile(file) { write(snapshots, it, options.version, options.units) }
        val nameless = "units are the scenario's and have no names; MDAnalysis opens the file with convert_units=False"
        return Exported(file, remark = if (si) "units are m, s, m s-1 and kg" else nameless)
    }

    /**
     * Writes [snapshots], all of the same spheres, to [path]. Where it fails, nothing takes what it leaves for HDF5.
     *
     * @param version the version of daphnis to name as creator
     * @param units the scenario's units in SI units; then the numbers are written in SI units, and every dataset has
     *   its `unit`
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(snapshots: List<Snapshot>, path: Path, version: String, units: SiUnits? = null): Unit =
        write(snapshots.asSequence(), path, version, units)

    /** The same for states that need not be in memory together: each is taken once, in order. */
    private fun write(snapshots: Sequence<Snapshot>, path: Path, version: String, units: SiUnits?) {
        val names = if (units == null) null else H5mdWriter.UnitNames("m", "s", "kg")
        val states = (if (units == null) snapshots else snapshots.map { units.convert(it) }).iterator()
        require(states.hasNext()) { "no frame to write" }
        Hdf5File(path).use { file ->
            // No variable holds a state while the next one is read.
            val writer = states.next().let { first -> H5mdWriter(file, first, version, names).also { it.add(first) } }
            while (states.hasNext()) writer.add(states.next())
            writer.finish()
        }
    }

    /**
     * Reads every snapshot of a file that [write] wrote, or that has the same datasets with numbers of any width. A
     * file without a checksum, from an older version or another program, is accepted as it is.
     *
     * @throws FormatException when it is not such a file, or is damaged
     */
    override fun read(path: Path, notices: MutableList<String>): List<Snapshot> = H5mdReader.read(path, notices)

    /** Vectors with a value for each time. */
    internal val CHANGING = NUMBERED.filter { it.change != NEVER }

    /** Numbers that are written once, unless they change. */
    internal val FIXED = NUMBERED.filter { it.change == NEVER }
    internal const val SPECIES = "species"

    /**
     * Group of pairs, and its dataset of those that are bound: lower and higher id of each in turn, of one state. The
     * attribute of that name of the group `parameters` is their number, also where that is 0.
     */
    internal const val CONNECTIVITY = "connectivity"
    internal const val BOUND = "bound"

    /** Attribute of the group `parameters`. */
    internal const val MATERIALS = "materials"
}
