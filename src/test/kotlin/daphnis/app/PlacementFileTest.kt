package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** A run that starts from what another run left, in each of the formats. */
class PlacementFileTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    /**
     * A gas of two sizes, ten steps; a scenario in the same box that starts from [file] and ends before it moves much.
     */
    private fun from(file: String, more: String = "") = Files.writeString(
        home.resolve("from.json"),
        """{ "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
            "placement": { "type": "file", "path": "$file"$more },
            "restitution": { "type": "constant", "coefficient": 1 },
            "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 0.1 }""",
    ).toString()

    @BeforeEach
    fun `a run to start from`() {
        val first = """{ "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
            "particles": { "count": 40, "sizes": { "type": "list", "radii": [0.25, 0.5] }, "density": 3 },
            "velocities": { "type": "gaussian", "sigma": 1 },
            "restitution": { "type": "constant", "coefficient": 1 },
            "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1,
            "output": { "snapshotEvery": 5 } }"""
        Files.writeString(home.resolve("first.json"), first)
        assertDone(daphnis("run", at("first.json"), "--out", at("a"), "--quiet"))
        for (format in listOf(
            "xyz",
            "h5md",
            "cartandrad",
            "lammps",
        )) {
            assertDone(daphnis("export", at("a"), "--format", format))
        }
    }

    private fun field(run: String, key: String) =
        Regex("\"$key\": (.*?),?\n").find(Files.readString(home.resolve(run).resolve("summary.json")))!!.groupValues[1]

    /** The state after a step from [file]; masses show in the energy. */
    private fun start(file: String, more: String = "", name: String = "b"): Pair<String, String> {
        val result = daphnis("run", from(file, more), "--out", at(name), "--force", "--quiet")
        assertDone(result)
        return field(name, "stateDigest") to field(name, "energy")
    }

    @Test
    fun `positions, velocities, radii and masses come from a snapshot and from each format alike`() {
        val (digest, energy) = start("a/snapshots/0000000010.h5")
        assertEquals(digest to energy, start("a/export/trajectory.h5"))
        assertEquals(digest to energy, start("a/export/trajectory.xyz"))
        assertEquals(digest to energy, start("a/export/CartAndRad.10.bin", ", \"density\": 3"))
        assertEquals(digest to energy, start("a/export/trajectory.lammpstrj"))
        assertEquals(field("a", "energy").toDouble(), energy.toDouble(), 1e-9)
    }

    @Test
    fun `the last state is taken, or the one of a step`() {
        val (fifth, _) = start("a/snapshots/0000000005.h5")
        assertEquals(fifth, start("a/export/trajectory.h5", ", \"step\": 5").first)
        assertEquals(fifth, start("a/export/trajectory.xyz", ", \"step\": 5").first)
        assertFalse(fifth == start("a/export/trajectory.h5").first)
        assertRefused(
            daphnis("describe", from("a/export/trajectory.h5", ", \"step\": 7")),
            "placement.step",
            "7",
            "0, 5, 10",
        )
    }

    @Test
    fun `a run directory keeps the file under a name that says its format, and means the same again`() {
        Files.move(home.resolve("a/export/CartAndRad.10.bin"), home.resolve("CartAndRad.10"))
        start("CartAndRad.10", ", \"density\": 3")
        assertTrue(Files.exists(home.resolve("b/initial.bin")))
        assertDone(daphnis("run", at("b/scenario.json"), "--out", at("c"), "--quiet"))
        assertDone(daphnis("compare", at("b"), at("c")))
    }

    @Test
    fun `a LAMMPS data file gives spheres, masses from its densities, and is kept in the run directory`() {
        val text = "title\n\n2 atoms\n0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\nAtoms # sphere\n\n" +
            "4 1 1 2 1 5 5\n9 1 2 2 5 5 5\n\nVelocities\n\n4 1 0 0\n9 0 0 0\n"
        Files.writeString(home.resolve("data.two"), text)
        val (_, energy) = start("data.two")
        assertEquals(Math.PI / 6 * 2 / 2, energy.toDouble(), 1e-15)
        assertEquals(text, Files.readString(home.resolve("b/initial.data")))
        Files.writeString(home.resolve("data.two"), text.replace("2 atoms", "3 atoms"))
        assertRefused(
            daphnis("describe", from("data.two")),
            "placement.path",
            "data.two:13",
            "3 particles are declared",
        )
    }

    @Test
    fun `that a text may be cut within its last number is a notice, and it is taken as it is`() {
        val whole = "x,y,z,vx,vy,vz,radius,mass\n0,0,0,1,0,0,0.5,1\n3,0,0,1,0,0,0.25,1.5\n"
        Files.writeString(home.resolve("a.csv"), whole)
        assertEquals("", daphnis("run", from("a.csv"), "--out", at("c"), "--quiet").err)
        Files.writeString(home.resolve("a.csv"), whole.dropLast(2))
        val cut = daphnis("run", from("a.csv"), "--out", at("d"), "--quiet")
        assertDone(cut)
        assertTrue("a.csv: the last line has no end" in cut.err) { cut.err }
    }

    @Test
    fun `masses that a file does not have are a notice, or follow from a density`() {
        val silent = daphnis("run", from("a/export/CartAndRad.10.bin", ", \"density\": 3"), "--out", at("b"), "--quiet")
        assertEquals("", silent.err)
        val noticed = daphnis("run", from("a/export/CartAndRad.10.bin"), "--out", at("c"), "--quiet")
        assertTrue("no masses" in noticed.err && "placement.density" in noticed.err) { noticed.err }
        assertEquals(3.0, field("b", "energy").toDouble() / field("c", "energy").toDouble(), 1e-12)
        assertTrue("no masses" in daphnis("describe", from("a/export/CartAndRad.10.bin")).out)
        assertRefused(
            daphnis("describe", from("a/export/trajectory.xyz", ", \"density\": 3")),
            "placement.density",
            "has masses",
        )
        assertRefused(
            daphnis("describe", from("a/export/CartAndRad.10.bin", ", \"density\": -3")),
            "placement.density",
            "> 0",
        )
    }

    @Test
    fun `an export that forgets masses says so`() {
        assertTrue("masses" in assertDone(daphnis("export", at("a"), "--format", "cartandrad")))
        assertFalse("masses" in assertDone(daphnis("export", at("a"), "--format", "xyz")))
    }

    @Test
    fun `lengths that xyz gives in radii come back as they were`() {
        assertDone(daphnis("export", at("a"), "--format", "xyz", "--scale", "64"))
        assertEquals(start("a/snapshots/0000000010.h5"), start("a/export/trajectory.xyz"))
    }

    @Test
    fun `what cannot be placed from is refused`() {
        assertRefused(daphnis("describe", from("a/series.csv")), "placement.path", "unknown column 'step'")
        assertRefused(
            daphnis("describe", from("a/summary.json")),
            "placement.path",
            "unknown format",
            ".h5",
            ".xyz",
            ".csv",
        )
        assertRefused(daphnis("describe", from("a/snapshots")), "placement.path", "is a directory")
        assertRefused(daphnis("describe", from("nowhere.h5")), "placement.path", "no such file")
        Files.writeString(home.resolve("point.xyz"), "1\nProperties=species:S:1:pos:R:3\nX 0 0 0\n")
        assertRefused(daphnis("describe", from("point.xyz")), "placement.path", "no radii")
        Files.writeString(home.resolve("none.xyz"), "")
        assertRefused(daphnis("describe", from("none.xyz")), "placement.path", "no state")
        Files.writeString(
            home.resolve("scale.xyz"),
            "1\nScale=0 Properties=species:S:1:pos:R:3:radius:R:1\nX 0 0 0 1\n",
        )
        assertRefused(daphnis("describe", from("scale.xyz")), "scale.xyz:2", "Scale is 0.0")
    }

    @Test
    fun `a state whose images have slid needs its time, and the run goes on from there`() {
        val sheared = """{ "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "lees-edwards", "shearRate": 1.25 },
            "particles": { "count": 150, "sizes": { "type": "equal", "radius": 0.5 } },
            "placement": { "type": "lattice" },
            "velocities": { "type": "gaussian", "sigma": 1, "shearProfile": true },
            "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.0625 }"""
        Files.writeString(
            home.resolve("sheared.json"),
            "$sheared, \"until\": 2, \"output\": { \"snapshotEvery\": 16 } }",
        )
        assertDone(daphnis("run", at("sheared.json"), "--out", at("s"), "--quiet"))
        val placed = listOf(
            "particles" to "null",
            "velocities" to "null",
            "placement" to """{ "type": "file", "path": "s/snapshots/0000000016.h5" }""",
        )
            .flatMap { (key, value) -> listOf("--set", "$key=$value") }
        assertRefused(daphnis("run", at("sheared.json"), *placed.toTypedArray()), "placement.time", "1.0")
        val at = arrayOf(*placed.toTypedArray(), "--set", "placement.time=1", "--out", at("t"), "--quiet")
        assertDone(daphnis("run", at("sheared.json"), *at))
        assertEquals(field("s", "stateDigest"), field("t", "stateDigest"))
    }
}
