package daphnis.core.format

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

/** What other programs write into extended XYZ, LAMMPS dumps and CartAndRad. */
class ForeignTextTest {
    @TempDir
    lateinit var home: Path

    private val notices = ArrayList<String>()

    private fun read(name: String, text: String): List<Snapshot> =
        SnapshotFormats.read(Files.writeString(home.resolve(name), text), notices)

    private fun refused(name: String, text: String, vararg words: String) {
        val e = assertThrows(FormatException::class.java) { read(name, text) }
        for (word in words) assertTrue(word in e.message!!) { "'$word' is not in ${e.message}" }
    }

    private fun comment(line: String, rows: String = "X 1 2 3\n", name: String = "a.xyz"): Snapshot =
        read(name, "1\n$line\n$rows").single()

    private val box = "Lattice=\"10 0 0 0 10 0 0 0 10\""

    @ParameterizedTest
    @ValueSource(
        strings = [
            "pbc=\"T T F\"", "pbc=\"[T, T, F]\"", "pbc=[T, T, F]", "pbc=[True, True, False]", "pbc=\"1 1 0\"",
            "pbc=[1,1,0]", "pbc={T T F}", "pbc='true true false'", "pbc = \"T T F\"", "PBC=\"t t f\"", "pbc=TTF",
            "pbc=\".TRUE. .TRUE. .FALSE.\"", "note=\"a \\\"quoted pbc=F\\\" word\" pbc=\"T T F\"", "flag pbc=\"T T F\"",
            "empty= pbc=\"T T F\"", "v=\"1 2 3\" m=[[1, 2], [3, 4]] pbc=\"T T F\" Time = 3 Step=4",
        ],
    )
    fun `faces are read in every way that programs write lists`(pbc: String) {
        assertArrayEquals(
            booleanArrayOf(true, true, false),
            comment("$box Properties=species:S:1:pos:R:3 $pbc").periodic,
        )
        assertArrayEquals(booleanArrayOf(true, true, false), comment("$pbc $box").periodic)
    }

    @Test
    fun `a speed whose square is no number is named with its column`() {
        val e = assertThrows(FormatException::class.java) {
            comment("Properties=species:S:1:pos:R:3:velo:R:3 pbc=\"F F F\"", "X 1 2 3 0 -1e160 0\n")
        }
        assertTrue("vy of particle 0 is -1.0E160; it must be a number within ±1.0E150" in e.message!!) { e.message }
    }

    @Test
    fun `faces that are no list of three are refused with the line of the comment in its frame`() {
        for (pbc in listOf("\"T T\"", "\"T T maybe\"", "[T T F F]", "\"\"")) {
            refused("a.xyz", "1\n$box\nX 1 2 3\n1\n$box pbc=$pbc\nX 1 2 3\n", "a.xyz:5:", "pbc")
        }
        refused("a.xyz", "1\n$box\nX 1 2 3\n2\nLattice=\"10 0 0\"\nX 1 2 3\nX 1 2 4\n", "a.xyz:5:", "Lattice", "9")
        refused("a.xyz", "2\n$box Time=soon\nX 1 2 3\nX 1 2 4\n", "a.xyz:2:", "soon")
        refused("a.xyz", "1\n$box Time=1 time=2\nX 1 2 3\n", "a.xyz:2:", "twice")
        refused("a.xyz", "1\nLattice=\"10 0 0\nX 1 2 3\n", "a.xyz:2:", "counterpart")
        refused("a.xyz", "1\npbc=[T,T\nX 1 2 3\n", "a.xyz:2:", "counterpart")
    }

    @Test
    fun `whether velocities are known is told, in every text`() {
        val row = "X 1 2 3 4 5 6\n"
        assertTrue(comment("$box Properties=species:S:1:pos:R:3:velo:R:3", row).hasVelocity)
        assertFalse(comment("$box Properties=species:S:1:pos:R:3:forces:R:3", row).hasVelocity)
        val momenta = "$box Properties=species:S:1:pos:R:3:momenta:R:3"
        assertTrue(comment("$momenta:masses:R:1", "X 1 2 3 4 5 6 2\n").hasVelocity)
        fun dump(columns: String, values: String) = read(
            "a.dump",
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n" +
                "ITEM: ATOMS id x y z $columns\n1 1 2 3 $values\n",
        ).single()
        assertTrue(dump("vx vy vz", "1 2 3").hasVelocity)
        assertFalse(dump("vx vy", "1 2").hasVelocity)
        assertTrue(read("a.csv", "x,y,z,vx,vy,vz,radius\n1,2,3,4,5,6,0.5\n").single().hasVelocity)
        assertFalse(read("b.csv", "x,y,z,radius\n1,2,3,0.5\n").single().hasVelocity)
    }

