package daphnis.core.format

import daphnis.core.population.stateDigest
import io.jhdf.HdfFile
import io.jhdf.api.WritableGroup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.function.ThrowingSupplier
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

/**
 * Files that ask for too much, lead elsewhere or hold what is no state: one line each that says what. The HDF5 ones
 * are from h5py.
 */
class HostileFilesTest {
    @TempDir
    lateinit var home: Path

    private fun fixture(name: String): Path {
        val copy = home.resolve("$name.h5")
        checkNotNull(javaClass.getResourceAsStream("/daphnis/hostile/$name.h5")) {
            name
        }.use { Files.write(copy, it.readAllBytes()) }
        return copy
    }

    private fun assertRefused(path: Path, vararg parts: String) {
        val read = ThrowingSupplier { assertThrows(FormatException::class.java) { SnapshotFormats.read(path) } }
        val e = assertTimeoutPreemptively(Duration.ofSeconds(60), read)
        val message = e.message.orEmpty()
        assertTrue(message.startsWith("$path")) { message }
        assertFalse(message.any { it.isISOControl() }) { message }
        assertTrue(message.length < 500 + "$path".length) { message }
        for (part in parts) assertTrue(part in message) { "'$part' is not in: $message" }
    }

    private fun text(name: String, text: String): Path = Files.writeString(home.resolve(name), text)

    @Test
    fun `H5MD of other widths and byte orders, compressed, or with links within the file is read`() {
        for (name in listOf("big-endian-singles", "compressed")) {
            val frames = H5md.read(fixture(name))
            assertEquals(2, frames.size)
            val last = frames.last()
            assertEquals(listOf(0, 1, 2), last.id.toList()) { name }
            assertEquals(listOf(1.0, 1.0, 1.0), last.position[0].toList()) { name }
            assertEquals(listOf(0.0, 1.5, 3.0), last.velocity[2].toList()) { name }
            assertEquals(0.25, last.radius[2])
            assertEquals(listOf(8.0, 8.0, 8.0), last.lengths.toList())
            assertEquals(1.0, last.time)
        }
        for (name in listOf("soft-link", "cycle")) assertEquals(1.0, H5md.read(fixture(name)).single().mass[1]) { name }
    }

    @Test
    fun `a link to itself or out of the file is not followed`() {
        assertRefused(fixture("self-link"), "mass", "links without end")
        fixture("compressed")
        assertRefused(fixture("external-link"), "mass", "another file")
    }

    @Test
    fun `datasets that are no numbers, or not as many as there are particles, are named`() {
        for (name in listOf("compound-mass", "text-mass")) {
            assertRefused(fixture(name), "particles/all/mass", "wrong numeric type")
        }
        assertRefused(fixture("scalar-mass"), "particles/all/mass", "shape []", "[3]")
        assertRefused(fixture("unsigned-id-too-large"), "particles/all/id", "18446744073709551615")
        // Ids by frame are read; here the places of particles that are not there are filled with 0.
        assertRefused(fixture("varying-number"), "frame 0", "id 0 occurs twice")
    }

    @Test
    fun `a dataset that declares more than the file can hold takes no memory`() {
        assertRefused(fixture("declares-trillion"), "1000000000000")
        assertRefused(fixture("declares-200-million"), "200000000")
        H5Source(fixture("declares-200-million")).use {
            val e =
                assertThrows(FormatException::class.java) {
                    it.doubles("particles/all/position/value", listOf(1L, 200_000_000L, 3L))
                }
            assertTrue("cannot hold so many" in e.message.orEmpty()) { e.message }
        }
    }

    /** A file of the layout of ours, with [change]s. */
    private fun write(
        path: Path,
        count: Int = 3,
        radius: (Int) -> Double = { 0.25 },
        mass: (Int) -> Double = { 1.0 },
        id: IntArray = IntArray(count) { it },
        edge: Double = 8.0,
        place: Double = 1.0,
        time: Double = 0.0,
        axes: IntArray = intArrayOf(1, 0),
        more: (WritableGroup) -> Unit = {},
    ) {
        HdfFile.write(path).use { file ->
            val all = file.putGroup("particles").putGroup("all")
            val box = all.putGroup("box")
            box.putAttribute("boundary", Array(3) { "periodic" })
            box.putGroup("edges").putDataset("value", Array(1) { DoubleArray(3) { edge } })
            for (name in listOf("position", "velocity")) {
                val group = all.putGroup(name)
                group.putDataset("step", LongArray(1))
                group.putDataset("time", DoubleArray(1) { time })
                group.putDataset("value", Array(1) { Array(count) { k -> DoubleArray(3) { k * place } } })
            }
            all.putDataset("id", id)
            all.putDataset("mass", DoubleArray(count) { mass(it) })
            all.putDataset("radius", DoubleArray(count) { radius(it) })
            val parameters = file.putGroup("parameters")
            parameters.putDataset("shear_offset", DoubleArray(1))
            parameters.putDataset("shear_axes", axes)
            more(all)
        }
    }

