package daphnis.core.format

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.input.SiUnits
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.randomSpheres
import io.jhdf.HdfFile
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.StringWriter
import java.nio.file.Files
import java.nio.file.Path

/** Round trips of our own; independent readers are asked by tools/verify-exports.py. */
class FormatsTest {
    @TempDir
    lateinit var home: Path

    private val boundary = LeesEdwards(Box.centred(12.0, 11.0, 10.0), 0.5)
    private val population = randomSpheres(70, boundary, 8, 1.0) { it.nextDouble(0.2, 0.6) }
    private val state = Snapshot.of(population.permuted(2), boundary, 5, 1.25)

    @Test
    fun `H5MD gives every number back`() {
        val later = Snapshot.of(population, boundary, 6, 1.5)
        val file = home.resolve("a.h5")
        H5md.write(listOf(state, later), file, "test")
        val (a, b) = H5md.read(file)
        assertEquals(stateDigest(population), stateDigest(a.population()))
        assertEquals(listOf(5L, 6L), listOf(a.step, b.step))
        assertEquals(listOf(1.25, 1.5), listOf(a.time, b.time))
        assertArrayEquals(state.radius, a.radius)
        assertArrayEquals(state.mass, a.mass)
        assertArrayEquals(doubleArrayOf(12.0, 11.0, 10.0), a.lengths)
        assertEquals(6.875, a.shearOffset)
    }

    @Test
    fun `H5MD gives each state its own radii and masses where they change, and keeps them once where they do not`() {
        fun grown(factor: Double, heavy: Double, step: Long) = Snapshot(
            step, step.toDouble(), state.lengths, state.periodic, state.shearOffset, state.id, state.position,
            state.velocity, DoubleArray(70) { factor * state.radius[it] }, DoubleArray(70) { heavy * state.mass[it] },
        )
        val file = home.resolve("growing.h5")
        // The third state is the first one to differ; the last is as the first again.
        val states = listOf(grown(1.0, 1.0, 5), grown(1.0, 1.0, 6), grown(1.5, 1.0, 7), grown(1.0, 1.0, 8))
        H5md.write(states, file, "test", SiUnits(metres = 2.0, seconds = 1.0, kilograms = 1.0))
        for ((written, read) in states.zip(H5md.read(file))) {
            assertArrayEquals(DoubleArray(70) { 2 * written.radius[it] }, read.radius)
            assertArrayEquals(written.mass, read.mass)
        }
        io.jhdf.HdfFile(file).use { h5 ->
            val radius = h5.getDatasetByPath("/particles/all/radius/value")
            assertEquals(listOf(4, 70), radius.dimensions.toList())
            assertEquals("m", radius.getAttribute("unit").data)
            assertEquals(
                listOf(5L, 6, 7, 8),
                (h5.getDatasetByPath("/particles/all/radius/step").data as LongArray).toList(),
            )
            assertEquals(4, (h5.getDatasetByPath("/particles/all/radius/time").data as DoubleArray).size)
            assertEquals(listOf(70), h5.getDatasetByPath("/particles/all/mass").dimensions.toList())
        }
        H5md.write(listOf(grown(1.0, 1.0, 1), grown(1.0, 3.0, 2)), file, "test")
        assertArrayEquals(grown(1.0, 3.0, 2).mass, H5md.read(file)[1].mass)
    }

    @Test
    fun `H5MD keeps boxes crossed, and reads files that do not say`() {
        val image = Array(3) { axis -> IntArray(70) { (it - 35) * (axis + 1) } }
        fun with(image: Array<IntArray>?, step: Long) = Snapshot(
            step, state.time, state.lengths, state.periodic, state.shearOffset, state.id,
            state.position, state.velocity, state.radius, state.mass, image = image,
        )
        val file = home.resolve("image.h5")
        val other = Array(3) { IntArray(70) { 1 shl 30 } }
        H5md.write(listOf(with(image, 5), with(other, 6)), file, "test")
        val (a, b) = H5md.read(file)
        for (axis in 0..2) assertArrayEquals(image[axis], a.image!![axis])
        for (axis in 0..2) assertArrayEquals(other[axis], b.image!![axis])
        io.jhdf.HdfFile(file).use {
            assertEquals("int", it.getDatasetByPath("/particles/all/image/value").javaType.name)
        }
        H5md.write(listOf(with(image, 5), with(null, 6)), file, "test")
        assertEquals(listOf(null, null), H5md.read(file).map { it.image }) { "known for some is not known" }
    }