    @Test
    fun `faces without quotes are refused with the right form, and equal numbers are no contradiction`() {
        for (pbc in listOf("pbc=T T F", "pbc = true, true, false", "PBC=1 1 0", "pbc:\"T T F\"", "pbc: [T, T, F]")) {
            for (line in listOf("Time=0 $pbc", "$box $pbc note=x")) {
                refused("a.xyz", "1\n$line\nX 1 2 3\n", "a.xyz:2:", "write pbc=\"T T F\"")
            }
        }
        assertArrayEquals(BooleanArray(3) { true }, comment("$box pbc=T flag").periodic)
        assertTrue(comment("pbc=\"T T F\" T note=\"pbc=T T\" $box").periodic[0])
        assertEquals(0.0, comment("$box Time=0 time=0.0").time)
    }

    @Test
    fun `what is wrong with a particle is named by its line, in any order of ids`() {
        val head = "Properties=id:I:1:pos:R:3:radius:R:1"
        val rows = "7 1 2 3 1\n3 1e200 0 0 1\n5 4 5 6 1\n"
        refused("a.xyz", "3\n$head\n$rows", "a.xyz:4:", "particle 3")
        refused("a.xyz", "3\n$head\n7 1 2 3 1\n5 4 5 6 1\n5 6 5 6 1\n", "a.xyz:5:", "id 5 occurs twice")
        val bounds = "ITEM: BOX BOUNDS\n0 9\n0 9\n0 9\n"
        val dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\n${bounds}ITEM: ATOMS id x y z radius\n"
        refused("a.dump", dump + rows, "a.dump:11:", "particle 3")
    }

    @Test
    fun `spheres come in the order of ids`() {
        val s = read("a.xyz", "2\nProperties=pos:R:3:id:I:1\n1 0 0 9\n2 0 0 4\n").single()
        assertArrayEquals(intArrayOf(4, 9), s.id)
        assertArrayEquals(doubleArrayOf(2.0, 1.0), s.position[0])
    }

    @Test
    fun `momenta over masses are velocities, in whichever order the columns are`() {
        val before = comment("Properties=species:S:1:momenta:R:3:pos:R:3:masses:R:1", "X 2 4 6 0 0 0 4\n")
        val behind = comment("Properties=species:S:1:masses:R:1:pos:R:3:momenta:R:3", "X 4 0 0 0 2 4 6\n")
        for (s in listOf(before, behind)) assertEquals(listOf(0.5, 1.0, 1.5), s.velocity.map { it[0] })
        val both = comment("Properties=velo:R:3:momenta:R:3:pos:R:3:mass:R:1", "1 1 1 2 4 6 0 0 0 4\n")
        assertEquals(listOf(1.0, 1.0, 1.0), both.velocity.map { it[0] })
        assertEquals(emptyList<String>(), notices)
        val massless = comment("Properties=pos:R:3:momenta:R:3", "0 0 0 2 4 6\n", "massless.xyz")
        assertEquals(0.0, massless.velocity[0][0])
        assertTrue("no masses" in notices.single()) { notices.single() }
    }

    @Test
    fun `columns that are not used are said once for a file`() {
        val frame = "1\nProperties=species:S:1:pos:R:3:forces:R:3:charge:R:1 Time=%d\nX 1 2 3 9 9 9 1\n"
        read("a.xyz", frame.format(0) + frame.format(1))
        assertEquals(2, notices.size)
        assertTrue("forces" in notices[0] && "charge" in notices[1]) { "$notices" }
    }

    @Test
    fun `boxes of one edge that leans along x or y are read, others are refused`() {
        fun lattice(vararg entries: Pair<Int, Double>) =
            DoubleArray(9) { k -> entries.toMap()[k] ?: if (k % 4 == 0) 10.0 else 0.0 }.joinToString(" ")
        for ((entry, way) in mapOf(1 to (0 to 1), 3 to (1 to 0), 6 to (2 to 0), 7 to (2 to 1))) {
            val s = comment("Lattice=\"${lattice(entry to 2.5)}\"")
            assertEquals(way, s.normalAxis to s.slideAxis)
            assertEquals(2.5, s.shearOffset)
            assertEquals(2.5, s.edges()[way.first][way.second])
        }
        for (wrong in listOf(lattice(2 to 1.0), lattice(5 to 1.0), lattice(3 to 1.0, 6 to 1.0))) {
            refused("a.xyz", "1\nLattice=\"$wrong\"\nX 1 2 3\n", "a.xyz:2:", "leans")
        }
    }

