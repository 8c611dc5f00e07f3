package daphnis.core.format

import daphnis.core.format.Kept.Presence.IF_THERE
import java.io.IOException
import java.io.Writer
import java.nio.file.Files
import java.nio.file.Path

/**
 * The text format of LAMMPS' `dump custom`, which OVITO and VMD read too: any number of states, each with the box and a
 * table of particles whose columns are named, boxes crossed among them (`ix iy iz`) where they are known. Sliding
 * images are a tilted box: `xy` when they slide along x, a general triclinic one (`abc origin`) along y. The type of a
 * particle is the number of its material, from 1 on, as LAMMPS counts.
 */
public object LammpsDump : ReadableFormat, WritableFormat {
    override val title: String = "LAMMPS dump"
    override val extensions: List<String> = listOf("lammpstrj", "dump")
    override val prefix: String = "dump."
    override val isText: Boolean = true

    /** LAMMPS writes particles as its processors have them, which changes as they move. */
    override val keeps: Kept =
        Kept(masses = IF_THERE, velocities = IF_THERE, ids = IF_THERE, severalStates = true, keepsOrder = false)
    override val word: String = "lammps"
    override val programs: String = "LAMMPS, OVITO"

    /** Writes `trajectory.lammpstrj`. */
    override fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported {
        val file = directory.resolve("trajectory.lammpstrj")
        wholeFile(file) { part ->
            Files.newBufferedWriter(part).use { out ->
                // Ids of one file are from 1 in every state, or as they are in every state.
                var isFromZero: Boolean? = null
                for (snapshot in snapshots) {
                    write(snapshot, out, isFromZero ?: (0 in snapshot.id).also { isFromZero = it })
                }
            }
        }
        return Exported(file)
    }

    /**
     * Appends one [snapshot] to [out]. Along open axes the bounds are those of the spheres.
     *
     * @param isFromZero whether ids are from 0, which LAMMPS refuses: then those in the file are higher by 1, and a
     *   column `i_daphnis`, from which they are read back, has them as they are
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(snapshot: Snapshot, out: Writer, isFromZero: Boolean = 0 in snapshot.id) {
        out.append("ITEM: TIME\n${snapshot.time}\nITEM: TIMESTEP\n${snapshot.step}\n")
        out.append("ITEM: NUMBER OF ATOMS\n${snapshot.size}\n")
        bounds(snapshot, out)
        val own = if (isFromZero) " ${LammpsColumns.OWN_ID}" else ""
        val quantities = snapshot.quantities.filter { it in NUMBERED }
        val names = quantities.flatMap { it.columns }.joinToString(" ")
        val columns = quantities.flatMap { snapshot.columns(it) }
        val types = if (snapshot.hasMaterials) snapshot.material else null
        val flags = if (snapshot.image == null) "" else " ${LammpsColumns.IMAGE.joinToString(" ")}"
        out.append("ITEM: ATOMS id type $names$flags$own\n")
        for (k in 0 until snapshot.size) {
            out.append("${snapshot.id[k] + if (isFromZero) 1L else 0L} ${1 + (types?.get(k)?.toInt() ?: 0)}")
            for (column in columns) out.append(' ').append(column[k].toString())
            snapshot.image?.forEach { out.append(' ').append(it[k].toString()) }
            out.append(if (isFromZero) " ${snapshot.id[k]}\n" else "\n")
        }
    }

    private fun bounds(snapshot: Snapshot, out: Writer) {
        val low = DoubleArray(3) { axis -> edge(snapshot, axis, -1.0) }
        val high = DoubleArray(3) { axis -> edge(snapshot, axis, 1.0) }
        val faces = (0..2).joinToString(" ") { axis ->
            if (snapshot.lengths[axis].isNaN()) {
                "ss"
            } else if (snapshot.periodic[axis]) {
                "pp"
            } else {
                "ff"
            }
        }
        val offset = snapshot.shearOffset
        if (offset == 0.0) {
            out.append("ITEM: BOX BOUNDS $faces\n")
            for (axis in 0..2) out.append("${low[axis]} ${high[axis]}\n")
        } else if (snapshot.normalAxis == 1 && snapshot.slideAxis == 0) {
            // The bounds along x are those of the whole tilted box.
            out.append("ITEM: BOX BOUNDS xy xz yz $faces\n")
            out.append("${low[0] + minOf(0.0, offset)} ${high[0] + maxOf(0.0, offset)} $offset\n")
            for (axis in 1..2) out.append("${low[axis]} ${high[axis]} 0.0\n")
        } else {
            out.append("ITEM: BOX BOUNDS abc origin $faces\n")
            for (row in 0..2) {
                val edge = DoubleArray(3) { if (it == row) high[row] - low[row] else 0.0 }
                if (row == snapshot.normalAxis) edge[snapshot.slideAxis] = offset
                out.append("${edge[0]} ${edge[1]} ${edge[2]} ${low[row]}\n")
            }
        }
    }

    private fun edge(snapshot: Snapshot, axis: Int, side: Double): Double {
        val length = snapshot.lengths[axis]
        if (!length.isNaN()) return side * length / 2
        val position = snapshot.position[axis]
        return side * (position.indices.maxOfOrNull { side * position[it] + snapshot.radius[it] } ?: 0.0)
    }

    /**
     * Reads every state of [path]. Columns `x y z` (or `xu yu zu`, or scaled `xs ys zs`, `xsu ysu zsu`) are needed.
     * `id`, `vx vy vz`, `radius` or `diameter` and `mass` are read where they are there, and are otherwise the place in
     * the file, 0, 1/2 and 1. Boxes crossed are `ix iy iz`, or none where positions go on beyond the box. The time is
     * `ITEM: TIME`; without it there is none ([Snapshot.hasTime]).
     *
     * @throws FormatException that names the line of the error
     */
    override fun read(path: Path, notices: MutableList<String>): List<Snapshot> {
        val snapshots = ArrayList<Snapshot>()
        TextLines(path).use { lines ->
            val reader = LammpsDumpReader(lines, path, notices)
            while (true) snapshots += reader.snapshot() ?: break
        }
        return snapshots
    }
}