    @Test
    fun `numbers in H5MD that are no state are named by frame and particle`() {
        val path = home.resolve("a.h5")
        fun wrong(vararg parts: String, write: () -> Unit) {
            write()
            assertRefused(path, *parts)
        }
        for (r in listOf(0.0, -0.5, Double.NaN, Double.POSITIVE_INFINITY, 1e-300, 1e300)) {
            wrong("frame 0", "radius of particle 1 is $r", "> 0") { write(path, radius = { if (it == 1) r else 0.25 }) }
        }
        for (m in listOf(0.0, -1.0, Double.NaN)) {
            wrong("mass of particle 2 is $m") {
                write(path, mass = {
                    if (it == 2) {
                        m
                    } else {
                        1.0
                    }
                })
            }
        }
        for (edge in listOf(0.0, -8.0, 1e-300, 1e300)) {
            wrong("edge of the box along x is $edge") {
                write(path, edge = edge)
            }
        }
        wrong("must exceed the largest diameter, 0.5") { write(path, edge = 0.4) }
        for (place in listOf(Double.NaN, 1e300)) wrong("x of particle") { write(path, place = place) }
        wrong("more than 1000000 boxes of 8.0 away") { write(path, place = 1e7) }
        for (time in listOf(Double.NaN, Double.NEGATIVE_INFINITY)) wrong("time is $time") { write(path, time = time) }
        wrong("id 1 occurs twice") { write(path, id = intArrayOf(0, 1, 1)) }
        wrong("particles/all/id", "-1") { write(path, id = intArrayOf(0, -1, 2)) }
        wrong("shape [2]", "[3]") { write(path, id = intArrayOf(0, 1)) }
        for (axes in listOf(intArrayOf(7, -3), intArrayOf(1, 1), intArrayOf(1))) {
            wrong("parameters/shear_axes") {
                write(path, axes = axes)
            }
        }
        wrong("image/value", "shape") {
            write(path) { it.putGroup("image").putDataset("value", Array(1) { Array(2) { IntArray(3) } }) }
        }
        write(path)
        assertEquals(3, H5md.read(path).single().size)
    }

    @Test
    fun `a snapshot with any one bit turned, or cut anywhere, is read or refused in a line`() {
        val path = home.resolve("whole.h5")
        write(path)
        val whole = Files.readAllBytes(path)
        val digest = stateDigest(H5md.read(path).single().population())
        var refused = 0
        val damaged = home.resolve("damaged.h5")
        for (bit in 0 until 8L * whole.size step 127) {
            val bytes = whole.copyOf().also {
                it[(bit / 8).toInt()] = (it[(bit / 8).toInt()].toInt() xor (1 shl (bit % 8).toInt())).toByte()
            }
            refused += outcome(Files.write(damaged, bytes))
        }
        for (length in whole.indices step 401) refused += outcome(Files.write(damaged, whole.copyOf(length)))
        assertTrue(refused > 20) { "$refused" }
        assertEquals(digest, stateDigest(H5md.read(path).single().population()))
    }

    /** 1 when it is refused, 0 when it is read. */
    private fun outcome(path: Path): Int {
        val read = ThrowingSupplier {
            try {
                SnapshotFormats.read(path)
                0
            } catch (e: FormatException) {
                assertFalse('\n' in e.message.orEmpty()) { e.message }
                1
            }
        }
        return assertTimeoutPreemptively(Duration.ofSeconds(60), read)
    }

    @Test
    fun `XYZ that announces more than it holds takes no memory, and a line without end is refused`() {
        assertRefused(
            text("a.xyz", "2147483647\n\nX 0 0 0\n"),
            "a.xyz:1",
            "2147483647 particles are declared",
            "bytes cannot hold",
        )
        assertRefused(text("a.xyz", "1\nProperties=species:S:2147483647:pos:R:3\nX 0 0 0\n"), "a.xyz:2", "2147483647")
        assertRefused(
            text("a.xyz", "1\nProperties=${"a:S:99999:".repeat(30_000)}pos:R:3\nX 0 0 0\n"),
            "a.xyz:2",
            "columns",
        )
        for (name in listOf("a.xyz", "a.csv")) {
            assertRefused(text(name, "1".repeat(3_000_000)), "$name:1", "longer than 1048576")
        }
        // A word as long as a line may be; looked at from each of its letters it would take minutes.
        val read =
            ThrowingSupplier { ExtendedXyz.read(text("b.xyz", "1\n${"a".repeat(1_000_000)}\nX 0 0 0\n")).single().size }
        assertEquals(1, assertTimeoutPreemptively(Duration.ofSeconds(60), read))
    }