    @Test
    fun `a file without times says so, and its steps are no times`() {
        assertFalse(comment("Step=40").hasTime)
        assertTrue(comment("Step=40 Time=2").hasTime)
        assertEquals(40, comment("Timestep=40").step)
        val known = comment("Step=40").at(2.0)
        assertTrue(known.hasTime)
        assertEquals(2.0, known.time)
        val bounds = "ITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n"
        val frame = "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\n${bounds}ITEM: ATOMS x y z\n0 0 0\n"
        assertFalse(read("a.dump", frame).single().hasTime)
        assertTrue(read("a.dump", "ITEM: TIME\n3.5\n$frame").single().hasTime)
    }

    private fun dump(columns: String, row: String, bounds: String = "BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10"): Snapshot =
        read(
            "a.dump",
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: $bounds\nITEM: ATOMS $columns\n$row\n",
        ).single()

    @ParameterizedTest
    @ValueSource(
        strings = [
            "x y z ix iy iz;1 2 3 1 -2 0", "xu yu zu;11 -18 3", "xs ys zs ix iy iz;.1 .2 .3 1 -2 0",
            "xsu ysu zsu;1.1 -1.8 .3", "xu y zs iy iz;11 2 .3 -2 0", "x y z xu yu zu;1 2 3 11 -18 3",
            "xu yu zu ix iy iz;11 -18 3 1 -2 0", "iz xs iy y ix z;0 .1 -2 2 1 3",
        ],
    )
    fun `columns of every kind, mixed too, tell where a particle is without a box`(said: String) {
        val (columns, row) = said.split(';')
        val s = dump(columns, row)
        val folded = s.folded()
        for ((axis, place) in listOf(6.0, -23.0, -2.0).withIndex()) {
            assertEquals(place, s.position[axis][0] + 10 * s.image!![axis][0], 1e-12)
            assertEquals(place, folded.position[axis][0] + 10 * folded.image!![axis][0], 1e-12)
            assertTrue(folded.position[axis][0] in -5.0..5.0)
        }
    }

    @Test
    fun `without flags along an axis that repeats boxes crossed are not known`() {
        assertNull(dump("x y z ix iy", "1 2 3 1 1").image)
        assertNull(dump("x y z", "1 2 3").image)
        assertEquals(1, dump("x y z ix iy", "1 2 3 1 1", "BOX BOUNDS pp pp mm\n0 10\n0 10\n0 10").image!![0][0])
        refused(
            "a.dump",
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 12 2\n" +
                "0 10 0\n0 10 0\nITEM: ATOMS xs y z\n.1 2 3\n",
            "a.dump:9:",
            "scaled",
        )
    }

    @Test
    fun `a particle that left through a sliding face comes back displaced, and is counted`() {
        val s = dump("xu yu zu", "8 12 5", "BOX BOUNDS xy xz yz pp pp pp\n0 13 3\n0 10 0\n0 10 0")
        val folded = s.folded()
        assertEquals(5.0 - 5, folded.position[0][0] - s.position[0][0] + 3 - 0.0, 1e-12)
        assertEquals(listOf(0, 1, 0), folded.image!!.map { it[0] })
        val edges = s.edges()
        for (axis in 0..2) {
            val sum = folded.position[axis][0] + (0..2).sumOf { folded.image!![it][0] * edges[it][axis] }
            assertEquals(s.position[axis][0], sum, 1e-12)
        }
    }

    @ParameterizedTest
    @ValueSource(strings = ["mm", "ss", "fs", "sf", "sm", "ms", "fm"])
    fun `an axis with any open face leaves the others as they are`(faces: String) {
        val s = dump("x y z", "1 2 3", "BOX BOUNDS pp pp $faces\n0 10\n0 10\n0 10")
        assertArrayEquals(booleanArrayOf(true, true, false), s.periodic)
        assertTrue(s.lengths[2].isNaN() && s.lengths[0] == 10.0)
        val tilted = dump("x y z", "1 2 3", "BOX BOUNDS xy xz yz pp pp $faces\n0 12 2\n0 10 0\n0 10 0")
        assertArrayEquals(booleanArrayOf(true, true, false), tilted.periodic)
        assertEquals(2.0, tilted.shearOffset)
        refused("a.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS pp pf pp\n", "a.dump:5:")
    }

