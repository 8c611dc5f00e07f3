package daphnis.core.format

import io.jhdf.HdfFile
import io.jhdf.api.WritableGroup
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Files
import java.nio.file.Path

/** Files that a reader could take for something else without a word. */
class SilentMisreadingTest {
    @TempDir
    lateinit var home: Path

    private val notices = ArrayList<String>()

    private fun read(name: String, text: String): List<Snapshot> =
        SnapshotFormats.read(Files.writeString(home.resolve(name), text), notices)

    private fun refused(vararg words: String, act: () -> Unit) {
        val message = assertThrows(FormatException::class.java, act).message!!
        for (word in words) assertTrue(word in message) { "'$word' is not in $message" }
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = ';',
        value = [
            "Atoms. Timestep: 100; 100;", "Atoms. Timestep: 100 Time: 0.5; 100; 0.5", "# Step:  7 Bead: 0; 7;",
            "step:7 time:2; 7; 2", "i = 3, time = 1.500, E = -17.5; 0; 1.5", "note='Step: 9' Time=1; 0; 1",
            "Timestep: 100 Step=100; 100;",
        ],
    )
    fun `steps and times are read as programs write them into plain XYZ`(comment: String, step: Long, time: Double?) {
        val state = read("a.xyz", "1\n$comment\nX 1 2 3\n").single()
        assertEquals(step, state.step)
        assertEquals(time != null, state.hasTime)
        if (time != null) assertEquals(time, state.time)
    }

    @Test
    fun `a step that is no number, or said twice in two ways, is refused`() {
        refused("a.xyz:2", "soon") { read("a.xyz", "1\nTimestep: soon\nX 1 2 3\n") }
        refused("a.xyz:2", "whole number") { read("a.xyz", "1\nTimestep:\nX 1 2 3\n") }
        refused("a.xyz:2", "twice") { read("a.xyz", "1\nStep: 1 step=2\nX 1 2 3\n") }
    }

    @Test
    fun `a line with more values than columns that are named is refused, in plain XYZ it is not`() {
        refused("a.xyz:3", "4 values, Properties has 3") { read("a.xyz", "1\nProperties=pos:R:3\n6 1 2 3\n") }
        assertEquals(1.0, read("a.xyz", "1\nwater\nO 1 2 3 0.5\n").single().position[0][0])
    }

    @Test
    fun `a lattice of lists is read where rows and columns are the same, and refused where it leans`() {
        val upright = read("a.xyz", "1\nLattice=[[9, 0, 0], [0, 8, 0], [0, 0, 7]]\nX 1 2 3\n").single()
        assertEquals(listOf(9.0, 8.0, 7.0), upright.lengths.asList())
        refused("a.xyz:2", "by row or by column") {
            read("a.xyz", "1\nLattice=[[9, 0, 0], [2, 8, 0], [0, 0, 7]]\nX 1 2 3\n")
        }
        assertEquals(2.0, read("a.xyz", "1\nLattice=[9, 0, 0, 2, 8, 0, 0, 0, 7]\nX 1 2 3\n").single().shearOffset)
    }

    private fun data(atoms: String, masses: String = "") =
        "title\n\n1 atoms\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n" +
            "0 9 zlo zhi\n\n${masses}Atoms$atoms\n"

    @Test
    fun `atoms of a style that is not named are said to be taken as one, or refused where they may be of others`() {
        assertEquals(0.25, read("a.data", data("\n\n1 1 .5 2 4 4 4")).single().radius[0])
        assertTrue(notices.single().endsWith("7 values are taken as id type diameter density x y z")) { "$notices" }
        notices.clear()
        read("b.data", data("\n\n1 1 4 4 4", "Masses\n\n1 1\n\n"))
        assertTrue("5 values are taken as id type x y z" in notices.single()) { "$notices" }
        notices.clear()
        read("c.data", data(" # sphere\n\n1 1 .5 2 4 4 4"))
        assertEquals(emptyList<String>(), notices)
        // Style full: id molecule type charge x y z.
        refused("d.data:16", "Masses", "Atoms # sphere") {
            read("d.data", data("\n\n1 1 1 .5 4 4 4", "Masses\n\n1 1\n\n"))
        }
    }

    @Test
    fun `whether velocities are known is told in LAMMPS data, and they may be in another order`() {
        val atoms = " # atomic\n\n2 1 1 1 1\n"
        assertFalse(read("a.data", data(atoms)).single().hasVelocity)
        val moving = read("b.data", data("$atoms\nVelocities\n\n2 3 4 5")).single()
        assertTrue(moving.hasVelocity)
        assertEquals(listOf(3.0, 4.0, 5.0), moving.velocity.map { it[0] })
    }