    @Test
    fun `XYZ with numbers that are no state is refused by line`() {
        fun frame(comment: String, vararg parts: String) =
            assertRefused(text("a.xyz", "1\n$comment\nX 1 0 0\n"), "a.xyz:", *parts)
        frame("Time=NaN", "'NaN' must be a finite number")
        frame("Step=x", "Step is 'x'", "whole number")
        frame("Step=-4", "step is -4")
        frame("Lattice=\"1e-300 0 0 0 1 0 0 0 1\"", "edge of the box along x is 1.0E-300")
        frame("Lattice=\"1e300 0 0 0 1 0 0 0 1\"", "edge of the box along x is 1.0E300")
        frame("Lattice=\"10 3 0 2 10 0 1 0 10\"", "leans")
        frame("Lattice=\"10 0 0 0 10 0 0 0 10\" Origin=\"1 2\"", "Origin has 2 numbers")
        frame("Lattice=\"1e-10 0 0 0 9 0 0 0 9\"", "boxes of 1.0E-10 away")
        frame("Lattice=\"1e60 0 0 0 9 0 0 0 9\"", "up to 1.0E60", "0.5 is lost in rounding")
        frame("Scale=1e-200", "of particle 0 is")
        assertRefused(
            text("a.xyz", "1\nProperties=pos:R:3:radius:R:1\n0 0 0 1e200\n"),
            "radius of particle 0 is 1.0E200",
        )
        assertRefused(text("a.xyz", "2\nProperties=pos:R:3:id:I:1\n0 0 0 7\n9 9 9 7\n"), "id 7 occurs twice")
        assertRefused(text("a.xyz", "\u001b[31m\u0000\n"), "a.xyz:1", "'\\u001b[31m\\u0000'")
        assertEquals(
            3.0,
            ExtendedXyz.read(
                text("a.xyz", "1\nLattice=\"10 0 0 3 10 0 0 0 10\" Step=2\nX 0 0 0\n"),
            ).single().shearOffset,
        )
    }

    @Test
    fun `a table names line and column of a size, mass or id that cannot be, and a header without end is brief`() {
        assertRefused(text("a.csv", "x,y,z,radius\n1,2,3,0\n"), "a.csv:2", "radius is '0'", "> 0")
        assertRefused(text("a.csv", "x,y,z,radius,mass\n1,2,3,1,-2\n"), "a.csv:2", "mass is '-2'", "> 0")
        for (id in listOf("-1", "1e300", "2147483648", "0.5")) {
            assertRefused(text("a.csv", "x,y,z,radius,id\n1,2,3,1,$id\n"), "a.csv:2", "id is '$id'", "whole number")
        }
        assertRefused(text("a.csv", "x,y,z,radius\n1,2,3,1e-300\n"), "radius of particle 0 is 1.0E-300")
        assertRefused(text("a.csv", "${"x".repeat(900_000)}\n"), "unknown column 'xxx")
        assertRefused(text("a.csv", "x,".repeat(400_000) + "y\n"), "missing")
        assertEquals(
            listOf(3, 8),
            ParticleCsv.read(text("b.csv", "x,y,z,radius,id\n1,2,3,1,8\n5,2,3,1,3\n")).single().id.toList(),
        )
        // Ids up to a thousand million take no table of that length.
        val far = ParticleCsv.read(text("b.csv", "x,y,z,radius,id\n1,2,3,1,999999999\n")).single()
        assertEquals(1.0, far.position[0][0])
    }

    @Test
    fun `CartAndRad that says another number than its length, or a size that cannot be, is refused`() {
        fun file(n: Int, radius: Double): Path {
            val buffer = ByteBuffer.allocate(4 + 56).order(ByteOrder.LITTLE_ENDIAN).putInt(n)
            repeat(6) { buffer.putDouble(0.5) }
            return Files.write(home.resolve("a.bin"), buffer.putDouble(radius).array())
        }
        for (n in listOf(-1, 0, 2, Int.MAX_VALUE, Int.MIN_VALUE)) assertRefused(file(n, 1.0), "declares $n spheres")
        for (r in listOf(0.0, -1.0, Double.NaN, 1e300, 1e-300)) assertRefused(file(1, r), "radius of particle 0 is $r")
        assertEquals(1, CartAndRad.population(file(1, 1.0)).size)
    }
}
