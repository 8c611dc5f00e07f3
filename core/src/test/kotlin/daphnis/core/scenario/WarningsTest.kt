package daphnis.core.scenario

import daphnis.core.run.Run
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class WarningsTest {
    @TempDir
    lateinit var home: Path

    private fun box(vararg settings: String) = ScenarioJson.parse(
        """
        {
          "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "walls" },
          "particles": { "count": 20, "sizes": { "type": "equal", "radius": 0.5 } },
          "velocities": { "type": "gaussian", "sigma": 1.0 },
          "restitution": { "type": "constant", "coefficient": 1.0 },
          "forces": [{ "type": "uniform-acceleration", "acceleration": [0, 0, -0.5] }],
          "timeStep": { "type": "fixed", "dt": 0.01 },
          "until": 0.02
        }
        """.trimIndent(),
        "box",
        settings.toList(),
    )

    private fun warningsOf(scenario: Scenario) = warnings(ScenarioSetup.of(scenario, "test"))

    @Test
    fun `a fall between walls that is fast for its step is told, one across no wall or short is not`() {
        assertEquals(emptyList<String>(), warningsOf(box()))
        val told = warningsOf(box("timeStep.dt=0.1")).single()
        assertTrue("along z" in told && "thermal speed" in told && '\n' !in told) { told }
        // Taking the step that it asks for ends it.
        val asked = told.substringAfter("take steps of ").substringBefore(" or").toDouble()
        assertEquals(emptyList<String>(), warningsOf(box("timeStep.dt=${asked * 0.99}")))
        assertEquals(1, warningsOf(box("timeStep.dt=${asked * 1.01}")).size)
        assertEquals(emptyList<String>(), warningsOf(box("timeStep.dt=0.1", "boundary.axes=xy")))
        assertEquals(emptyList<String>(), warningsOf(box("timeStep.dt=0.1", "boundary={\"type\":\"periodic\"}")))
        assertEquals(emptyList<String>(), warningsOf(box("timeStep.dt=0.1", "forces=[]")))
        assertTrue(
            "fall through the box" in warningsOf(box("timeStep.dt=0.5", "velocities={\"type\":\"rest\"}")).single(),
        )
        // Two that cancel.
        fun upward(a: Int) = """{"type":"uniform-acceleration","acceleration":[0,0,$a]}"""
        val both = "forces=[${upward(-1)},${upward(1)}]"
        assertEquals(emptyList<String>(), warningsOf(box("timeStep.dt=0.1", both)))
    }

    @Test
    fun `fewer than a hundred steps per orbit are told, a hundred are not`() {
        fun ring(steps: Int) = BuiltIn.scenario("ring-patch", listOf("box.lengths=[40,40,20]", "timeStep.steps=$steps"))
        assertEquals(emptyList<String>(), warningsOf(ring(100)))
        assertTrue("99.0 steps per orbit" in warningsOf(ring(99)).single())
    }

    @Test
    fun `no built-in scenario needs a warning`() {
        for (name in BuiltIn.names) {
            assertEquals(
                emptyList<String>(),
                warningsOf(
                    BuiltIn.scenario(
                        name,
                        if (name == "moonlet") {
                            listOf("box.lengths=[200,400,40]")
                        } else {
                            emptyList()
                        },
                    ),
                ),
            ) { name }
        }
    }

    @Test
    fun `a run says it at its start`() {
        Run.start(box("timeStep.dt=0.1"), "box", home.resolve("run")).use {
            assertEquals(warningsOf(box("timeStep.dt=0.1")), it.notices)
        }
    }
}