    @ParameterizedTest
    @ValueSource(strings = ["", "id "])
    fun `whether ids are of the file is told`(id: String) {
        val value = if (id.isEmpty()) "" else "8 "
        val dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n" +
            "ITEM: ATOMS ${id}x y z\n${value}1 2 3\n"
        assertEquals(id.isNotEmpty(), read("a.dump", dump).single().hasId)
        val column = if (id.isEmpty()) "" else "id:I:1:"
        val xyz = read("a.xyz", "1\nProperties=${column}pos:R:3\n${value}1 2 3\n").single()
        assertEquals(id.isNotEmpty(), xyz.hasId)
        val csv = read("a.csv", "${id.replace(" ", ",")}x,y,z,radius\n${value.replace(" ", ",")}1,2,3,1\n").single()
        assertEquals(id.isNotEmpty(), csv.hasId)
        assertFalse(LammpsDump.keeps.keepsOrder)
        assertTrue(ExtendedXyz.keeps.keepsOrder)
        assertNull(xyz.unwrapped().unknownImages().image)
    }

    /** Two particles in two frames of steps 10 and 20; [more] adds to the group of particles. */
    private fun h5md(edges: (WritableGroup) -> Unit = ::upright, more: (WritableGroup) -> Unit = {}): Path {
        val path = home.resolve("a.h5")
        Files.deleteIfExists(path)
        HdfFile.write(path).use { file ->
            val group = file.putGroup("particles").putGroup("all")
            val box = group.putGroup("box")
            box.putAttribute("dimension", 3)
            box.putAttribute("boundary", arrayOf("periodic", "periodic", "periodic"))
            edges(box)
            val position = group.putGroup("position")
            position.putDataset("step", longArrayOf(10, 20))
            position.putDataset("value", vectors)
            more(group)
        }
        return path
    }

    private val vectors = Array(2) { t -> Array(2) { k -> DoubleArray(3) { 1.0 + t + k } } }

    private fun upright(box: WritableGroup) {
        box.putDataset("edges", doubleArrayOf(10.0, 10.0, 10.0))
    }

    private fun WritableGroup.element(name: String, value: Any, steps: Any, offset: Long? = null) {
        val group = putGroup(name)
        val step = group.putDataset("step", steps)
        if (offset != null) step.putAttribute("offset", offset)
        group.putDataset("value", value)
    }

    @Test
    fun `whether velocities are known is told in H5MD`() {
        assertFalse(H5md.read(h5md()).last().hasVelocity)
        val path = h5md { it.element("velocity", vectors, longArrayOf(10, 20)) }
        assertTrue(H5md.read(path).last().hasVelocity)
        assertEquals(3.0, H5md.read(path).last().velocity[0][1])
    }

    @ParameterizedTest
    @ValueSource(strings = ["velocity", "image", "mass"])
    fun `what is stored at other steps than positions is refused`(name: String) {
        val value: Any = when (name) {
            "velocity" -> vectors
            "image" -> Array(2) { Array(2) { IntArray(3) } }
            else -> Array(2) { doubleArrayOf(1.0, 2.0) }
        }
        for (steps in listOf(longArrayOf(10, 20), 10L)) {
            H5md.read(h5md { it.element(name, value, steps, if (steps is Long) 10L else null) })
        }
        refused("all/$name/step", "is 25 in frame 1", "step 20") {
            H5md.read(h5md { it.element(name, value, longArrayOf(10, 25)) })
        }
        refused("all/$name/step", "is 0 in frame 0", "step 10") { H5md.read(h5md { it.element(name, value, 10L) }) }
        refused("all/$name/step", "[1]") { H5md.read(h5md { it.element(name, value, longArrayOf(10)) }) }
    }

    @Test
    fun `edges in fixed intervals of steps are those of their frames`() {
        val lengths = Array(3) { t -> DoubleArray(3) { 10.0 + t } }
        val states = H5md.read(h5md({ it.element("edges", lengths, 10L) }))
        assertArrayEquals(doubleArrayOf(11.0, 12.0), DoubleArray(2) { states[it].lengths[0] })
        refused("no edges for step 10", "frame 0") { H5md.read(h5md({ it.element("edges", lengths, 20L) })) }
    }
}
