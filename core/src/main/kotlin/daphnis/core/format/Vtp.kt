package daphnis.core.format

import daphnis.core.format.Kept.Presence.ALWAYS
import daphnis.core.population.SphereQuantity
import java.io.DataOutputStream
import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale

/**
 * VTK PolyData (`.vtp`, XML with raw appended data) for ParaView, one file per snapshot, and the `.pvd` index that
 * gives them their times.
 */
public object Vtp : WritableFormat {
    override val title: String = "VTK PolyData"
    override val keeps: Kept = Kept(masses = ALWAYS, velocities = ALWAYS, ids = ALWAYS, severalStates = false)
    override val word: String = "vtp"
    override val programs: String = "ParaView"

    /** Writes `STEP.vtp` for each state and `trajectory.pvd`, which names them. */
    override fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported {
        val names = snapshots.map { snapshot ->
            val name = "%010d.vtp".format(Locale.ROOT, snapshot.step)
            wholeFile(directory.resolve(name)) { write(snapshot, it) }
            name to snapshot.time
        }.toList()
        return Exported(directory.resolve("trajectory.pvd").also { file -> wholeFile(file) { writeIndex(names, it) } })
    }

    /**
     * Writes one [snapshot]: points, one vertex per sphere, point data radius, velocity, mass, id, and the time as
     * field data.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(snapshot: Snapshot, path: Path) {
        val n = snapshot.size
        val blocks = ArrayList<ByteBuffer>()
        var offset = 0L
        fun block(bytes: Int, fill: (ByteBuffer) -> Unit): Long {
            val at = offset
            val buffer = ByteBuffer.allocate(Math.addExact(bytes, HEADER)).order(ByteOrder.LITTLE_ENDIAN)
            buffer.putLong(bytes.toLong())
            fill(buffer)
            blocks += buffer
            offset += bytes + HEADER
            return at
        }
        val time = block(8) { it.putDouble(snapshot.time) }
        fun numbers(of: List<DoubleArray>) = block(8 * of.size * n) { b ->
            for (k in 0 until n) for (column in of) b.putDouble(column[k])
        }
        val points = numbers(snapshot.columns(SphereQuantity.POSITION))
        val data = (snapshot.quantities - SphereQuantity.POSITION).joinToString("\n") { quantity ->
            val count = if (quantity.columns.size > 1) " NumberOfComponents=\"${quantity.columns.size}\"" else ""
            val at = numbers(snapshot.columns(quantity))
            """<DataArray type="Float64" Name="${quantity.title}"$count format="appended" offset="$at"/>"""
        }
        val id = block(4 * n) { b -> for (i in snapshot.id) b.putInt(i) }
        val connectivity = block(4 * n) { b -> for (k in 0 until n) b.putInt(k) }
        val offsets = block(4 * n) { b -> for (k in 0 until n) b.putInt(k + 1) }
        val timeArray =
            """<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="appended" offset="$time"/>"""
        val pointArray =
            """<DataArray type="Float64" Name="Points" NumberOfComponents="3" format="appended" offset="$points"/>"""
        Files.newOutputStream(path).buffered(1 shl 16).use { out ->
            text(
                out,
                """
                <?xml version="1.0"?>
                <VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
                <PolyData>
                <FieldData>$timeArray</FieldData>
                <Piece NumberOfPoints="$n" NumberOfVerts="$n" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
                <PointData Scalars="radius" Vectors="velocity">
                $data
                <DataArray type="Int32" Name="id" format="appended" offset="$id"/>
                </PointData>
                <Points>$pointArray</Points>
                <Verts>
                <DataArray type="Int32" Name="connectivity" format="appended" offset="$connectivity"/>
                <DataArray type="Int32" Name="offsets" format="appended" offset="$offsets"/>
                </Verts>
                </Piece>
                </PolyData>
                <AppendedData encoding="raw">
                """.lines().joinToString("\n") {
                    it.trim()
                }.trim() + "\n_",
            )
            val raw = DataOutputStream(out)
            for (block in blocks) raw.write(block.array())
            raw.flush()
            text(out, "\n</AppendedData>\n</VTKFile>\n")
        }
    }

    /** Writes the index of [files], given as file name and time. */
    @JvmStatic
    @Throws(IOException::class)
    public fun writeIndex(files: List<Pair<String, Double>>, path: Path) {
        val entries = files.joinToString("") { (name, time) ->
            "<DataSet timestep=\"$time\" group=\"\" part=\"0\" file=\"$name\"/>\n"
        }
        Files.writeString(
            path,
            "<?xml version=\"1.0\"?>\n" +
                "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n" +
                "<Collection>\n$entries</Collection>\n</VTKFile>\n",
        )
    }

    private fun text(out: OutputStream, text: String) {
        out.write(text.toByteArray(Charsets.UTF_8))
    }

    private const val HEADER = 8
}
