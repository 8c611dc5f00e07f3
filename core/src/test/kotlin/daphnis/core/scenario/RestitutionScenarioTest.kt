package daphnis.core.scenario

import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.input.InputException
import daphnis.core.surface.Restitution
import daphnis.core.surface.ViscoelasticRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Laws of normal restitution by their names in scenarios. */
class RestitutionScenarioTest {
    private fun setup(law: String, sizes: String = EQUAL, vararg settings: String) = ScenarioSetup.of(
        ScenarioJson.parse(
            """{
              "units": { "speedInCmPerSecond": 4 },
              "box": { "lengths": [60, 60, 60] }, "boundary": { "type": "periodic" },
              "particles": { "count": 30, "sizes": $sizes, "density": 2 },
              "velocities": { "type": "gaussian", "sigma": 1 }, "restitution": { $law },
              "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 1
            }""",
            "test",
            settings.toList(),
        ),
        "test",
    )

    private fun refused(law: String, sizes: String = EQUAL): String =
        assertThrows(InputException::class.java) { setup(law, sizes) }.message.orEmpty()

    @Test
    fun `a step and a table are in centimetres per second`() {
        val step = setup(""""type": "step", "speed": 8, "coefficient": 0.25""").restitution as Restitution
        assertEquals(listOf(1.0, 0.25), listOf(1.9, 2.0).map { step.coefficient(it) })
        val plastic = setup(""""type": "step", "speed": 8, "coefficient": 0.25, "below": 0.5""").restitution
        assertEquals(0.5, (plastic as Restitution).coefficient(1.0))
        val table = setup(""""type": "table", "points": [[2, 0.75], [4, 0.5], [8, 0]]""").restitution as Restitution
        assertEquals(listOf(0.75, 0.5, 0.25, 0.0), listOf(0.1, 1.0, 1.5, 2.0).map { table.coefficient(it) })
    }

    @Test
    fun `viscoelastic spheres are measured by one that is named, or else by all where these are equal`() {
        val law = """"type": "viscoelastic", "coefficient": 0.75, "speed": 3"""
        fun of(law: String, sizes: String = EQUAL, vararg settings: String) =
            (setup(law, sizes, *settings).restitution as ViscoelasticRestitution).let {
                listOf(it.coefficient, it.speed, it.cmPerSecond, it.radius, it.mass)
            }
        val volume = 4.0 / 3 * Math.PI * 0.5 * 0.5 * 0.5
        assertEquals(listOf(0.75, 3.0, 4.0, 0.5, 2 * volume), of(law))
        assertEquals(7.0, of(law, EQUAL, "particles.mass=7")[4])
        assertEquals(listOf(1.0, 16 * volume), of("""$law, "radius": 1""", UNEQUAL).drop(3))
        assertEquals(listOf(1.0, 5.0), of("""$law, "radius": 1, "mass": 5""", UNEQUAL).drop(3))
        assertEquals(
            "test: restitution.radius: is missing; give that of two spheres that have the coefficient",
            refused(law, UNEQUAL),
        )
    }

    @Test
    fun `what is inelastic for the slowest impacts has a guard, and nothing else has`() {
        val laws = listOf(
            """"type": "constant", "coefficient": 0.9""" to true,
            """"type": "constant", "coefficient": 1""" to false,
            """"type": "step", "speed": 1, "coefficient": 0""" to false,
            """"type": "step", "speed": 1, "coefficient": 1, "below": 0.9""" to true,
            """"type": "table", "points": [[1, 1], [2, 0.5]]""" to false,
            """"type": "table", "points": [[1, 0.9], [2, 1]]""" to true,
            """"type": "viscoelastic", "coefficient": 0.5, "speed": 1""" to false,
            """"type": "bridges"""" to false,
            """"type": "borderies", "criticalSpeed": 1""" to false,
        )
        for ((law, isGuarded) in laws) {
            val setup = setup(law)
            assertEquals(isGuarded, setup.guard is FloorSpeedGuard) { law }
            assertTrue(isGuarded || setup.guard === NoGuard) { law }
            // As written into a directory.
            val again = ScenarioJson.parse(ScenarioJson.write(ScenarioJson.parse(RUN + " { $law } }", "test")), "test")
            assertEquals(ScenarioJson.write(again), ScenarioJson.write(ScenarioJson.parse(RUN + " { $law } }", "test")))
        }
    }

    @Test
    fun `what is wrong is said in one line with its key`() {
        val step = """"type": "step", "coefficient": 0.5"""
        val elastic = """"type": "viscoelastic", "coefficient": 0.5"""
        fun table(points: String) = """"type": "table", "points": $points"""
        val wrong = listOf(
            """$step, "speed": 0""" to "restitution.speed: is 0.0; must be > 0",
            """"type": "step", "speed": 1, "coefficient": 2""" to "restitution.coefficient: is 2.0; must be in [0, 1]",
            """$step, "speed": 1, "below": -1""" to "restitution.below: is -1.0; must be in [0, 1]",
            """$step, "speed": 1, "above": 1""" to "restitution.above: unknown key",
            step to "restitution.speed",
            table("[]") to "restitution.points: is []; must have one point at least, such as [[0.1, 0.9]]",
            table("[[1, 1], [2]]") to "restitution.points[1]: is [2.0]; must be a speed in cm/s and a coefficient",
            table("[[-1, 1]]") to "restitution.points[0]: is [-1.0, 1.0]; must have a speed of at least 0",
            table("[[1, 1], [1, 0.5]]") to
                "restitution.points[1]: is [1.0, 0.5]; must have a speed above that of the point before, 1.0",
            table("[[1, 1.5]]") to "restitution.points[0]: is [1.0, 1.5]; must have a coefficient in [0, 1]",
            table("5") to "restitution.points",
            """$elastic, "speed": 0""" to "restitution.speed: is 0.0; must be > 0",
            """"type": "viscoelastic", "coefficient": 0, "speed": 1""" to
                "restitution.coefficient: is 0.0; must be in (0, 1]",
            """$elastic, "speed": 1, "radius": -1""" to "restitution.radius: is -1.0; must be > 0",
            """$elastic, "speed": 1, "mass": 0""" to "restitution.mass: is 0.0; must be > 0",
            """"type": "viscous"""" to "viscoelastic",
        )
        for ((law, problem) in wrong) {
            val said = refused(law)
            assertTrue(problem in said && '\n' !in said) { "$problem: $said" }
        }
    }

    private companion object {
        const val EQUAL = """{ "type": "equal", "radius": 0.5 }"""
        const val UNEQUAL = """{ "type": "list", "radii": [0.5, 1] }"""
        const val RUN = """{ "box": { "lengths": [60, 60, 60] }, "boundary": { "type": "periodic" },
            "particles": { "count": 30, "sizes": $EQUAL }, "timeStep": { "type": "fixed", "dt": 1 }, "until": 1,
            "velocities": { "type": "gaussian", "sigma": 1 }, "restitution": """
    }
}
