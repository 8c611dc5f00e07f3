package daphnis.core.format

import daphnis.core.format.Kept.Presence.IF_THERE
import daphnis.core.population.SphereQuantity
import daphnis.core.population.SphereQuantity.Change.NEVER
import io.jhdf.HdfFile
import io.jhdf.WritableHdfFile
import io.jhdf.api.DatasetCreationOptions
import io.jhdf.api.WritableDataset
import io.jhdf.api.WritableGroup
import java.io.IOException
import java.nio.file.Path

/**
 * H5MD 1.1 (de Buyl, Colberg & Höfling 2014, Comput. Phys. Commun. 185, 1546): HDF5 that h5py, MDAnalysis and ParaView
 * read. One particle group `all`: position, velocity and image as `{step, time, value[T][N][3]}`; id, mass and radius
 * as plain datasets, where radius is our addition, and species where there are materials, whose names are the attribute
 * `materials` of the group `parameters`; `box/edges` of a box centred on the origin. Units are the scenario's
 * and have no names, or are SI with H5MD's module `units`. The attribute `crc32c` of the group `parameters` is a
 * checksum over everything that is read ([H5mdChecksum]).
 */
public object H5md : ReadableFormat, WritableFormat {
    override val title: String = "H5MD"
    override val extensions: List<String> = listOf("h5", "h5md")
    override val keeps: Kept =
        Kept(IF_THERE, IF_THERE, IF_THERE, severalStates = true, changingParticles = false)
    override val word: String = "h5md"
    override val programs: String = "h5py, MDAnalysis"
    override val takesUnits: Boolean = true

    /** Writes `trajectory.h5`, or `trajectory-si.h5` in SI units. Holds all [snapshots] in memory. */
    override fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported {
        val si = options.units != null
        val file = directory.resolve(if (si) "trajectory-si.h5" else "trajectory.h5")
        val states = snapshots.toList()
        wholeFile(file) { write(states, it, options.version, options.units) }
        val nameless = "units are the scenario's and have no names; MDAnalysis opens the file with convert_units=False"
        return Exported(file, remark = if (si) "units are m, s, m s-1 and kg" else nameless)
    }

    /**
     * Writes [snapshots], all of the same spheres, to [path]. Holds all of them in memory.
     *
     * @param version the version of daphnis to name as creator
     * @param units the scenario's units in SI units; then the numbers are written in SI units, and every dataset has
     *   its `unit`
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(snapshots: List<Snapshot>, path: Path, version: String, units: SiUnits? = null) {
        require(snapshots.isNotEmpty()) { "no frame to write" }
        val first = snapshots.first()
        for (snapshot in snapshots) {
            require(snapshot.id.contentEquals(first.id)) {
                "spheres differ between steps ${first.step} and ${snapshot.step}; H5MD needs the same in every frame"
            }
        }
        val written = if (units == null) snapshots else snapshots.map { units.convert(it) }
        HdfFile.write(path).use { file -> write(written, file, version, units != null) }
    }

    private fun write(snapshots: List<Snapshot>, file: WritableHdfFile, version: String, si: Boolean) {
        val first = snapshots.first()
        val names = if (si) UnitNames("m", "s", "kg") else null
        val h5md = file.putGroup("h5md")
        h5md.putAttribute("version", intArrayOf(1, 1))
        h5md.putGroup("author").putAttribute("name", System.getProperty("user.name") ?: "unknown")
        val creator = h5md.putGroup("creator")
        creator.putAttribute("name", "daphnis")
        creator.putAttribute("version", version)
        if (names != null) {
            val module = h5md.putGroup("modules").putGroup("units")
            module.putAttribute("version", intArrayOf(1, 0))
            module.putAttribute("system", "SI")
        }
        val all = file.putGroup("particles").putGroup("all")
        val box = all.putGroup("box")
        box.putAttribute("dimension", 3)
        box.putAttribute("boundary", Array(3) { if (first.periodic[it]) "periodic" else "none" })
        if (first.lengths.none { it.isNaN() }) edges(box, snapshots, names)
        // HDF5 as it is written here has no datasets of size 0, so a state without particles has only step and time.
        if (first.size == 0) {
            steps(all.putGroup("position"), snapshots, names?.time)
        } else {
            particles(all, snapshots, names)
        }
        val parameters = file.putGroup("parameters")
        val offsets = DoubleArray(snapshots.size) { snapshots[it].shearOffset }
        parameters.putDataset("shear_offset", offsets).unit(names?.length)
        parameters.putDataset("shear_axes", intArrayOf(first.normalAxis, first.slideAxis))
        if (first.hasMaterials && first.materials.isNotEmpty()) {
            parameters.putAttribute(MATERIALS, first.materials.toTypedArray())
        }
        parameters.putAttribute(H5mdChecksum.ATTRIBUTE, H5mdChecksum.of(snapshots))
    }

    private fun particles(all: WritableGroup, snapshots: List<Snapshot>, names: UnitNames?) {
        val first = snapshots.first()
        for (quantity in CHANGING) if (quantity in first.quantities) element(all, quantity, snapshots, names)
        if (snapshots.all { it.image != null }) images(all, snapshots, names?.time)
        all.putDataset("id", first.id)
        for (quantity in FIXED) all.putDataset(quantity.title, first.columns(quantity)[0]).unit(names?.of(quantity))
        if (first.hasMaterials) all.putDataset(SPECIES, IntArray(first.size) { first.material[it].toInt() })
    }

    /** Lengths, or rows of edge vectors when images slide; by time in both cases, as MDAnalysis requires. */
    private fun edges(box: WritableGroup, snapshots: List<Snapshot>, names: UnitNames?) {
        val edges = box.putGroup("edges")
        steps(edges, snapshots, names?.time)
        val slid = snapshots.any { it.shearOffset != 0.0 }
        val rows = { Array(snapshots.size) { snapshots[it].edges() } }
        val value: Any = if (slid) rows() else Array(snapshots.size) { snapshots[it].lengths }
        edges.putDataset("value", value).unit(names?.length)
    }

