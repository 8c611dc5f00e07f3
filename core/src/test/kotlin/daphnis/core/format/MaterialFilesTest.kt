package daphnis.core.format

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
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
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What carries spheres carries their materials, and says nothing of materials elsewhere. */
class MaterialFilesTest {
    @TempDir
    lateinit var home: Path

    private val boundary = Periodic(Box.centred(12.0, 11.0, 10.0))
    private val plain = randomSpheres(30, boundary, 8, 1.0) { it.nextDouble(0.2, 0.6) }
    private val names = listOf("ice", "rock", "unused")
    private val made = plain.withMaterial(IntArray(30) { it * it % 2 }, names)
    private val spun = DoubleArray(30) { 0.1 * it }.let { made.withSpin(it, it, it) }

    private fun state(p: Population) = Snapshot.of(p, boundary, 0, 0.0)

    private fun written(format: WritableFormat, p: Population): Exported {
        val directory = Files.createTempDirectory(home, format.word)
        return format.export(sequenceOf(state(p)), directory, ExportOptions("test"))
    }

    private fun read(file: Path): Snapshot {
        val path = if (Files.isDirectory(file)) file.toFile().listFiles()!![0].toPath() else file
        return SnapshotFormats.read(path)[0]
    }

    @Test
    fun `materials that change, where spheres swap, are those of each state of a file`() {
        val swapped = made.copy().also { p -> p.material[0] = p.material[1].also { p.material[1] = p.material[0] } }
        assertTrue(swapped.material[0] != made.material[0])
        for (format in listOf(H5md, ExtendedXyz)) {
            for (states in listOf(listOf(made, made), listOf(made, made, swapped, made, swapped), listOf(spun, spun))) {
                val snapshots = states.mapIndexed { k, p -> Snapshot.of(p, boundary, k.toLong(), 0.5 * k) }.asSequence()
                val path = format.export(
                    snapshots,
                    Files.createTempDirectory(home, "swaps"),
                    ExportOptions("test"),
                ).path
                val back = SnapshotFormats.read(path)
                assertEquals(states.size, back.size, format.word)
                for ((p, state) in states.zip(back)) {
                    assertArrayEquals(p.material, state.material)
                    assertEquals(names, state.materials)
                }
            }
        }
    }

    @Test
    fun `H5MD and extended XYZ keep numbers and names, beside spins and without`() {
        for (format in listOf(H5md, ExtendedXyz)) {
            for (p in listOf(plain, made, spun)) {
                val back = read(written(format, p).path)
                assertEquals(p.hasMaterials, back.hasMaterials, format.word)
                assertEquals(p.materials, back.materials)
                assertArrayEquals(p.material, back.material)
                assertEquals(p.hasSpin, back.hasSpin)
                val again = back.population()
                assertEquals(p.materials, again.materials)
                assertEquals(stateDigest(p), stateDigest(again))
                assertEquals(back.columnNames.size, back.columnPlaces.size)
                for ((name, place) in back.columnNames.zip(back.columnPlaces.toList())) {
                    assertEquals(30, back.column(place).size, name)
                }
            }
        }
    }

    @Test
    fun `a material that was changed in an H5MD file is noticed`() {
        val one = listOf(state(made))
        val other = listOf(state(plain.withMaterial(IntArray(30) { (it * it + 1) % 2 }, names)))
        val third = listOf(state(plain.withMaterial(IntArray(30) { it * it % 2 }, listOf("ice", "sand", "unused"))))
        val sums = listOf(one, other, third, listOf(state(plain))).map { H5mdChecksum.of(it) }
        assertEquals(4, sums.toSet().size)
    }

    @Test
    fun `extended XYZ has names in place of elements, and LAMMPS dumps have types from 1 on`() {
        val xyz = Files.readAllLines(written(ExtendedXyz, made).path)
        assertTrue("Materials=\"ice rock unused\"" in xyz[1]) { xyz[1] }
        assertTrue("Properties=species:S:1:pos:R:3:velo" in xyz[1] && "material:" !in xyz[1]) { xyz[1] }
        assertEquals(List(30) { names[it % 2] }, xyz.drop(2).map { it.substringBefore(' ') })
        val plainly = Files.readAllLines(written(ExtendedXyz, plain).path)
        assertTrue("Materials" !in plainly[1] && plainly.drop(2).all { it.startsWith("X ") })
        for ((p, types) in listOf(made to List(30) { "${1 + it % 2}" }, plain to List(30) { "1" })) {
            val dump = Files.readAllLines(written(LammpsDump, p).path)
            val head = dump.indexOfFirst { it.startsWith("ITEM: ATOMS") }
            assertTrue("material" !in dump[head])
            assertEquals(types, dump.drop(head + 1).map { it.split(' ')[1] })
        }
    }

