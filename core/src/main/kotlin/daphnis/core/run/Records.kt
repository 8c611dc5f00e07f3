package daphnis.core.run

import daphnis.core.format.reasonOf
import java.io.DataInputStream
import java.io.DataOutputStream
import java.io.EOFException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32C

/** The records of a checkpoint file by name, see [Checkpoint]. */
internal class Records private constructor(val version: Int, private val bytes: Map<String, ByteArray>) {
    operator fun contains(name: String): Boolean = name in bytes

    /** Refuses a record that is none of [names]: the checksums do not cover the names. */
    fun requireOnly(names: Set<String>) {
        for (name in bytes.keys - names) throw IllegalArgumentException("record ${printable(name)} is unknown")
    }

    fun bytes(name: String): ByteArray = requireNotNull(bytes[name]) { "record $name is missing" }

    fun text(name: String): String = String(bytes(name), Charsets.UTF_8)

    fun integers(name: String): IntArray = ByteBuffer.wrap(bytes(name)).asIntBuffer().let { b ->
        IntArray(b.remaining()).also { b.get(it) }
    }

    fun doubles(name: String): DoubleArray = ByteBuffer.wrap(bytes(name)).asDoubleBuffer().let { b ->
        DoubleArray(b.remaining()).also { b.get(it) }
    }

    companion object {
        const val VERSION = 4
        const val END = "END."
        const val MAGIC = 0x444150484e49530aL
        const val OLDEST = 2

        /**
         * Reads the records of [path] up to [last], which is among them if it is [END].
         *
         * @throws CheckpointException with one line that says what is wrong with the file
         */
        fun read(path: Path, last: String): Records {
            try {
                DataInputStream(Files.newInputStream(path).buffered(1 shl 16)).use { input ->
                    if (input.readLong() != MAGIC) throw CheckpointException("$path: is not a checkpoint of daphnis")
                    val version = input.readInt()
                    if (version !in OLDEST..VERSION) throw CheckpointException("$path: ${unknown(version)}")
                    return Records(version, readAll(input, path, last))
                }
            } catch (e: EOFException) {
                throw CheckpointException("$path: is cut short")
            } catch (e: IOException) {
                throw CheckpointException("$path: cannot be read: ${reasonOf(e, path)}")
            }
        }

        private fun unknown(version: Int): String {
            val whose = if (version > VERSION) "was written by a newer version of daphnis" else "is a checkpoint of old"
            return "$whose, format $version, or is damaged; this daphnis reads formats $OLDEST to $VERSION"
        }

        private fun readAll(input: DataInputStream, path: Path, last: String): Map<String, ByteArray> {
            val limit = Files.size(path)
            val records = HashMap<String, ByteArray>()
            while (true) {
                val name = String(ByteArray(4).also { input.readFully(it) }, Charsets.ISO_8859_1)
                if (name == last && name != END) return records
                val length = input.readLong()
                if (length < 0 || length > minOf(limit, LONGEST)) {
                    throw CheckpointException("$path: is damaged: a record says it has $length bytes")
                }
                val bytes = ByteArray(length.toInt()).also { input.readFully(it) }
                if (input.readInt() != checksum(bytes)) {
                    throw CheckpointException("$path: is damaged: the checksum of record ${printable(name)} is wrong")
                }
                if (records.put(name, bytes) != null) {
                    throw CheckpointException("$path: is damaged: record ${printable(name)} is there twice")
                }
                if (name == END) return records
            }
        }

        private fun printable(name: String) = name.map { if (it in ' '..'~') it else '?' }.joinToString("")

        fun checksum(bytes: ByteArray): Int = CRC32C().apply { update(bytes) }.value.toInt()

        private const val LONGEST = Int.MAX_VALUE - 8L
    }
}

/** Writes a checkpoint file, record by record. */
internal class RecordWriter(private val out: DataOutputStream) {
    init {
        out.writeLong(Records.MAGIC)
        out.writeInt(Records.VERSION)
    }

    fun write(name: String, bytes: ByteArray) {
        out.writeBytes(name)
        out.writeLong(bytes.size.toLong())
        out.write(bytes)
        out.writeInt(Records.checksum(bytes))
    }

    fun integers(name: String, numbers: IntArray): Unit =
        write(name, ByteBuffer.allocate(Int.SIZE_BYTES * numbers.size).apply { asIntBuffer().put(numbers) }.array())

    fun doubles(name: String, numbers: DoubleArray): Unit = write(
        name,
        ByteBuffer.allocate(Double.SIZE_BYTES * numbers.size).apply {
            asDoubleBuffer().put(numbers)
        }.array(),
    )

    fun text(name: String, text: String): Unit = write(name, text.toByteArray(Charsets.UTF_8))
}
