package daphnis.core.scenario

import daphnis.core.input.InputException
import daphnis.core.wall.WallMotion
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Walls of scenarios that move, are thermal or have a restitution of their own. */
class WallFacesSpecTest {
    private fun scenario(faces: String, vararg settings: String, walls: String = "") = ScenarioJson.parse(
        """{
          "box": { "lengths": [10, 10, 10] },
          "boundary": { "type": "walls", "axes": "xz", "restitution": 0.8, $walls "faces": $faces },
          "particles": { "count": 50, "sizes": { "type": "equal", "radius": 0.5 } },
          "velocities": { "type": "gaussian", "sigma": 1 },
          "restitution": { "type": "constant", "coefficient": 1 },
          "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 5
        }""",
        "test",
        settings.toList(),
    )

    private fun setup(faces: String, vararg settings: String, walls: String = "") =
        ScenarioSetup.of(scenario(faces, *settings, walls = walls), "test")

    private fun refused(faces: String, vararg settings: String, walls: String = ""): String =
        assertThrows(InputException::class.java) { setup(faces, *settings, walls = walls) }.message.orEmpty()

    @Test
    fun `each wall has what is said of it, and the others what is said of all`() {
        val boundary = setup(
            """{ "lowerX": { "restitution": 0.3 }, "upperX": { "temperature": 2 },
                 "lowerZ": { "motion": { "type": "sine", "amplitude": 0.5, "frequency": 2, "phase": 0.25 } },
                 "upperZ": { "motion": { "type": "steady", "velocity": -1 }, "restitution": 1 } }""",
        ).boundary
        assertEquals(
            listOf(0.3, 0.8, 0.8, 0.8, 0.8, 1.0),
            (0..5).map {
                boundary.walls[it]?.restitution
                    ?: boundary.walls.restitution
            },
        )
        assertEquals(listOf(null, 2.0, null, null, null, null), (0..5).map { boundary.walls[it]?.temperature })
        assertEquals(listOf(4, 5), (0..5).filter { boundary.walls[it]?.motion != null })
        assertEquals(0.5, boundary.walls[4]!!.motion!!.displacement(0.0), 1e-15)
        assertEquals(-2.0, boundary.walls[5]!!.motion!!.displacement(2.0))
        val others = setup(
            """{ "lowerZ": { "motion": { "type": "sawtooth", "amplitude": 0.5, "frequency": 2, "rise": 0.9 } },
                 "upperZ": { "motion": { "type": "bi-parabolic", "amplitude": 0.1, "frequency": 1 } } }""",
        ).boundary
        assertEquals(0.9, (others.walls[4]?.motion as WallMotion.Sawtooth).rise)
        assertEquals(0.1, (others.walls[5]?.motion as WallMotion.BiParabolic).amplitude)
    }

    @Test
    fun `thermal walls draw by the seed of the scenario`() {
        val thermal = """{ "lowerX": { "temperature": 2 } }"""
        assertEquals(listOf(3L, 4L), listOf(3, 4).map { setup(thermal, "seed=$it").boundary.walls.seed })
    }

    @Test
    fun `spheres are placed between walls where these are at the start`() {
        val high = """{ "lowerZ": { "motion": { "type": "sine", "amplitude": 2, "frequency": 1, "phase": 0.25 } } }"""
        assertTrue(setup(high).population.z.min() >= -5.0 + 2 + 0.5)
        val low = """{ "lowerZ": { "motion": { "type": "sine", "amplitude": 2, "frequency": 1, "phase": -0.25 } } }"""
        assertTrue(setup(low).population.z.min() < -4.5)
    }

    @Test
    fun `walls that move alike keep their distance`() {
        fun pair(lower: String, upper: String) =
            """{ "lowerZ": { "motion": { $lower } }, "upperZ": { "motion": { $upper } } }"""
        fun sine(phase: Double) = """"type": "sine", "amplitude": 6, "frequency": 1, "phase": $phase"""
        fun saw(amplitude: Int, rise: Double) =
            """"type": "sawtooth", "amplitude": $amplitude, "frequency": 1, "rise": $rise"""
        fun steady(v: Double) = """"type": "steady", "velocity": $v"""
        for ((lower, upper) in listOf(
            sine(0.25) to sine(-0.75),
            saw(9, 0.75) to saw(2, 0.75),
            steady(3.0) to steady(1.5),
            steady(-3.0) to steady(-4.5),
            // They come as near as 10 − 2 · 6 sin(π φ) for a difference φ of phases.
            sine(0.0) to sine(0.2),
        )) {
            setup(pair(lower, upper))
        }
        for ((lower, upper) in listOf(
            sine(0.0) to sine(0.3),
            saw(9, 0.75) to saw(9, 0.7),
            saw(9, 0.75) to saw(-1 + 1, 0.75),
            steady(3.0) to steady(1.1),
        )) {
            val told = refused(pair(lower, upper))
            assertTrue("boundary.faces: lets the walls across z come as near to each other as" in told) { told }
        }
    }