    @Test
    fun `VTK has a material for each point, and CartAndRad says that it has none`() {
        val vtp = Files.createTempDirectory(home, "vtp")
        Vtp.export(sequenceOf(state(made)), vtp, ExportOptions("test"))
        assertTrue("Name=\"material\"" in Files.readString(vtp.resolve("0000000000.vtp"), Charsets.ISO_8859_1))
        assertTrue("masses, ids and materials" in written(CartAndRad, made).remark!!)
        assertTrue("masses and ids" in written(CartAndRad, plain).remark!!)
        assertEquals(1.0, SiUnits(2.0, 0.5, 3.0).convert(state(made)).material[3])
    }

    @Test
    fun `names that are numbers of others stay names`() {
        val odd = plain.withMaterial(IntArray(30) { it % 2 }, listOf("1", "0"))
        for (format in listOf(H5md, ExtendedXyz)) {
            val back = read(written(format, odd).path)
            assertEquals(listOf("1", "0"), back.materials)
            assertEquals(List(30) { (it % 2).toDouble() }, back.material.toList())
        }
    }

    @Test
    fun `a table has materials by name or number`() {
        fun table(vararg words: String): Snapshot {
            val file = home.resolve("a.csv")
            val rows = words.withIndex().joinToString("\n") { (k, word) -> "${4 * k},0,$word,0,1,$k" }
            Files.writeString(file, "x,y,material,z,radius,id\n$rows\n")
            return ParticleCsv.read(file)[0]
        }
        val named = table("rock", "ice", "rock")
        assertEquals(listOf("rock", "ice"), named.materials)
        assertEquals(listOf(0.0, 1.0, 0.0), named.population().material.toList())
        val numbered = table("2", "0", "2")
        assertEquals(listOf("0", "1", "2"), numbered.materials)
        assertEquals(listOf(2.0, 0.0, 2.0), numbered.material.toList())
        val e = assertThrows(FormatException::class.java) { table("ice", "a+b") }
        assertTrue("a.csv:3: material is 'a+b'; it must be a word" in e.message!!) { e.message }
    }

    @Test
    fun `species of other programs are no materials until somebody says so`() {
        val xyz = home.resolve("other.xyz")
        Files.writeString(xyz, "2\nProperties=species:S:1:pos:R:3\nH 0 0 0\nO 3 0 0\n")
        val notices = ArrayList<String>()
        val snapshot = ExtendedXyz.read(xyz, notices)[0]
        assertFalse(snapshot.hasMaterials)
        assertEquals(emptyList<String>(), notices)
        assertEquals(listOf(1, 0), snapshot.species!!.numbers(listOf("O", "H")).toList())
        val e = assertThrows(FormatException::class.java) { snapshot.species!!.numbers(listOf("O", "C")) }
        assertTrue("particles of 'H' are of none of the materials O, C, nor of a number 0 to 1" in e.message!!) {
            e.message
        }
        val dump = read(written(LammpsDump, made).path)
        assertFalse(dump.hasMaterials)
        assertEquals(List(30) { it % 2 }, dump.species!!.numbers(listOf("ice", "rock")).toList())
        assertThrows(FormatException::class.java) { dump.species!!.numbers(listOf("ice")) }
        assertNull(read(written(CartAndRad, made).path).species)
        // A frame that names its materials has to keep to them.
        Files.writeString(xyz, "1\nProperties=species:S:1:pos:R:3 Materials=\"ice rock\"\nH 0 0 0\n")
        assertThrows(FormatException::class.java) { ExtendedXyz.read(xyz) }
    }

    @Test
    fun `particles of a file may be in any order`() {
        val xyz = home.resolve("any.xyz")
        val head = "Properties=species:S:1:pos:R:3:id:I:1"
        Files.writeString(xyz, "2\n$head Materials=\"ice rock\"\nrock 0 0 0 5\nice 3 0 0 2\n")
        assertEquals(listOf(0.0, 1.0), ExtendedXyz.read(xyz)[0].material.toList())
    }

    @Test
    fun `a checkpoint has materials with names where there are any, and says nothing of them elsewhere`() {
        val meta = CheckpointMeta(7, 0.5, Counter.entries.associate { it.key to 0L }, 1.5)
        for (p in listOf(plain, made, spun)) {
            val file = home.resolve("checkpoint")
            Checkpoint.write(meta, "{}", SpheresById(p), emptyMap(), file)
            val text = Files.readString(file, Charsets.ISO_8859_1)
            for (record in SphereQuantity.MATERIAL.records + "NAME") assertEquals(p.hasMaterials, record in text)
            val back = Checkpoint.read(file).population
            assertEquals(p.materials, back.materials)
            assertEquals(p.hasMaterials, back.hasMaterials)
            assertArrayEquals(p.material, back.material)
            assertEquals(stateDigest(p), stateDigest(back))
        }
    }
}
