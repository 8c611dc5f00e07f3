package daphnis.core.run

import daphnis.core.format.FormatException
import daphnis.core.format.H5md
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** Which pairs are bound is part of a state: from each of a run's states another goes on to the same end. */
class BoundStateTest {
    @TempDir
    lateinit var home: Path

    private fun run(name: String, from: RunOrigin? = null, vararg settings: String): Run =
        Run.start(ScenarioJson.parse(WET, "test", settings.toList()), "test", home.resolve(name), from = from)

    private fun assertGoesOn(vararg settings: String) {
        val whole = run("whole", null, *settings).use { it.execute() }
        val recorded = Run.open(home.resolve("whole"))
        var bound = 0
        for (step in recorded.steps().dropLast(1)) {
            val state = recorded.atStep(step)
            bound += state.bound?.size ?: 0
            val again = run("$step", RunOrigin(recorded, state), *settings).use { it.execute() }
            assertEquals(whole.stateDigest, again.stateDigest) { "step $step" }
        }
        assertTrue(bound > 100) { "$bound" }
    }

    @Test
    fun `bridges go over`() = assertGoesOn()

    @Test
    fun `wells go over`() = assertGoesOn(
        "interaction={\"type\": \"stepped\", \"steps\": [[1.5, -0.5], [1.2, 0.2]]}",
        "restitution.coefficient=1",
    )

    @Test
    fun `a run that begins again from its own start does so with its bridges`() {
        val whole = run("whole").use { it.execute() }
        val recorded = Run.open(home.resolve("whole"))
        val origin = RunOrigin(recorded, recorded.atStep(20))
        // Cancelled before its first step, so it has the start only.
        run("cut", origin).use { it.execute(cancelled = { true }) }
        val again = Run.resume(home.resolve("cut")).use { it.execute() }
        assertEquals(whole.stateDigest, again.stateDigest)
    }

    @Test
    fun `what is said of pairs that are not there is refused in one line, and dropped without bridges`() {
        run("whole").use { it.execute() }
        val state = Run.open(home.resolve("whole")).atStep(20)
        val file = home.resolve("state.h5")
        fun written(bound: IntArray?) = H5md.write(listOf(state.with(bound = bound)), file, "test")
        written(state.bound)
        assertArrayEquals(state.bound, H5md.read(file).single().bound)
        val whole = H5md.read(file).single()
        H5md.write(listOf(whole, whole), file, "test")
        assertNull(H5md.read(file).last().bound)
        for (bad in listOf(
            intArrayOf(0, 1, 2),
            intArrayOf(1, 0),
            intArrayOf(0, 1_000_000),
            intArrayOf(0, 1, 0, 1),
            intArrayOf(3, 3),
        )) {
            written(bad)
            val e = assertThrows(FormatException::class.java) { H5md.read(file) }
            assertTrue("connectivity/bound" in e.message!! && '\n' !in e.message!!) { e.message!! }
        }
        // Of no interest to spheres that only meet.
        val hard = arrayOf("interaction={\"type\": \"none\"}")
        val free = run("free", RunOrigin(Run.open(home.resolve("whole")), state), *hard).use { it.execute() }
        assertTrue(free.edgeEvents == 0L && free.collisions > 0)
    }

    @Test
    fun `a state that does not say which pairs are bound brings a notice`() {
        run("whole").use { it.execute() }
        val recorded = Run.open(home.resolve("whole"))
        fun notices(bound: IntArray?) =
            run("n", RunOrigin(recorded, recorded.atStep(20).with(bound = bound))).use { it.notices }.filter {
                "bridges" in
                    it
            }
        assertEquals(1, notices(null).size)
    }

    @Test
    fun `a state without a bridge says so, and pairs of a well are no bridges`() {
        run("whole").use { it.execute() }
        val recorded = Run.open(home.resolve("whole"))
        val start = recorded.atStep(0)
        assertEquals(0, start.bound!!.size)
        run("again", RunOrigin(recorded, start)).use { again ->
            assertEquals(emptyList<String>(), again.notices.filter { "bridges" in it })
        }
        val well = arrayOf("interaction={\"type\": \"square-well\", \"ratio\": 1.5, \"depth\": 0.5}")
        run("well", null, *well).use { it.execute() }
        val inWells = Run.open(home.resolve("well"))
        val state = inWells.atStep(20)
        assertTrue(state.bound!!.isNotEmpty())
        // With no impact there is no bridge that could break or turn two back.
        val still = arrayOf("restitution.coefficient=1", "until=1.05")
        run("bridged", RunOrigin(inWells, state), *still).use { begun ->
            assertEquals(0, begun.simulation.population.bonds.count { it.isNotEmpty() })
        }
    }

    private companion object {
        const val WET = """{"name": "wet", "until": 3, "box": {"lengths": [7, 7, 7]}, "boundary": {"type": "periodic"},
            "particles": {"count": 100, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1.0},
            "placement": {"type": "random"}, "velocities": {"type": "gaussian", "sigma": 1.0},
            "interaction": {"type": "bridge", "ratio": 1.2, "energy": 0.5},
            "restitution": {"type": "constant", "coefficient": 0.8}, "timeStep": {"type": "fixed", "dt": 0.05},
            "output": {"snapshotEvery": 20}}"""
    }
}
