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
 * CartAndRad, the binary format of SwiftVis: little-endian int32 N; N × 6 float64 (x y z vx vy vz); N float64 radius.
 * Spheres are in the order of their ids; ids and masses are not kept.
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
        for (snapshot in snapshots) {
            wholeFile(directory.resolve("CartAndRad.${snapshot.step}.bin")) { write(snapshot.population(), it) }
        }
        val left = "CartAndRad cannot store masses and ids; they are left out, " +
            "and spheres are in the order of their ids"
        return Exported(directory, remark = left)
    }

    /** Reads [path] as a state at step and time 0, masses from density 1. */
    override fun read(path: Path): List<Snapshot> {
        val snapshot = Snapshot.of(population(path), Open, 0, 0.0, hasMass = false)
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
        }
    }

    /**
     * Reads [path]; ids are 0, 1, 2, …
     *
     * @param density mass per volume, since the file has no masses
     * @throws FormatException when the length does not agree with N, a number is not finite, or a radius is not
     *   positive
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun population(path: Path, density: Double = 1.0): Population {
        val size = Files.size(path)
        if (size < 4 || size > Int.MAX_VALUE) throw FormatException("$path: $size bytes is no CartAndRad file")
        val head = Files.newInputStream(path).use { it.readNBytes(4) }
        val n = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN).getInt()
        if (n < 0 || size != 4L + (ROW + 8L) * n) {
            val needed = 4L + (ROW + 8L) * n
            throw FormatException("$path: declares $n spheres, which would be $needed bytes; it has $size")
        }
        val buffer = ByteBuffer.wrap(Files.readAllBytes(path)).order(ByteOrder.LITTLE_ENDIAN).position(4)
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
        return try {
            Population(columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], radius, mass)
        } catch (e: IllegalArgumentException) {
            throw FormatException("$path: ${e.message}")
        }
    }

    private const val ROW = 48
}