    /** The unit as the module `units` writes it: symbols with powers, a string of fixed length. */
    private fun WritableDataset.unit(name: String?) {
        if (name != null) putAttribute("unit", name)
    }

    private class UnitNames(val length: String, val time: String, val mass: String) {
        fun of(quantity: SphereQuantity): String = quantity.dimension.symbols(length, time, mass)
    }

    private fun steps(element: WritableGroup, snapshots: List<Snapshot>, time: String?) {
        element.putDataset("step", LongArray(snapshots.size) { snapshots[it].step })
        element.putDataset("time", DoubleArray(snapshots.size) { snapshots[it].time }).unit(time)
    }

    private fun element(group: WritableGroup, quantity: SphereQuantity, snapshots: List<Snapshot>, names: UnitNames?) {
        val element = group.putGroup(quantity.title)
        steps(element, snapshots, names?.time)
        val width = quantity.columns.size
        val value: Any = if (width == 1) {
            Array(snapshots.size) { snapshots[it].columns(quantity)[0] }
        } else {
            Array(snapshots.size) { t ->
                val columns = snapshots[t].columns(quantity)
                Array(snapshots[t].size) { k -> DoubleArray(width) { columns[it][k] } }
            }
        }
        element.putDataset("value", value, options(snapshots, width)).unit(names?.of(quantity))
    }

    /** 32-bit integers: how often each sphere crossed the box along x, y, z. */
    private fun images(group: WritableGroup, snapshots: List<Snapshot>, time: String?) {
        val element = group.putGroup("image")
        steps(element, snapshots, time)
        val value = Array(snapshots.size) { t ->
            val image = checkNotNull(snapshots[t].image)
            Array(snapshots[t].size) { k -> intArrayOf(image[0][k], image[1][k], image[2][k]) }
        }
        element.putDataset("value", value, options(snapshots, 3))
    }

    private fun options(snapshots: List<Snapshot>, width: Int): DatasetCreationOptions {
        val rows = minOf(snapshots.first().size, CHUNK)
        val chunk = if (width == 1) intArrayOf(1, rows) else intArrayOf(1, rows, width)
        return DatasetCreationOptions.builder().chunkDimensions(*chunk).shuffle().deflate(DEFLATE).build()
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

    /** Numbers that are written once. */
    internal val FIXED = NUMBERED.filter { it.change == NEVER }
    internal const val SPECIES = "species"

    /** Attribute of the group `parameters`. */
    internal const val MATERIALS = "materials"
    private const val CHUNK = 32_768
    private const val DEFLATE = 4
}