    @Test
    fun `H5MD in SI units has converted numbers and says their units as the module prescribes`() {
        val file = home.resolve("si.h5")
        H5md.write(listOf(state), file, "test", SiUnits(metres = 1000.0, seconds = 100.0, kilograms = 5.0))
        val read = H5md.read(file).single()
        for (axis in 0..2) {
            for (k in 0 until state.size) {
                assertEquals(state.position[axis][k] * 1000, read.position[axis][k])
                assertEquals(state.velocity[axis][k] * 10, read.velocity[axis][k])
            }
        }
        assertEquals(125.0, read.time)
        assertEquals(12_000.0, read.lengths[0])
        assertEquals(6875.0, read.shearOffset)
        assertEquals(state.radius[3] * 1000, read.radius[3])
        assertEquals(state.mass[3] * 5, read.mass[3])
        assertEquals(state.step, read.step)
        HdfFile(file).use { h5 ->
            fun unit(path: String) = h5.getDatasetByPath(path).getAttribute("unit").data
            assertEquals("m", unit("/particles/all/position/value"))
            assertEquals("s", unit("/particles/all/position/time"))
            assertEquals("m s-1", unit("/particles/all/velocity/value"))
            assertEquals("m", unit("/particles/all/box/edges/value"))
            assertEquals("kg", unit("/particles/all/mass"))
            assertEquals("m", unit("/particles/all/radius"))
            assertEquals("SI", h5.getByPath("/h5md/modules/units").getAttribute("system").data)
        }
        val plain = home.resolve("plain.h5")
        H5md.write(listOf(state), plain, "test")
        HdfFile(plain).use { h5 ->
            assertTrue(h5.getDatasetByPath("/particles/all/position/value").attributes.isEmpty())
        }
    }

    @Test
    fun `a state without particles is written and read`() {
        val none = Snapshot.of(population.copy().also { it.retain { false } }, Open, 3, 1.5)
        H5md.write(listOf(none), home.resolve("none.h5"), "test")
        val read = H5md.read(home.resolve("none.h5")).single()
        assertEquals(listOf(0L, 3L), listOf(read.size.toLong(), read.step))
    }

    @Test
    fun `XYZ with ids that are no whole numbers of 32 bits, or a box without an edge, is refused by line`() {
        fun problem(comment: String, id: String): String {
            val file = Files.writeString(
                home.resolve("odd.xyz"),
                "1\n$comment Properties=pos:R:3:radius:R:1:id:I:1\n0 0 0 1 $id\n",
            )
            return assertThrows(FormatException::class.java) { ExtendedXyz.read(file) }.message!!
        }
        for (id in listOf("2147483648", "-1", "1.5")) assertTrue("odd.xyz:3: id is '$id'" in problem("", id)) { id }
        for (edge in listOf("0", "-5")) {
            assertTrue("must be > 0" in problem("Lattice=\"$edge 0 0 0 4 0 0 0 4\"", "1")) {
                edge
            }
        }
    }

    @Test
    fun `a boundary of one's own without end leaves the box out of every format, as an open one does`() {
        // The boundary of the library guide, and one that ends on one side only.
        val endless = listOf(Box.UNBOUNDED, Box(-20.0, -20.0, -20.0, 20.0, 20.0, Double.POSITIVE_INFINITY)).map { box ->
            object : BoundaryConditions {
                override val box = box

                override fun endStep(population: Population, time: Double) = Unit
            }
        }
        fun files(boundary: BoundaryConditions): List<ByteArray> {
            val it = Snapshot.of(population, boundary, 5, 1.25)
            val vtp = home.resolve("a.vtp").also { file -> Vtp.write(it, file) }
            val cartAndRad = home.resolve("a.bin").also { file -> CartAndRad.write(it.population(), file) }
            val xyz = StringWriter().also { out ->
                ExtendedXyz.write(it, out, ExtendedXyz.suitableScale(it))
            }.toString()
            H5md.write(listOf(it), home.resolve("a.h5"), "test")
            assertTrue(H5md.read(home.resolve("a.h5"))[0].lengths.all { length -> length.isNaN() })
            assertFalse("Lattice" in xyz || "Infinity" in xyz) { xyz.lines()[1] }
            return listOf(xyz.toByteArray(), Files.readAllBytes(vtp), Files.readAllBytes(cartAndRad))
        }
        val expected = files(Open)
        for ((k, written) in files(endless[0]).withIndex()) assertArrayEquals(expected[k], written)
        assertArrayEquals(doubleArrayOf(40.0, 40.0, Double.NaN), Snapshot.of(population, endless[1], 0, 0.0).lengths)
        files(endless[1])
    }

