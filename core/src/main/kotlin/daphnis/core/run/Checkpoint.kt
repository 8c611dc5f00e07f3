package daphnis.core.run

import daphnis.core.population.Population
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import java.io.DataInputStream
import java.io.DataOutputStream
import java.io.EOFException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32C

/**
 * All that a run needs to go on to the same bits.
 *
 * The file: the eight bytes `DAPHNIS\n`, an int with the version of the format, then records, each a four-letter name, a long with the
 * length of what follows, that many bytes, and their CRC-32C as an int; all big-endian. `META` is JSON ([CheckpointMeta]); `IDS `,
 * `POSX` … `IMGZ` are arrays in the order of ids; `END.` is empty and last. A file cut short or with flipped bytes does not pass.
 */
internal class Checkpoint(val meta: CheckpointMeta, val population: Population) {
    companion object {
        const val VERSION = 2
        private val IMAGES = listOf("IMGX", "IMGY", "IMGZ")
        private const val MAGIC = 0x444150484e49530aL
        private val json = Json { encodeDefaults = true }

        fun write(meta: CheckpointMeta, population: Population, path: Path) {
            val order = population.indicesById()
            DataOutputStream(Files.newOutputStream(path).buffered(1 shl 16)).use { out ->
                out.writeLong(MAGIC)
                out.writeInt(VERSION)
                record(out, "META", json.encodeToString(CheckpointMeta.serializer(), meta).toByteArray(Charsets.UTF_8))
                val ids = ByteBuffer.allocate(4 * order.size)
                for (k in order) ids.putInt(population.id[k])
                record(out, "IDS ", ids.array())
                for ((name, column) in columns(population)) {
                    val bytes = ByteBuffer.allocate(8 * order.size)
                    for (k in order) bytes.putDouble(column[k])
                    record(out, name, bytes.array())
                }
                for ((axis, name) in IMAGES.withIndex()) {
                    val bytes = ByteBuffer.allocate(4 * order.size)
                    for (k in order) bytes.putInt(population.boxesCrossed(population.id[k], axis))
                    record(out, name, bytes.array())
                }
                record(out, "END.", ByteArray(0))
            }
        }

        private fun columns(p: Population) = listOf(
            "POSX" to p.x, "POSY" to p.y, "POSZ" to p.z, "VELX" to p.vx, "VELY" to p.vy, "VELZ" to p.vz,
            "RADI" to p.radius, "MASS" to p.mass, "LAST" to p.lastCollision,
        )

        private fun record(out: DataOutputStream, name: String, bytes: ByteArray) {
            out.writeBytes(name)
            out.writeLong(bytes.size.toLong())
            out.write(bytes)
            out.writeInt(checksum(bytes))
        }

        private fun checksum(bytes: ByteArray): Int = CRC32C().apply { update(bytes) }.value.toInt()

        /** @throws CheckpointException that says in one line what is wrong with the file */
        fun read(path: Path): Checkpoint {
            try {
                DataInputStream(Files.newInputStream(path).buffered(1 shl 16)).use { input ->
                    if (input.readLong() != MAGIC) throw CheckpointException("$path: is not a checkpoint of daphnis")
                    val version = input.readInt()
                    if (version != VERSION) throw OtherVersionException("$path: is a checkpoint of format $version, this daphnis reads format $VERSION")
                    val limit = Files.size(path)
                    val records = HashMap<String, ByteArray>()
                    while ("END." !in records) readRecord(input, limit, path, records)
                    return decode(records, path)
                }
            } catch (e: EOFException) {
                throw CheckpointException("$path: is cut short")
            } catch (e: IOException) {
                throw CheckpointException("$path: cannot be read: ${e.message}")
            }
        }

        private fun readRecord(input: DataInputStream, limit: Long, path: Path, records: HashMap<String, ByteArray>) {
            val name = String(ByteArray(4).also { input.readFully(it) }, Charsets.ISO_8859_1)
            val length = input.readLong()
            if (length < 0 || length > limit) throw CheckpointException("$path: is damaged: a record says it has $length bytes")
            val bytes = ByteArray(length.toInt()).also { input.readFully(it) }
            if (input.readInt() != checksum(bytes)) throw CheckpointException("$path: is damaged: the checksum of record $name is wrong")
            records[name] = bytes
        }

        private fun decode(records: Map<String, ByteArray>, path: Path): Checkpoint = try {
            val meta = json.decodeFromString(CheckpointMeta.serializer(), String(records.getValue("META"), Charsets.UTF_8))
            fun integers(name: String) = ByteBuffer.wrap(records.getValue(name)).asIntBuffer().let { b -> IntArray(b.remaining()).also { b.get(it) } }
            val ids = integers("IDS ")
            fun column(name: String) = ByteBuffer.wrap(records.getValue(name)).asDoubleBuffer().let { b -> DoubleArray(b.remaining()).also { b.get(it) } }
            val population = Population(
                column("POSX"), column("POSY"), column("POSZ"), column("VELX"), column("VELY"), column("VELZ"),
                column("RADI"), column("MASS"), ids,
            )
            column("LAST").copyInto(population.lastCollision)
            for ((axis, name) in IMAGES.withIndex()) {
                integers(name).forEachIndexed { k, boxes -> if (boxes != 0) population.addCrossing(k, axis, boxes) }
            }
            Checkpoint(meta, population)
        } catch (e: RuntimeException) {
            throw CheckpointException("$path: is damaged: ${e.message}")
        }
    }
}

/**
 * What a checkpoint knows beside the spheres.
 *
 * @property fileLengths length in bytes of each file that is only appended to, by name in the run directory; what lies beyond was
 *   written after the checkpoint and is cut off on resume
 * @property collisionSums of the statistics of collisions, when they are kept; likewise [impactSpeeds]
 */
@Serializable
internal class CheckpointMeta(
    val step: Long,
    val time: Double,
    val collisions: Long,
    val wallCollisions: Long,
    val guardActivations: Long,
    val redoneSteps: Long,
    val causalityReplays: Long,
    val wallSeconds: Double,
    val fileLengths: Map<String, Long>,
    val collisionSums: List<Double> = emptyList(),
    val impactSpeeds: List<Long> = emptyList(),
)

/** A checkpoint cannot be used; the message is one line that says why. */
internal open class CheckpointException(message: String) : RuntimeException(message)

/** A checkpoint of another version of the format: not damaged, but not for us. */
internal class OtherVersionException(message: String) : CheckpointException(message)
