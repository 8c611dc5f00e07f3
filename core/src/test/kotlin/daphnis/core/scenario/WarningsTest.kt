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
    fun `fewer than a hundred steps per orbit are told, a hundred are not`() {
        fun ring(steps: Int) = BuiltIn.scenario("ring-patch", listOf("box.lengths=[40,40,20]", "timeStep.steps=$steps"))
        assertEquals(emptyList<String>(), warningsOf(ring(100)))
        assertTrue("99.0 steps per orbit" in warningsOf(ring(99)).single())
    }

    @Test
    fun `steps are counted in vertical periods where these are shorter than an orbit`() {
        fun ring(factor: Double, steps: Int) = warningsOf(
            BuiltIn.scenario(
                "ring-patch",
                listOf("box.lengths=[40,40,20]", "frame.verticalFactor=$factor", "timeStep.steps=$steps"),
            ),
        )
        val told = ring(3.6, 100).single()
        assertTrue("27.8 steps per vertical period" in told && "take 360 or more per orbit" in told) { told }
        assertEquals(1, ring(3.6, 359).size)
        assertEquals(emptyList<String>(), ring(3.6, 360))
        assertEquals(emptyList<String>(), ring(0.2, 100))
        assertTrue("99.0 steps per orbit" in ring(0.2, 99).single())
    }

    /** A small patch with the one [force]; Ω = 1, spheres of radius 1 and mass 1. */
    private fun attracted(force: String, steps: Int, vararg settings: String) = warningsOf(
        ScenarioJson.parse(
            """
            {
              "frame": { "type": "hill", "angularSpeed": 1 }, "box": { "lengths": [20, 20, 10] },
              "boundary": { "type": "hill-sheet" },
              "particles": { "count": 20, "sizes": { "type": "equal", "radius": 1 }, "mass": 1 },
              "velocities": { "type": "rest", "shearProfile": true },
              "restitution": { "type": "constant", "coefficient": 1 },
              "forces": [$force], "timeStep": { "type": "orbit-fraction", "steps": $steps }, "untilOrbits": 1
            }
            """.trimIndent(),
            "patch",
            settings.toList(),
        ),
    )

    @Test
    fun `each force that attracts sets a period of its own, which steps are counted in`() {
        // Ω of a contact pair is √(G · 2 / 8), of a body √(G M / R³), of a moon √(G M / d³): all are 4 here, G = 64.
        val body = """bodies=[{"radius":3,"mass":16,"position":[0,0,0]}]"""
        val one = "\"constant\":64"
        val cases = mapOf(
            "two spheres in contact" to arrayOf("""{"type":"self-gravity",$one}"""),
            "surface of a body" to arrayOf("""{"type":"body-gravity",$one}""", body),
            "satellite" to arrayOf("""{"type":"satellite",$one,"mass":16,"x":0,"y":50,"radius":3}"""),
        )
        for ((what, case) in cases) {
            fun told(steps: Int) = attracted(case[0], steps, *case.drop(1).toTypedArray()).filter { "timeStep" in it }
            assertTrue(what in told(199).single()) { "${told(199)}" }
            assertEquals(emptyList<String>(), told(200)) { what }
        }
        // Softened, or farther off, the pull is weaker.
        fun quiet(force: String) = attracted(force, 199).filter { "timeStep" in it }
        assertEquals(emptyList<String>(), quiet("""{"type":"self-gravity",$one,"softening":2}"""))
        assertEquals(emptyList<String>(), quiet("""{"type":"satellite",$one,"mass":16,"x":15,"y":50,"radius":3}"""))
        assertEquals(1, quiet("""{"type":"satellite",$one,"mass":16,"x":15,"e":2,"y":50,"radius":3}""").size)
    }

    @Test
    fun `a patch with self-gravity that is shorter than one unstable wave is told so`() {
        // 4π² G Σ of 20 spheres of mass 1 on 400: 20 for G = 10.13.
        fun told(constant: Double) =
            attracted("""{"type":"self-gravity","constant":$constant}""", 1000).filter { "wake" in it }
        assertEquals(emptyList<String>(), told(10.1))
        assertTrue("box: the edge along x is 0.99 critical wavelengths" in told(10.2).single()) { "${told(10.2)}" }
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

    @Test
    fun `a wall that goes through more than a cycle in a step is told`() {
        fun shaken(frequency: Double) = warningsOf(
            box("""boundary.faces={"lowerZ":{"motion":{"type":"sine","amplitude":0.1,"frequency":$frequency}}}"""),
        )
        assertEquals(emptyList<String>(), shaken(99.0))
        val told = shaken(250.0).single()
        assertTrue("the wall lowerZ goes through 2.50 cycles in a step" in told && "steps of 0.00400" in told) { told }
    }
}
