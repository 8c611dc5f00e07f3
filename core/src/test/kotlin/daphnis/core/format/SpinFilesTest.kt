package daphnis.core.format

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.cluster.MessageWriter
import daphnis.core.cluster.SphereBlock
import daphnis.core.collision.Counter
import daphnis.core.input.SiUnits
import daphnis.core.population.Population
import daphnis.core.population.SphereQuantity
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import daphnis.core.run.Checkpoint
import daphnis.core.run.CheckpointMeta
import daphnis.core.run.SpheresById
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path

/** What carries spheres carries their spins, and no others. */
class SpinFilesTest {
    @TempDir
    lateinit var home: Path

    private val boundary = Periodic(Box.centred(12.0, 11.0, 10.0))
    private val smooth = randomSpheres(30, boundary, 8, 1.0) { it.nextDouble(0.2, 0.6) }
    private val spun = smooth.withSpin(
        DoubleArray(30) { 0.1 * it },
        DoubleArray(30) { -0.2 * it },
        DoubleArray(30) { 1.0 / (1 + it) },
    )

    private fun state(p: Population, k: Int = 0) = Snapshot.of(p, boundary, 10L * k, 0.5 * k)

    @Test
    fun `formats which have columns for them keep spins, the others and smooth spheres have none`() {
        val keep = listOf(H5md, ExtendedXyz, LammpsDump, CartAndRad)
        for (format in SnapshotFormats.writable.filter { it is ReadableFormat }) {
            for (p in listOf(smooth, spun)) {
                val directory = Files.createDirectories(home.resolve("${format.word}-${p.hasSpin}"))
                val file = format.export(sequenceOf(state(p)), directory, ExportOptions("test")).path
                val back = SnapshotFormats.read(
                    if (Files.isDirectory(file)) file.toFile().listFiles()!![0].toPath() else file,
                )[0]
                assertEquals(p.hasSpin && format in keep, back.hasSpin, format.word)
                if (back.hasSpin) {
                    for (place in 8..10) {
                        assertArrayEquals(
                            p.column(place),
                            back.column(place),
                            format.word,
                        )
                    }
                }
                if (format == H5md) assertEquals(stateDigest(p), stateDigest(back.population()))
                assertEquals(if (back.hasSpin) 11 else 8, back.columnNames.size)
            }
        }
    }

    @Test
    fun `a file of VTK has spins as vectors of points where there are any`() {
        for (p in listOf(smooth, spun)) {
            val file = home.resolve("${p.hasSpin}.vtp")
            Vtp.write(state(p), file)
            val bytes = Files.readAllBytes(file)
            val text = String(bytes, Charsets.ISO_8859_1)
            val array =
                Regex("Name=\"angular_velocity\" NumberOfComponents=\"3\" format=\"appended\" offset=\"(\\d+)\"")
            val offset = array.find(text)?.groupValues?.get(1)?.toInt()
            assertEquals(p.hasSpin, offset != null)
            if (offset == null) continue
            // The data begin behind the underscore, each array with its length in front.
            val begin = text.indexOf('_', text.indexOf("<AppendedData")) + 1 + offset
            val data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).position(begin)
            assertEquals(30 * 3 * 8L, data.getLong())
            for (k in 0 until 30) for (w in listOf(p.wx, p.wy, p.wz)) assertEquals(w[k], data.getDouble())
        }
    }

    @Test
    fun `a table has spins in columns of their names`() {
        val file = home.resolve("a.csv")
        Files.writeString(file, "x,y,z,radius,omegay,omegax,omegaz\n0,0,0,1,5,4,6\n")
        val p = ParticleCsv.population(file)
        assertEquals(listOf(4.0, 5.0, 6.0), listOf(p.wx[0], p.wy[0], p.wz[0]))
        Files.writeString(file, "x,y,z,radius\n0,0,0,1\n")
        assertFalse(ParticleCsv.population(file).hasSpin)
    }

    @Test
    fun `spins in SI units are per second`() {
        val si = SiUnits(2.0, 0.5, 3.0).convert(state(spun))
        assertEquals(2 * spun.wy[7], si.wy[7])
        assertSame(SphereQuantity.NONE, SiUnits(2.0, 0.5, 3.0).convert(state(smooth)).wy)
    }

    @Test
    fun `a checkpoint has spins where there are any, and says nothing of them elsewhere`() {
        val meta = CheckpointMeta(7, 0.5, Counter.entries.associate { it.key to 0L }, 1.5)
        val sizes = listOf(smooth, spun).map { p ->
            val file = home.resolve("checkpoint-${p.hasSpin}")
            Checkpoint.write(meta, "{}", SpheresById(p), emptyMap(), file)
            val text = Files.readString(file, Charsets.ISO_8859_1)
            val back = Checkpoint.read(file).population
            assertEquals(p.hasSpin, back.hasSpin)
            assertEquals(stateDigest(p), stateDigest(back))
            for (record in SphereQuantity.SPIN.records) assertEquals(p.hasSpin, record in text) { record }
            Files.size(file)
        }
        // Three records, each with a name, a length and a checksum.
        assertEquals(3 * (30 * 8 + 4 + 8 + 4), (sizes[1] - sizes[0]).toInt())
    }

    @Test
    fun `a message between nodes has spins also where it has no spheres`() {
        for (p in listOf(smooth, spun)) {
            for (count in listOf(0, 13)) {
                val message = MessageWriter().also { SphereBlock.write(it, p, 2, 2 + count) }.message()
                assertEquals(SphereBlock.bytes(p, count), message.remaining())
                val back = SphereBlock.read(message)
                assertEquals(p.hasSpin, back.hasSpin)
                assertEquals(count, back.size)
                if (p.hasSpin) assertArrayEquals(p.wz.copyOfRange(2, 2 + count), back.wz)
                assertTrue(!message.hasRemaining())
            }
        }
    }
}
