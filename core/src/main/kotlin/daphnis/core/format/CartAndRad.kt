package daphnis.core.format

import daphnis.core.boundary.Open
import daphnis.core.format.Kept.Presence.ALWAYS
import daphnis.core.format.Kept.Presence.NEVER
import daphnis.core.population.Population
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.Channels
import java.nio.file.Files
import java.nio.file.Path

/**
 * CartAndRad, the binary format of SwiftVis: little-endian int32 N; N × 6 float64 (x y z vx vy vz); N float64 radius;
 * where spheres have spins, N × 3 float64 (ωx ωy ωz). Spheres are in the order of their ids; ids and masses are not kept.
 */
public object CartAndRad : ReadableFormat, WritableFormat {
    override val title: String = "CartAndRad"
    override val extensions: List<String> = listOf("bin", "cartandrad")

    /** SwiftVis puts the number of a file after the word. */
    override val mark: String = "cartandrad"
    override val keeps: Kept = Kept(masses = NEVER, velocities = ALWAYS, ids = NEVER, severalStates = false)
    override val word: String = "cartandrad"
    override val programs: String = "SwiftVis"

    /** Writes `CartAndRad.STEP.bin` for each state. */
    override fun export(snapshots: Sequence<Snapshot>, directory: Path, options: ExportOptions): Exported {
        var hadMaterials = false
        for (snapshot in snapshots) {
            hadMaterials = hadMaterials || snapshot.hasMaterials
            wholeFile(directory.resolve("CartAndRad.${snapshot.step}.bin")) { write(snapshot.population(), it) }
        }
        val what = if (hadMaterials) "masses, ids and materials" else "masses and ids"
        val left = "CartAndRad cannot store $what; they are left out, " +
            "and spheres are in the order of their ids"
        return Exported(directory, remark = left)
    }

    /** Reads [path] as a state at step and time 0, masses from density 1. */
    override fun read(path: Path, notices: MutableList<String>): List<Snapshot> {
        val snapshot = Snapshot.of(population(path), Open, 0, 0.0, hasMass = false).with(hasTime = false, hasId = false)
        SnapshotCheck.check(snapshot, "$path")
        return listOf(snapshot)
    }

    /** Writes [population] to [path], replacing it. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(population: Population, path: Path) {
        val order = population.indicesById()
        Files.newOutputStream(path).buffered(1 shl 16).use { stream ->
            val channel = Channels.newChannel(stream)
            val buffer = ByteBuffer.allocate(ROW).order(ByteOrder.LITTLE_ENDIAN)
            buffer.putInt(order.size).flip()
            channel.write(buffer)
            for (k in order) {
                buffer.clear()
                buffer.putDouble(population.x[k]).putDouble(population.y[k]).putDouble(population.z[k])
                buffer.putDouble(population.vx[k]).putDouble(population.vy[k]).putDouble(population.vz[k])
                channel.write(buffer.flip())
            }
            for (k in order) {
                buffer.clear()
                channel.write(buffer.putDouble(population.radius[k]).flip())
            }
            if (population.hasSpin) {
                for (k in order) {
                    buffer.clear()
                    buffer.putDouble(population.wx[k]).putDouble(population.wy[k]).putDouble(population.wz[k])
                    channel.write(buffer.flip())
                }
            }
        }
    }

    /**
     * Reads [path]; ids are 0, 1, 2, …
     *
     * @param density mass per volume, since the file has no masses
     * @throws FormatException when the length does not agree with N, with or without three numbers of spin for each, a
     *   number is not finite, or a radius is not positive
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun population(path: Path, density: Double = 1.0): Population = population(contents(path), path, density)

    /** The bytes of a file that is as long as its number of spheres says. */
    private fun contents(path: Path): ByteArray {
        val longest = PackedFile.mostBytes(path)
        val head = PackedFile.open(path).use { it.readNBytes(4) }
        if (head.size < 4 || Files.size(path) > Int.MAX_VALUE) {
            throw FormatException("$path: ${Files.size(path)} bytes is no CartAndRad file")
        }
        val n = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN).getInt()
        fun refused(bytes: Long) =
            FormatException("$path: declares $n spheres, which would be ${size(n, false)} bytes; it has $bytes")
        if (n < 0 || size(n, false) > minOf(longest, LARGEST)) throw refused(Files.size(path))
        val all = PackedFile.open(path).use { it.readNBytes(minOf(size(n, true) + 1, LARGEST).toInt()) }
        if (all.size.toLong() in listOf(size(n, false), size(n, true))) return all
        throw refused(maxOf(all.size.toLong(), if (PackedFile.isPacked(path)) 0 else Files.size(path)))
    }

    private fun population(bytes: ByteArray, path: Path, density: Double): Population {
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val n = buffer.getInt()
        val columns = Array(6) { DoubleArray(n) }
        for (k in 0 until n) for (c in columns) c[k] = buffer.getDouble()
        val radius = DoubleArray(n) { buffer.getDouble() }
        for (k in 0 until n) {
            if (radius[k] !in SnapshotCheck.LEAST..SnapshotCheck.MOST) {
                val right = "> 0, ${SnapshotCheck.LEAST} to ${SnapshotCheck.MOST}"
                throw FormatException("$path: the radius of particle $k is ${radius[k]}; it must be $right")
            }
        }
        val mass = DoubleArray(n) { density * 4.0 / 3.0 * Math.PI * radius[it] * radius[it] * radius[it] }
        val spins = if (buffer.hasRemaining()) Array(3) { DoubleArray(n) } else null
        if (spins != null) for (k in 0 until n) for (w in spins) w[k] = buffer.getDouble()
        return try {
            val smooth =
                Population(columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], radius, mass)
            if (spins == null) smooth else smooth.withSpin(spins[0], spins[1], spins[2])
        } catch (e: IllegalArgumentException) {
            throw FormatException("$path: ${e.message}")
        }
    }

    /** Size of a file of [n] spheres, with or without their spins. */
    private fun size(n: Int, hasSpins: Boolean): Long = 4L + (ROW + 8L + if (hasSpins) SPIN else 0) * n

    private const val ROW = 48

    /** Three numbers, behind all radii. */
    private const val SPIN = 24

    /** The longest array. */
    private const val LARGEST = Int.MAX_VALUE - 8L
}