    @Test
    fun `CartAndRad gives positions, velocities and radii back`() {
        val file = home.resolve("a.bin")
        CartAndRad.write(population.permuted(4), file)
        assertEquals(4L + 56 * 70, Files.size(file))
        val back = CartAndRad.population(file)
        assertEquals(stateDigest(population), stateDigest(back))
        assertArrayEquals(population.radius, back.radius)
    }

    @Test
    fun `files that are none are refused in one line`() {
        for ((k, bytes) in listOf(
            ByteArray(0),
            ByteArray(3),
            byteArrayOf(5, 0, 0, 0, 1, 2),
            ByteArray(60) {
                0x7f
            },
        ).withIndex()) {
            val file = Files.write(home.resolve("bad$k"), bytes)
            for (read in listOf<() -> Any>({
                CartAndRad.read(file)
            }, { H5md.read(file) }, { ParticleCsv.read(file) })) {
                val e = assertThrows(FormatException::class.java) { read() }
                assertFalse('\n' in e.message.orEmpty())
            }
        }
    }

    @Test
    fun `a table of particles names line and column of what is wrong`() {
        fun wrong(text: String, vararg parts: String) {
            val e =
                assertThrows(FormatException::class.java) {
                    ParticleCsv.population(Files.writeString(home.resolve("p.csv"), text))
                }
            for (part in parts) assertTrue(part in e.message.orEmpty()) { e.message }
        }
        wrong("x,y,z\n1,2,3", "radius", "missing")
        wrong("x,y,z,radius,colour\n", "colour")
        wrong("x;y;z;radius\n1;2;3;4\n", "semicolons", "commas are needed")
        wrong("x;y;z;radius\n1,5;2,0;3,0;4,0\n", "semicolons", "commas are needed")
        wrong("id\tx\ty\tz\tradius\n", "tabs", "commas are needed")
        wrong("x y z  radius\n", "spaces", "commas are needed")
        wrong("x;y;colour\n", "unknown column 'x;y;colour'")
        wrong("x,y,z,radius\n1,2,3\n", "p.csv:2", "3 values")
        wrong("x,y,z,radius\n1,2,3,0.5\n1,NaN,3,0.5\n", "p.csv:3", "y is 'NaN'")
        wrong("x,y,z,radius\n1,2,3,-1\n", "radius", "> 0")
        wrong("x,y,z,radius,id\n1,2,3,1,1.5\n", "whole number")
        wrong("x,y,z,radius,id\n1,2,3,1,1\n1,2,9,1,1\n", "occurs twice")
    }

    @Test
    fun `extended XYZ has the cell with its shear, and one line a sphere`() {
        val out = StringWriter()
        ExtendedXyz.write(state, out, 2.0)
        val lines = out.toString().trimEnd().lines()
        assertEquals("70", lines[0])
        assertTrue(
            lines[1].startsWith("Lattice=\"24.0 0.0 0.0 13.75 22.0 0.0 0.0 0.0 20.0\" Origin=\"-12.0 -11.0 -10.0\""),
        ) {
            lines[1]
        }
        assertTrue("Time=1.25" in lines[1] && "pbc=\"T T T\"" in lines[1])
        assertEquals(72, lines.size)
        val cells = lines[2].split(' ')
        assertEquals(
            listOf(state.position[0][0] * 2, state.velocity[2][0] * 2, state.radius[0] * 2, state.mass[0]),
            listOf(cells[1], cells[6], cells[7], cells[8]).map {
                it.toDouble()
            },
        )
    }

    @Test
    fun `short boxes are given in radii, long ones as they are`() {
        assertEquals(1.0, ExtendedXyz.suitableScale(state))
        val small =
            Snapshot(
                0, 0.0, doubleArrayOf(2.0, 2.0, 0.2), BooleanArray(3), 0.0, state.id, state.position, state.velocity,
                DoubleArray(70) {
                    0.004
                },
                state.mass,
            )
        assertEquals(250.0, ExtendedXyz.suitableScale(small), 1e-9)
    }

    @Test
    fun `VTP says how long its blocks are`() {
        val file = home.resolve("a.vtp")
        Vtp.write(state, file)
        val bytes = Files.readAllBytes(file)
        val start =
            String(
                bytes,
                Charsets.ISO_8859_1,
            ).indexOf("_", String(bytes, Charsets.ISO_8859_1).indexOf("<AppendedData")) +
                1
        val data = java.nio.ByteBuffer.wrap(bytes).order(java.nio.ByteOrder.LITTLE_ENDIAN)
        assertEquals(8L, data.getLong(start))
        assertEquals(1.25, data.getDouble(start + 8))
        assertEquals(24L * 70, data.getLong(start + 16))
        assertEquals(state.position[1][0], data.getDouble(start + 32))
    }
}