    @Test
    fun `a run that goes on for longer is refused before its walls meet`() {
        val piston = """{ "lowerZ": { "motion": { "type": "steady", "velocity": 1 } } }"""
        val state = setup(piston).population
        ScenarioSetup.of(scenario(piston, "until=8"), "test", state)
        val told = assertThrows(InputException::class.java) {
            ScenarioSetup.of(scenario(piston, "until=9.5"), "test", state)
        }.message.orEmpty()
        assertTrue("boundary.faces: lets the walls across z come as near to each other as 0.5" in told) { told }
    }

    @Test
    fun `a reader is told what moves`() {
        fun words(faces: String) = scenario(faces).boundary.inWords({ "$it" }, { "$it" })
        val sine = """"lowerZ": { "motion": { "type": "sine", "amplitude": 2, "frequency": 1 } }"""
        assertEquals(
            "walls across xz, restitution 0.8, surfaces smooth, upperX restitution 0.5; " +
                "lowerZ sine of amplitude 2.0, frequency 1.0",
            words("""{ "upperX": { "restitution": 0.5 }, $sine }"""),
        )
        assertTrue(words("""{ "upperX": { "temperature": 3 } }""").endsWith(", upperX thermal at 3.0"))
        assertTrue(words("{}").endsWith("smooth"))
    }

    @Test
    fun `what cannot be is refused in a line that names the key`() {
        fun sine(amplitude: Any, frequency: Any, phase: Any = 0): String {
            val numbers = """"amplitude": $amplitude, "frequency": $frequency, "phase": $phase"""
            return """{ "lowerZ": { "motion": { "type": "sine", $numbers } } }"""
        }
        val wrong = mapOf(
            """{ "lowerY": { "restitution": 1 } }""" to "boundary.faces.lowerY is of no wall",
            """{ "lowerX": { "restitution": 1.5 } }""" to "boundary.faces.lowerX.restitution is 1.5",
            """{ "lowerX": { "temperature": 0 } }""" to "boundary.faces.lowerX.temperature is 0.0",
            """{ "lowerX": { "temperature": 1, "restitution": 1 } }""" to "boundary.faces.lowerX.restitution does not",
            sine(-1, 1) to "boundary.faces.lowerZ.motion.amplitude is -1.0",
            sine(1, 0) to "boundary.faces.lowerZ.motion.frequency is 0.0",
            sine(1, 1, 2) to "boundary.faces.lowerZ.motion.phase is 2.0",
            sine(1, 1e300) to "boundary.faces.lowerZ.motion.frequency is",
            sine(9.5, 1) to "boundary.faces lets the walls across z come as near",
            sine(1, 2e5) to "timeStep is so long that a wall across z has 2000.0 cycles",
            """{ "lowerZ": { "motion": { "type": "steady", "velocity": 1.9 } } }""" to "boundary.faces lets the walls",
            """{ "lowerZ": { "motion": { "type": "steady", "velocity": 1e300 } } }""" to
                "boundary.faces.lowerZ.motion.velocity is",
            """{ "lowerZ": { "motion": { "type": "sawtooth", "amplitude": 1, "frequency": 1, "rise": 1 } } }""" to
                "boundary.faces.lowerZ.motion.rise is 1.0",
        )
        for ((faces, expected) in wrong) {
            val message = refused(faces)
            assertTrue(
                expected.replace(" is", ": is").replace(" lets", ": lets").replace(" does", ": does") in message,
            ) {
                "$message; expected $expected"
            }
            assertTrue('\n' !in message)
        }
        val beyond = refused(sine(12, 1, 0.25))
        assertTrue("boundary.faces: puts walls beyond one another at the start" in beyond && '\n' !in beyond) { beyond }
        // As long as the walls do not meet.
        setup("""{ "lowerZ": { "motion": { "type": "steady", "velocity": 1.7 } } }""")
        val rough = """"roughness": { "all": { "type": "constant", "coefficient": 1 } },"""
        val both = refused("""{ "lowerX": { "temperature": 1 } }""", walls = rough)
        assertTrue("boundary.faces.lowerX: has a temperature" in both) { both }
    }

    @Test
    fun `a fall that bounces too often in a step is refused`() {
        fun falling(g: String) = """forces=[{"type": "uniform-acceleration", "acceleration": [0, 0, $g]}]"""
        setup("{}", falling("1e9"))
        val told = refused("{}", falling("-1e12"))
        assertTrue("timeStep: is so long that spheres fall" in told && "across z" in told) { told }
    }
}