    @Test
    fun `a mark of UTF-8 at the beginning is no part of a file`() {
        val mark = "\uFEFF"
        assertEquals(2.0, read("a.xyz", "${mark}1\n\nX 1 2 3\n").single().position[1][0])
        assertEquals(1, read("a.csv", "${mark}x,y,z,radius\n1,2,3,1\n").single().size)
        val dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS\n0 1\n0 1\n0 1\nITEM: ATOMS x y z\n"
        assertEquals(0, read("a.dump", mark + dump).single().size)
        val data = "title\n\n1 atoms\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # sphere\n\n1 1 1 1 4 4 4 1 0 -1\n"
        val s = read("a.data", mark + data).single()
        assertEquals(listOf(1, 0, -1), s.image!!.map { it[0] })
        refused("a.xyz", "1\n\n${mark}X 1 2 x\n", "a.xyz:3:")
    }

    private fun pack(file: Path): Path = home.resolve("${file.fileName}.gz").also { packed ->
        GZIPOutputStream(Files.newOutputStream(packed)).use { Files.copy(file, it) }
    }

    @Test
    fun `every format is read as gzip has packed it`() {
        val gas = Population(
            doubleArrayOf(1.0, 2.0),
            doubleArrayOf(0.0, 1.0),
            DoubleArray(2),
            DoubleArray(2),
            DoubleArray(2),
            DoubleArray(2),
            doubleArrayOf(0.25, 0.5),
            doubleArrayOf(1.0, 2.0),
        )
        val state = Snapshot.of(gas, LeesEdwards(Box.centred(10.0, 10.0, 10.0), 1.0), 3, 0.25)
        for (format in SnapshotFormats.writable.filterIsInstance<ReadableFormat>()) {
            val directory = Files.createDirectory(home.resolve((format as WritableFormat).word))
            val written = format.export(sequenceOf(state), directory, ExportOptions("0")).path
            val file = if (Files.isDirectory(written)) Files.list(written).use { it.findFirst().get() } else written
            val back = SnapshotFormats.read(pack(file)).single()
            assertArrayEquals(state.position[0], back.position[0], 1e-12)
            assertArrayEquals(state.id, back.id)
        }
        val cut = pack(Files.writeString(home.resolve("c.xyz"), "1\n\nX 1 2 3\n".repeat(500)))
        Files.write(cut, Files.readAllBytes(cut).let { it.copyOf(it.size - 12) })
        val e = assertThrows(FormatException::class.java) { SnapshotFormats.read(cut) }
        assertTrue("cannot be read" in e.message!!) { e.message!! }
    }

    @Test
    fun `a dump for LAMMPS has ids from 1 in every state, and gives back those it was made of`() {
        fun state(step: Long, vararg ids: Int) = DoubleArray(ids.size) { it.toDouble() }.let { x ->
            val ones = DoubleArray(ids.size) { 1.0 }
            Snapshot(
                step, 0.1 * step, doubleArrayOf(9.0, 9.0, 9.0), BooleanArray(3) { true }, 0.0, ids,
                arrayOf(x, x, x), arrayOf(x, x, x), ones, ones,
            )
        }
        for ((kind, first) in listOf("from 0" to intArrayOf(0, 1, 5), "from 1" to intArrayOf(1, 2, 6))) {
            val states = listOf(state(0, *first), state(1, *first.drop(1).toIntArray()))
            val directory = Files.createDirectory(home.resolve(kind))
            val file = LammpsDump.export(states.asSequence(), directory, ExportOptions("0")).path
            val text = Files.readAllLines(file)
            val head = text.indices.filter { text[it].startsWith("ITEM: ATOMS") }
            assertEquals(listOf("1", "2"), head.map { text[it + 1].substringBefore(' ') })
            assertEquals(states.map { it.id.toList() }, LammpsDump.read(file).map { it.id.toList() })
        }
    }

    @Test
    fun `spins are behind the radii, three for each sphere`() {
        val bytes = ByteBuffer.allocate(4 + 2 * 80).order(ByteOrder.LITTLE_ENDIAN).putInt(2)
        for (k in 0 until 12) bytes.putDouble(k.toDouble())
        for (k in 0 until 2) bytes.putDouble(1.5 + k)
        for (k in 0 until 6) bytes.putDouble(20.0 + k)
        val s = SnapshotFormats.read(Files.write(home.resolve("spin.bin"), bytes.array()), notices).single()
        assertArrayEquals(doubleArrayOf(1.5, 2.5), s.radius)
        assertEquals(6.0, s.position[0][1])
        assertEquals(listOf(20.0, 23.0, 21.0, 24.0, 22.0, 25.0), s.wx.toList() + s.wy.toList() + s.wz.toList())
        assertEquals(emptyList<String>(), notices)
        val longer = Files.write(home.resolve("long.bin"), bytes.array() + ByteArray(8))
        assertThrows(FormatException::class.java) { SnapshotFormats.read(longer) }
    }
}
