package daphnis.core.format

import io.jhdf.HdfFile
import io.jhdf.WritableHdfFile
import io.jhdf.api.DatasetCreationOptions
import io.jhdf.api.WritableDataset
import io.jhdf.api.WritableGroup
import java.nio.file.Path

/**
 * H5MD 1.1 (de Buyl, Colberg & Höfling 2014, Comput. Phys. Commun. 185, 1546): HDF5 that h5py, MDAnalysis and ParaView
 * read. One particle group `all`: position, velocity and image as `{step, time, value[T][N][3]}`; id, mass and radius
 * as plain datasets, radius being an addition of ours; `box/edges` of a box centred on the origin. Units are the
 * scenario's and have no names, or SI by H5MD's module `units`. The attribute `crc32c` of the group `parameters` is a
 * checksum over all that is read ([H5mdChecksum]).
 */
public object H5md {
    /**
     * Writes [frames], all of the same spheres, to [path]. Holds all of them in memory.
     *
     * @param version the version of daphnis to name as creator
     * @param units what the units are in SI units; then the numbers are written in these, and every dataset says its
     *   `unit`
     */
    public fun write(frames: List<Snapshot>, path: Path, version: String, units: SiUnits? = null) {
        require(frames.isNotEmpty()) { "no frame to write" }
        val first = frames.first()
        for (frame in frames) {
            require(frame.id.contentEquals(first.id)) {
                "spheres differ between steps ${first.step} and ${frame.step}; H5MD needs the same in every frame"
            }
        }
        val written = if (units == null) frames else frames.map { units.convert(it) }
        HdfFile.write(path).use { file -> write(written, file, version, units != null) }
    }

    private fun write(frames: List<Snapshot>, file: WritableHdfFile, version: String, si: Boolean) {
        val first = frames.first()
        val names = if (si) UnitNames("m", "s", "m s-1", "kg") else null
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
        if (first.lengths.none { it.isNaN() }) edges(box, frames, names)
        // HDF5 as it is written here has no datasets of size 0: a state without particles says its step and time.
        if (first.size == 0) steps(all.putGroup("position"), frames, names?.time) else particles(all, frames, names)
        val parameters = file.putGroup("parameters")
        parameters.putDataset("shear_offset", DoubleArray(frames.size) { frames[it].shearOffset }).unit(names?.length)
        parameters.putDataset("shear_axes", intArrayOf(first.normalAxis, first.slideAxis))
        parameters.putAttribute(H5mdChecksum.ATTRIBUTE, H5mdChecksum.of(frames))
    }

    private fun particles(all: WritableGroup, frames: List<Snapshot>, names: UnitNames?) {
        val first = frames.first()
        element(all, "position", frames, names?.length, names?.time) { it.position }
        element(all, "velocity", frames, names?.speed, names?.time) { it.velocity }
        if (frames.all { it.image != null }) images(all, frames, names?.time)
        all.putDataset("id", first.id)
        all.putDataset("mass", first.mass).unit(names?.mass)
        all.putDataset("radius", first.radius).unit(names?.length)
    }

    /** Lengths, or rows of edge vectors when images slide; by time either way, as MDAnalysis wants it. */
    private fun edges(box: WritableGroup, frames: List<Snapshot>, names: UnitNames?) {
        val edges = box.putGroup("edges")
        steps(edges, frames, names?.time)
        val slid = frames.any { it.shearOffset != 0.0 }
        val value: Any = if (slid) {
            Array(frames.size) { t ->
                frames[t].edges()
            }
        } else {
            Array(frames.size) { frames[it].lengths }
        }
        edges.putDataset("value", value).unit(names?.length)
    }

    /** What the module `units` calls the unit: symbols with powers, a text of fixed length. */
    private fun WritableDataset.unit(name: String?) {
        if (name != null) putAttribute("unit", name)
    }

    private class UnitNames(val length: String, val time: String, val speed: String, val mass: String)

    private fun steps(element: WritableGroup, frames: List<Snapshot>, time: String?) {
        element.putDataset("step", LongArray(frames.size) { frames[it].step })
        element.putDataset("time", DoubleArray(frames.size) { frames[it].time }).unit(time)
    }

    private fun element(
        group: WritableGroup,
        name: String,
        frames: List<Snapshot>,
        unit: String?,
        time: String?,
        of: (Snapshot) -> Array<DoubleArray>,
    ) {
        val element = group.putGroup(name)
        steps(element, frames, time)
        val value = Array(frames.size) { t ->
            val v = of(frames[t])
            Array(frames[t].size) { k -> doubleArrayOf(v[0][k], v[1][k], v[2][k]) }
        }
        element.putDataset("value", value, options(frames)).unit(unit)
    }

    /** 32-bit integers: how often each sphere crossed the box along x, y, z. */
    private fun images(group: WritableGroup, frames: List<Snapshot>, time: String?) {
        val element = group.putGroup("image")
        steps(element, frames, time)
        val value = Array(frames.size) { t ->
            val image = checkNotNull(frames[t].image)
            Array(frames[t].size) { k -> intArrayOf(image[0][k], image[1][k], image[2][k]) }
        }
        element.putDataset("value", value, options(frames))
    }

    private fun options(frames: List<Snapshot>) = DatasetCreationOptions.builder().chunkDimensions(
        1,
        minOf(frames.first().size, CHUNK),
        3,
    ).shuffle().deflate(DEFLATE).build()

    /**
     * Reads every frame of a file that [write] wrote, or that has the same datasets of numbers of any width. One
     * without a checksum, of an older version or another program, is taken as it is.
     *
     * @throws FormatException when it is no such file, or is damaged
     */
    public fun read(path: Path): List<Snapshot> = H5mdReader.read(path)

    private const val CHUNK = 32_768
    private const val DEFLATE = 4
}
