package daphnis.core.format

import daphnis.core.format.Kept.Presence.IF_THERE
import java.io.IOException
import java.io.Writer
import java.nio.file.Files
import java.nio.file.Path

/** Extended XYZ, the text format of OVITO and ASE. */
public object ExtendedXyz : ReadableFormat, WritableFormat {
    override val title: String = "extended XYZ"
    override val extensions: List<String> = listOf("xyz", "extxyz")
    override val isText: Boolean = true
    override val keeps: Kept = Kept(masses = IF_THERE, velocities = IF_THERE, ids = IF_THERE, severalStates = true)
    override val word: String = "xyz"
    override val programs: String = "OVITO, ASE"
    override val takesScale: Boolean = true

    /** Writes `trajectory.xyz`. The default scale is the [suitableScale] of the first state. */
    override fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported {
        val file = directory.resolve("trajectory.xyz")
        var scale = options.scale
        wholeFile(file) { part ->
            Files.newBufferedWriter(part).use { out ->
                for (snapshot in snapshots) write(snapshot, out, scale ?: suitableScale(snapshot).also { scale = it })
            }
        }
        return Exported(file, scale ?: 1.0)
    }

    /**
     * Appends one [snapshot] to [out]. Lengths (and velocities) are multiplied by [scale]: OVITO interprets coordinates
     * that all lie in about [−½, ½] as reduced ones and stretches them to the cell, so small boxes are better given in
     * particle radii. The column `species` has the names of materials, where there are any, and the comment lists them in
     * `Materials`.
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(snapshot: Snapshot, out: Writer, scale: Double = 1.0) {
        out.append(snapshot.size.toString()).append('\n')
        val l = DoubleArray(3) { snapshot.lengths[it] * scale }
        if (l.none { it.isNaN() }) {
            val edges = snapshot.edges().joinToString(" ") { row -> row.joinToString(" ") { (it * scale).toString() } }
            out.append("Lattice=\"$edges\" ")
            out.append("Origin=\"${-l[0] / 2} ${-l[1] / 2} ${-l[2] / 2}\" ")
        }
        val quantities = snapshot.quantities.filter { it in NUMBERED }
        val properties = quantities.joinToString(":") { "${it.xyz[0]}:R:${it.columns.size}" }
        val shift = if (snapshot.image == null) "" else ":${XyzColumns.IMAGE[0]}:I:3"
        out.append("Properties=species:S:1:$properties:id:I:1$shift ")
        if (snapshot.hasMaterials) out.append("Materials=\"${names(snapshot).joinToString(" ")}\" ")
        out.append("Time=${snapshot.time} Step=${snapshot.step} Scale=$scale ")
        out.append("pbc=\"${snapshot.periodic.joinToString(" ") { if (it) "T" else "F" }}\"\n")
        val columns = quantities.flatMap { quantity ->
            snapshot.columns(quantity).map { it to quantity.dimension.of(scale, 1.0, 1.0) }
        }
        val names = if (snapshot.hasMaterials) names(snapshot) else emptyList()
        for (k in 0 until snapshot.size) {
            out.append(if (names.isEmpty()) "X" else names[snapshot.material[k].toInt()])
            for ((column, factor) in columns) out.append(' ').append((column[k] * factor).toString())
            out.append(' ').append(snapshot.id[k].toString())
            snapshot.image?.forEach { out.append(' ').append(it[k].toString()) }
            out.append('\n')
        }
    }

    private fun names(snapshot: Snapshot) =
        snapshot.materials.ifEmpty { List(1 + (snapshot.material.maxOrNull() ?: 0.0).toInt()) { "$it" } }

    /**
     * A scale with which OVITO does not interpret lengths as reduced coordinates: 1 for boxes longer than 4, else 1 /
     * mean radius.
     */
    @JvmStatic
    public fun suitableScale(snapshot: Snapshot): Double {
        val longest =
            snapshot.lengths.filter { !it.isNaN() }.maxOrNull()
                ?: snapshot.position.maxOf { a -> a.maxOfOrNull { Math.abs(it) } ?: 0.0 } * 2
        return if (longest > SHORT_BOX || snapshot.size == 0) 1.0 else 1.0 / snapshot.radius.average()
    }

    /**
     * Reads every snapshot of [path]: `Properties` must hold `pos:R:3`; `velo`, `radius` or `diameter`, `mass`, `id` and
     * `map_shift` (boxes crossed) are read where they are there, and are otherwise 0, 1/2, 1, the line number and not
     * known. Where the comment names `Materials`, `species` are of these. ASE's `momenta` are divided by `masses`. A `Lattice` with edges along the axes gives the lengths. One edge
     * may lean along x or y, as sliding images do, and gives the offset. Any other is refused. Lengths and velocities
     * are divided by the `Scale` in the comment line, which is the factor by which [write] multiplied them. Without
     * `Time` there is none ([Snapshot.hasTime]), without `Step` frames are counted.
     *
     * @throws FormatException that names the line of the error
     */
    override fun read(path: Path, notices: MutableList<String>): List<Snapshot> {
        val snapshots = ArrayList<Snapshot>()
        TextLines(path).use { lines ->
            val reader = XyzReader(lines, path, notices)
            while (true) snapshots += reader.snapshot(snapshots.size) ?: break
        }
        return snapshots
    }

    private const val SHORT_BOX = 4.0
}
