package daphnis.core.format.hdf5

import io.jhdf.HdfFile
import io.jhdf.api.Dataset
import io.jhdf.api.dataset.ChunkedDataset
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path

/** Read back by the library that is not ours. */
class Hdf5FileTest {
    @TempDir
    lateinit var home: Path

    private fun write(name: String = "a.h5", fill: (Hdf5File) -> Unit): Path {
        val path = home.resolve(name)
        Hdf5File(path).use {
            fill(it)
            it.finish()
        }
        return path
    }

    private fun <T> read(path: Path, name: String, take: (Dataset) -> T): T =
        HdfFile(path).use { take(it.getDatasetByPath(name)) }

    /** [frames] of [rows] by three numbers, each another one. */
    private fun cubes(file: Hdf5File, frames: Int, rows: Int, isPacked: Boolean = true): GrowingDataset {
        val dataset = GrowingDataset(file, Datatype.DOUBLE, intArrayOf(rows, 3), isPacked)
        repeat(frames) { t ->
            dataset.append { buffer, from, until ->
                for (k in 3 * from until 3 * until) buffer.putDouble(value(t * 3 * rows + k))
            }
        }
        return dataset
    }

    private fun value(k: Int) = Math.sin(k.toDouble())

    @Test
    fun `numbers are where they were put, in frames that share a chunk, fill one, or need several`() {
        for ((frames, rows) in listOf(1 to 1, 7 to 5, 21_900 to 3, 33 to 1000, 3 to 32_768, 2 to 32_769, 3 to 70_001)) {
            val path = write { it.root.put("x", cubes(it, frames, rows)) }
            read(path, "x") { dataset ->
                assertEquals(listOf(frames, rows, 3), dataset.dimensions.toList())
                val seen = dataset.dataFlat as DoubleArray
                assertArrayEquals(DoubleArray(seen.size, ::value), seen) { "$frames frames of $rows" }
                val chunk = (dataset as ChunkedDataset).chunkDimensions
                assertTrue(chunk[0] <= frames && chunk[0] * chunk[1] in 1..32_768) { "${chunk.toList()}" }
                if (frames * rows > 40_000) assertTrue(chunk[0] * chunk[1] > 15_000) { "${chunk.toList()}" }
                assertEquals(-1L, dataset.maxSize[0])
            }
        }
    }

    /** The HDF5 library counts attributes by a message of its own, which jHDF does without. */
    @Test
    fun `a header with attributes says that there are some`() {
        val bytes = Files.readAllBytes(
            write {
                it.root.group("with").attribute("name", "text")
                it.root.group("without")
            },
        )
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        val headers = (0 until bytes.size - 4).filter {
            String(bytes, it, 4, Charsets.ISO_8859_1) == "OHDR"
        }.map { at ->
            val end = at + 10 + buffer.getInt(at + 6)
            generateSequence(at + 10) {
                it + 4 + buffer.getShort(it + 1)
            }.takeWhile { it < end }.map { bytes[it] }.toList()
        }
        // The fourth is of the superblock.
        assertEquals(4, headers.size)
        for (types in headers) assertEquals(0x0C.toByte() in types, 0x15.toByte() in types) { "$types" }
        assertEquals(1, headers.count { 0x15.toByte() in it })
    }

    @Test
    fun `an index of several levels has every chunk`() {
        // Chunks of 1024 numbers: 64 leaves are full at 4096 chunks.
        for (chunks in listOf(1, 8, 9, 64, 65, 4096, 4097)) {
            val path = write { file ->
                val step = GrowingDataset(file, Datatype.LONG, IntArray(0), isPacked = false)
                for (k in 0L until 1024L * chunks) step.append { buffer, _, _ -> buffer.putLong(k * k) }
                file.root.put("step", step)
            }
            val seen = read(path, "step") { it.dataFlat as LongArray }
            assertArrayEquals(LongArray(1024 * chunks) { it.toLong() * it }, seen) { "$chunks chunks" }
        }
    }

    @Test
    fun `groups, attributes and fixed datasets are read`() {
        val path = write { file ->
            val group = file.root.group("outer").group("inner")
            group.attribute("word", "größer")
            group.attribute("words", listOf("a", "", "abc"))
            group.attribute("long", -5L)
            group.attribute("pair", 3, -4)
            group.dataset("ids", IntArray(20_000) { -it })
            group.dataset("masses", doubleArrayOf(1.5, Double.NaN, -0.0)).attribute("unit", "kg")
        }
        HdfFile(path).use { file ->
            val group = file.getByPath("/outer/inner")
            assertEquals("größer", group.getAttribute("word").data)
            assertEquals(listOf("a", "", "abc"), (group.getAttribute("words").data as Array<*>).toList())
            assertEquals(-5L, group.getAttribute("long").data)
            assertArrayEquals(intArrayOf(3, -4), group.getAttribute("pair").data as IntArray)
            assertArrayEquals(IntArray(20_000) { -it }, file.getDatasetByPath("/outer/inner/ids").data as IntArray)
            val masses = file.getDatasetByPath("/outer/inner/masses")
            assertArrayEquals(doubleArrayOf(1.5, Double.NaN, -0.0), masses.data as DoubleArray)
            assertEquals("kg", masses.getAttribute("unit").data)
        }
    }

    @Test
    fun `a dataset of two names is there once, and the same content gives the same bytes`() {
        fun one(name: String, times: Int) = write(name) { file ->
            val data = cubes(file, 4, 100)
            repeat(times) { file.root.put("name$it", data) }
        }
        val twice = one("b", 2)
        HdfFile(twice).use {
            assertEquals(it.getDatasetByPath("name0").address, it.getDatasetByPath("name1").address)
        }
        assertTrue(Files.size(twice) - Files.size(one("a", 1)) in 1..50)
        assertArrayEquals(Files.readAllBytes(twice), Files.readAllBytes(one("c", 2)))
    }

    @Test
    fun `a file that was not finished is no HDF5`() {
        val path = home.resolve("cut.h5")
        Hdf5File(path).use { it.root.put("x", cubes(it, 2, 40_000)) }
        assertTrue(Files.size(path) > 1000)
        assertThrows(RuntimeException::class.java) { HdfFile(path).close() }
    }

    @Test
    fun `the checksum of metadata is the one of its author's examples`() {
        assertEquals(0xdeadbeef.toInt(), Lookup3.of(ByteArray(0), 0))
        val text = "Four score and seven years ago".toByteArray()
        assertEquals(0x17770551, Lookup3.of(text, text.size))
    }
}
