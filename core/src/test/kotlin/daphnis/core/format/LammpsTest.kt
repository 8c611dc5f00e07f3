package daphnis.core.format

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class LammpsTest {
    @TempDir
    lateinit var home: Path

    private fun file(name: String, text: String): Path = Files.writeString(home.resolve(name), text.trimIndent())

    private fun refused(name: String, text: String, vararg words: String) {
        val e = assertThrows(FormatException::class.java) { SnapshotFormats.read(file(name, text)) }
        for (word in words) assertTrue(word in e.message.orEmpty()) { "'$word' is not in ${e.message}" }
    }

    private val dump = """
        ITEM: UNITS
        lj
        ITEM: TIME
        2.5
        ITEM: TIMESTEP
        100
        ITEM: NUMBER OF ATOMS
        2
        ITEM: BOX BOUNDS pp ff ss
        0 10
        -4 4
        -1 3
        ITEM: ATOMS id type x y z vx vy vz diameter mass c_pe
        7 1 9 1 2 0.5 0 -1 1.5 3 NaN
        3 2 1 -1 0 0.25 0 1 1 2 0
        ITEM: TIMESTEP
        200
        ITEM: NUMBER OF ATOMS
        1
        ITEM: BOX BOUNDS pp pp pp
        0 10
        0 8
        0 4
        ITEM: ATOMS xs ys zs
        0.5 0.75 0.25
    """

    @Test
    fun `a dump of LAMMPS, particles in any order, its box centred on the origin`() {
        val (first, second) = SnapshotFormats.read(file("dump.gran", dump))
        assertEquals(listOf(3, 7), first.id.asList())
        assertEquals(listOf(100L to 2.5, 200L to 200.0), listOf(first.step to first.time, second.step to second.time))
        assertEquals(listOf(-4.0, 4.0), first.position[0].asList())
        assertEquals(listOf(-1.0, 1.0), first.position[1].asList())
        assertEquals(listOf(0.0, 2.0), first.position[2].asList())
        assertEquals(listOf(0.25, 0.5), first.velocity[0].asList())
        assertEquals(listOf(0.5, 0.75), first.radius.asList())
        assertEquals(listOf(2.0, 3.0), first.mass.asList())
        assertEquals(listOf(10.0, 8.0, Double.NaN), first.lengths.asList())
        assertEquals(listOf(true, false, false), first.periodic.asList())
        assertTrue(first.hasMass && first.hasRadius)
        assertFalse(second.hasMass || second.hasRadius)
        assertEquals(listOf(0.0, 2.0, -1.0), List(3) { second.position[it][0] })
    }

    @Test
    fun `a tilted box has images that slide, along x and along y, and comes back as it was written`() {
        val spheres = Population(
            doubleArrayOf(-3.1, 2.0), doubleArrayOf(1.0, 0.3), doubleArrayOf(0.1, 0.2),
            doubleArrayOf(0.7, 0.0), DoubleArray(2), DoubleArray(2),
            doubleArrayOf(0.5, 0.25), doubleArrayOf(2.0, 3.0), intArrayOf(4, 0),
        )
        val box = Box.centred(10.0, 8.0, 6.0)
        for (boundary in listOf(LeesEdwards(box, 0.3), LeesEdwards(box, -0.3), HillSheet(box, 0.7), Open)) {
            val state = Snapshot.of(spheres, boundary, 20, 1.7)
            val out = home.resolve("a.lammpstrj")
            Files.newBufferedWriter(out).use { LammpsDump.write(state, it) }
            val back = SnapshotFormats.read(out).single()
            assertEquals(state.shearOffset, back.shearOffset)
            assertEquals(boundary == Open, state.shearOffset == 0.0)
            assertEquals(listOf(state.normalAxis, state.slideAxis), listOf(back.normalAxis, back.slideAxis))
            for (axis in 0..2) {
                assertEquals(state.lengths[axis], back.lengths[axis], 1e-14)
                assertArrayEquals(state.position[axis], back.position[axis])
                assertArrayEquals(state.velocity[axis], back.velocity[axis])
            }
            assertEquals(state.periodic.asList(), back.periodic.asList())
            assertEquals(listOf(0, 4), back.id.asList())
            assertEquals(listOf(3.0, 2.0), back.mass.asList())
        }
    }

    private val data = """
        LAMMPS data file via write_data, version 2 Aug 2023, timestep = 400, units = si

        2 atoms
        1 atom types

        0 10 xlo xhi
        -4 4 ylo yhi
        0 6 zlo zhi
        1.5 0 0 xy xz yz

        Atoms # sphere

        2 1 2 0.5 9 1 3 0 0 0
        1 1 1 3 1 -1 2 0 0 0

        Velocities

        1 0.5 0 0 0 0 0
        2 0 0 -1 0 0 0
    """

    @Test
    fun `a data file of style sphere has radii and densities, and its velocities go by id`() {
        val state = SnapshotFormats.read(file("data.chute", data)).single()
        assertEquals(400L, state.step)
        assertEquals(listOf(1, 2), state.id.asList())
        assertEquals(listOf(0.5, 1.0), state.radius.asList())
        assertArrayEquals(doubleArrayOf(3 * Math.PI / 6, 0.5 * Math.PI * 4 / 3), state.mass, 1e-15)
        assertEquals(listOf(-4.0, 4.0), state.position[0].asList())
        assertEquals(listOf(-1.0, 0.0), state.position[2].asList())
        assertEquals(listOf(0.5, 0.0), state.velocity[0].asList())
        assertEquals(listOf(0.0, -1.0), state.velocity[2].asList())
        assertEquals(listOf(10.0, 8.0, 6.0), state.lengths.asList())
        assertEquals(1.5, state.shearOffset)
        val silent = data.replace("Atoms # sphere", "Atoms")
        assertEquals(listOf(0.5, 1.0), SnapshotFormats.read(file("a.lmp", silent)).single().radius.asList())
    }

    @Test
    fun `a data file of style atomic has masses by type and no radii, and other sections are passed over`() {
        val text = """
            title

            2 atoms
            2 atom types
            0 10 xlo xhi

            Masses

            1 2.5 # sand
            2 4

            Pair Coeffs # lj/cut

            1 1 1
            2 1 1

            Atoms # atomic

            1 2 1 1 1
            2 1 2 2 2
        """
        val state = SnapshotFormats.read(file("b.data", text)).single()
        assertEquals(listOf(4.0, 2.5), state.mass.asList())
        assertTrue(state.hasMass)
        assertFalse(state.hasRadius)
        assertEquals(listOf(-4.0, -3.0), state.position[0].asList())
        assertEquals(listOf(1.0, 2.0), state.position[1].asList())
        assertTrue(state.lengths[1].isNaN())
        refused("c.data", text.replace("2 4\n", ""), "type 2", "no mass")
    }

    @Test
    fun `names that LAMMPS users give are known by their beginning, after endings`() {
        assertSame(LammpsDump, SnapshotFormats.of(Path.of("dump.0.gran")))
        assertSame(LammpsData, SnapshotFormats.of(Path.of("data.chute")))
        assertSame(ParticleCsv, SnapshotFormats.of(Path.of("data.csv")))
        assertSame(ParticleCsv, SnapshotFormats.of(Path.of("dump.10.txt")))
        assertThrows(FormatException::class.java) { SnapshotFormats.of(Path.of("mydata.chute")) }
    }

    @Test
    fun `what a file says twice is refused, for one of the two would be dropped`() {
        refused("a.data", data.replace("1 0.5 0 0 0 0 0", "2 0.5 0 0 0 0 0"), "a.data:19", "atom 2", "second velocity")
        val again = data.trimIndent() + "\n\nAtoms # sphere\n\n2 1 2 0.5 5 1 3 0 0 0\n1 1 1 3 1 -1 2 0 0 0\n"
        refused("b.data", again, "b.data:21", "second section Atoms")
        refused("a.dump", dump.replace("id type", "type type"), "a.dump:13", "'type' twice")
    }

    @Test
    fun `a damaged dump is refused with file, line and what was expected`() {
        refused("a.dump", dump.replace("100", "soon"), "a.dump:6", "'soon'", "number of the step")
        refused("a.dump", dump.replace("ATOMS\n        2\n", "ATOMS\n        2000000000\n"), "a.dump:8", "cannot hold")
        refused("a.dump", dump.replace("ATOMS\n        2\n", "ATOMS\n        -2\n"), "a.dump:8", "number of particles")
        refused("a.dump", dump.replace("9 1 2", "9 1"), "a.dump:14", "10 values", "11")
        refused("a.dump", dump.replace("9 1 2", "9 NaN 2"), "a.dump:14", "'NaN'", "finite number")
        refused("a.dump", dump.replace("1.5 3 NaN", "-1.5 3 NaN"), "a.dump:14", "diameter", "> 0")
        refused("a.dump", dump.replace("7 1 9", "3 1 9"), "id 3 occurs twice")
        refused("a.dump", dump.replace("x y z", "x y q"), "a.dump:13", "no x y z")
        refused("a.dump", dump.replace("pp ff ss", "pp ff"), "a.dump:9", "pp pp ff")
        refused("a.dump", dump.replace("pp ff ss", "xy yz pp pp pp"), "a.dump:9", "xy xz yz")
        refused("a.dump", dump.replace("0 10", "0 10 3"), "a.dump:10", "3 numbers")
        refused("a.dump", dump.replace("ITEM: TIMESTEP", "ITEM: STEP"), "a.dump:5", "ITEM: STEP")
        refused("a.dump", dump.substringBefore("3 2 1 -1"), "cut short", "2 particles are declared, 1 are there")
        refused("a.dump", dump.substringBefore("-1 3"), "a.dump:12", "cut short")
        refused("a.dump", dump.replace("0 10\n", "10 0\n"), "edge", "-10.0")
        val tilted = dump.replace("pp ff ss", "xy xz yz pp pp pp").replace("0 10\n", "0 10 1\n")
        refused("a.dump", tilted.replace("-4 4\n", "-4 4 1\n").replace("-1 3\n", "-1 3 0\n"), "leans")
        assertEquals(emptyList<Snapshot>(), SnapshotFormats.read(file("empty.dump", "")))
    }

    @Test
    fun `a damaged data file is refused with file, line and what was expected`() {
        refused("a.data", "", "a.data", "empty")
        refused("a.data", data.substringBefore("Atoms"), "a.data", "no section Atoms")
        refused("a.data", data.replace("2 atoms", "2000000000 atoms"), "a.data:3", "cannot hold")
        refused("a.data", data.replace("2 atoms", "3 atoms"), "3 particles are declared")
        refused("a.data", data.replace("2 atoms", "1 atoms"), "one line more")
        refused("a.data", data.replace("\n        2 atoms", ""), "N atoms")
        refused("a.data", data.replace("# sphere", "# full"), "'full'", "sphere or atomic")
        refused("a.data", data.replace("9 1 3 0 0 0", "9 1"), "6 values", "[7, 10]")
        refused("a.data", data.replace("2 1 2 0.5", "2 1 2 0"), "density", "> 0")
        refused("a.data", data.replace("2 1 2 0.5", "-2 1 2 0.5"), "id is '-2'")
        refused("a.data", data.replace("1 0.5 0 0", "9 0.5 0 0"), "no atom 9")
        refused("a.data", data.replace("0 10 xlo xhi", "0 ten xlo xhi"), "'ten'", "finite number")
        refused("a.data", data.replace("0 10 xlo xhi", "1 0 0 avec"), "general triclinic")
        refused("a.data", data.substringBefore("2 0 0 -1 0"), "cut short")
    }
}
