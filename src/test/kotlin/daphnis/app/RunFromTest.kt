package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** `run --from`. */
@Tag("jdk-neutral")
class RunFromTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun field(run: String, key: String) =
        Regex("\"$key\": (.*?),?\n").find(Files.readString(home.resolve(run).resolve("summary.json")))!!.groupValues[1]

    @BeforeEach
    fun `a sheared run of ten steps`() {
        val first = """{ "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "lees-edwards", "shearRate": 0.7 },
            "particles": { "count": 150, "sizes": { "type": "equal", "radius": 0.5 } },
            "placement": { "type": "lattice" },
            "velocities": { "type": "gaussian", "sigma": 1, "shearProfile": true },
            "restitution": { "type": "constant", "coefficient": 0.9 },
            "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1, "output": { "snapshotEvery": 3 } }"""
        Files.writeString(home.resolve("first.json"), first)
        assertDone(daphnis("run", at("first.json"), "--out", at("a"), "--quiet"))
    }

    @Test
    fun `without a scenario that of the run goes on, to the same digest, and the output says from where`() {
        val out = assertDone(daphnis("run", "--from", at("a") + "@6", "--out", at("b")))
        assertTrue(out.startsWith("150 spheres, from step 6 of ${at("a")}, time 0.6 to 1 unit of time, into")) { out }
        assertEquals(field("a", "stateDigest"), field("b", "stateDigest"))
        assertEquals("\"step 6 of ${at("a")}, time 0.6000000000000001\"", field("b", "from"))
        assertDone(daphnis("run", "--from", at("a") + "@time=0.6", "--out", at("c"), "--quiet"))
        assertEquals(field("a", "stateDigest"), field("c", "stateDigest"))
        assertDone(daphnis("analyze", at("b"), "--quiet"))
    }

    @Test
    fun `the last state is the default, with a scenario and settings, and steps count from it`() {
        val set = arrayOf("--set", "restitution.coefficient=0.5", "--steps", "3")
        assertDone(daphnis("run", at("first.json"), "--from", at("a"), *set, "--out", at("b"), "--quiet"))
        assertEquals("3", field("b", "steps"))
        assertEquals("\"step 10 of ${at("a")}, time 1.0\"", field("b", "from"))
        assertDone(daphnis("run", at("b/scenario.json"), "--out", at("c"), "--quiet"))
        assertDone(daphnis("compare", at("b"), at("c")))
        Files.move(home.resolve("a"), home.resolve("a@1"))
        assertDone(daphnis("run", "--from", at("a@1"), "--steps", "1", "--out", at("d"), "--quiet"))
        assertEquals("\"step 10 of ${at("a@1")}, time 1.0\"", field("d", "from"))
    }

    @Test
    fun `in Hill's frame times are told in orbits, also where there is no state`() {
        val steps = arrayOf("--steps", "6", "--set", "output.snapshotEvery=2", "--set", "box.lengths=[60,60,20]")
        assertDone(daphnis("run", "ring-patch", *steps, "--out", at("r"), "--quiet"))
        val out = assertDone(daphnis("run", "--from", at("r") + "@orbits=0.02", "--steps", "2", "--out", at("s")))
        assertTrue(", from step 4 of ${at("r")}, time 0.02 to 0.03 orbits, into ${at("s")}" in out) { out }
        val none = daphnis("run", "--from", at("r") + "@orbits=0.025", "--out", at("x"))
        assertRefused(none, "(0.025 orbits); next to it", "step 4, time 956.", "(0.02 orbits) and step 6,")
        assertRefused(daphnis("run", "--from", at("r"), "--out", at("x")), "time 0.03 orbits, and the run would end at")
        // Its steps count from its own start, yet it ends where the first run ends.
        val differ = daphnis("compare", at("r"), at("s"))
        assertEquals(1, differ.code)
        assertTrue("; both end in the same state, digest ${field("r", "stateDigest").trim('"')}" in differ.out) {
            differ.out
        }
    }

    @Test
    fun `what is wrong is said in one line`() {
        fun refused(vararg words: String, parts: List<String>) =
            assertRefused(daphnis("run", *words, "--out", at("x")), *parts.toTypedArray())
        refused("--from", at("nothing"), parts = listOf("nothing", "no such file"))
        refused("--from", home.toString(), parts = listOf("no run directory"))
        refused("--from", at("first.json"), parts = listOf("--from", "is a file", "placement.path"))
        refused("--from", at("a@5"), parts = listOf("no state after step 5", "0, 3, 6, 9, 10"))
        refused("--from", at("a@2.5"), parts = listOf("--from", "@2.5", "@20", "@time="))
        refused("--from", at("a@"), parts = listOf("--from", "'@'"))
        refused(
            "--from",
            at("a@time=0.5"),
            parts = listOf("no state at time 0.5;", "step 3, time 0.3 and step 6, time 0.6"),
        )
        refused("--from", at("a@time=soon"), parts = listOf("--from", "time=soon"))
        refused("--from", at("a@orbits=1"), parts = listOf("--from", "frame of type hill"))
        refused("--from", at("a"), parts = listOf("--from", "time 1 unit of time", "--steps", "--until"))
        refused("--from", at("a@6"), "--seed", "3", parts = listOf("--seed", "--from"))
        refused("--from", at("a@6"), "--set", "particles.count=3", parts = listOf("--set", "particles.count=3"))
        refused("--from", at("a@6"), "--set", "box.lengths[0]=9", parts = listOf("box.lengths[0]", "9.0", "8.0"))
        refused("paper-figure-1", "--from", at("a@6"), parts = listOf("paper-figure-1", "particles.count"))
        assertTrue(!Files.exists(home.resolve("x")))
    }

    @Test
    fun `where a piston is comes from the state, and so it cannot be set`() {
        val piston = """{ "box": { "lengths": [8, 4, 4] }, "particles": { "count": 20, "mass": 1,
            "sizes": { "type": "equal", "radius": 0.2 } }, "velocities": { "type": "gaussian", "sigma": 1 },
            "boundary": { "type": "walls", "axes": "x", "faces": { "lowerX": { "motion": { "type": "steady",
            "velocity": 0 } }, "upperX": { "motion": { "type": "piston", "mass": 40 } } } },
            "restitution": { "type": "constant", "coefficient": 1 },
            "timeStep": { "type": "fixed", "dt": 0.05 }, "until": 1, "output": { "snapshotEvery": 9 } }"""
        Files.writeString(home.resolve("piston.json"), piston)
        assertDone(daphnis("run", at("piston.json"), "--out", at("p"), "--quiet"))
        assertDone(daphnis("run", "--from", at("p@9"), "--out", at("q"), "--quiet"))
        assertEquals(field("p", "stateDigest"), field("q", "stateDigest"))
        val face = "boundary.faces.upperX.motion"
        for (setting in listOf("$face.position=0.5", "$face.velocity=0")) {
            val refused = daphnis("run", "--from", at("p@9"), "--set", setting, "--out", at("x"))
            assertRefused(refused, setting, "is of an initial state")
        }
        val other = arrayOf("--set", "$face.force=1", "--set", "boundary.faces.lowerX.motion.velocity=0.1")
        assertDone(daphnis("run", "--from", at("p@9"), *other, "--out", at("r"), "--quiet"))
    }
}
