package daphnis.core.scenario

import daphnis.core.hill.Satellite
import daphnis.core.hill.SatelliteSpec
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Which moons a patch can have beside it. */
class MoonCheckTest {
    private fun scenario(moon: String, vararg settings: String) = ScenarioJson.parse(
        """
        {
          "units": { "speedInCmPerSecond": 100, "lengthInMetres": 1 },
          "frame": { "type": "hill", "distanceInKm": 130000 }, "box": { "lengths": [100, 100, 10] },
          "boundary": { "type": "hill-sheet" },
          "particles": { "count": 5, "sizes": { "type": "equal", "radius": 1 }, "mass": 1 },
          "bodies": [{ "radius": 3, "mass": 16, "position": [10, 0, 0] }],
          "velocities": { "type": "rest", "shearProfile": true },
          "restitution": { "type": "constant", "coefficient": 1 },
          "forces": [{ "type": "satellite", "mass": 1e6, $moon }],
          "timeStep": { "type": "orbit-fraction", "steps": 1000 }, "untilOrbits": 1
        }
        """.trimIndent(),
        "patch",
        settings.toList(),
    )

    private fun refused(moon: String, vararg settings: String): String =
        assertThrows(InputException::class.java) { ScenarioSetup.of(scenario(moon, *settings), "patch") }.message!!

    private fun accepted(moon: String, vararg settings: String) = ScenarioSetup.of(scenario(moon, *settings), "patch")

    @Test
    fun `a moon that crosses the plane within a body is refused, and one that just misses is not`() {
        // Body: 10 ± 3; moon: swings by 40 and has a radius of 2.
        val moon = """"y":-900,"e":40,"radius":2,"inclination":3,"node":0.5"""
        accepted(""""x":55.1,$moon""")
        accepted(""""x":-35.1,$moon""")
        for (x in listOf(54.9, 10.0, -34.9)) {
            val why = refused(""""x":$x,$moon""")
            assertTrue("forces[0].x" in why && "bodies[0]" in why && "45.0" in why && '\n' !in why) { why }
        }
        accepted(""""x":10,"y":-900""", "bodies=[]")
        // The body's own epicycle comes to it, a face of the box beyond which it goes on, and a patch without shear.
        val swinging = refused(""""x":55.1,$moon""", "bodies[0].velocity=[0.001,0,0]")
        assertTrue("bodies[0]" in swinging) { swinging }
        val beyond = refused(""""x":-52,"y":-900,"radius":2""", "bodies[0].position=[46,0,0]")
        assertTrue("bodies[0]" in beyond && "-54" in beyond) { beyond }
        val open = arrayOf("boundary={\"type\":\"open\"}", "velocities.shearProfile=false")
        val alone = refused(""""x":12,"y":-50""", *open)
        assertTrue("forces[0].x" in alone) { alone }
    }

    @Test
    fun `bad keys of moons are one line each`() {
        assertTrue("forces[0].inclination: is -1.0" in refused(""""x":50,"y":0,"inclination":-1"""))
        val noLength = refused(
            """"x":50,"y":0,"constant":1,"returns":true""",
            "frame.angularSpeed=1",
            "frame.distanceInKm=null",
            "units.lengthInMetres=null",
        )
        assertTrue("units.lengthInMetres" in noLength && "returns" in noLength) { noLength }
        val long = refused(""""x":50,"y":0,"returns":true""", "box.lengths=[100,1e9,10]", "particles.count=2")
        assertTrue("forces[0].returns" in long) { long }
        val fast = refused(""""x":50,"y":-900,"radius":2,"inclination":3000""")
        assertTrue("forces[0].radius" in fast) { fast }
    }

    @Test
    fun `a moon that returns has the circumference of the frame's orbit`() {
        val far = 2 * Math.PI * 1.3e8
        val setup = accepted(""""x":50,"y":${far / 2 + 7},"returns":true""")
        val moon = setup.forces.filterIsInstance<Satellite>().single()
        assertEquals(far, moon.circumference, 1e-6)
        assertEquals(7 - far / 2, moon.state(0.0)[1], 1e-6)
        val once = accepted(""""x":50,"y":-900""").forces.filterIsInstance<Satellite>().single()
        assertTrue(once.circumference.isInfinite())
    }

    @Test
    fun `the scenario of a run names the keys of moons only where they were used`() {
        val plain = ScenarioJson.write(scenario(""""x":50,"y":-900"""))
        for (key in listOf("inclination", "node", "returns")) assertFalse("\"$key\"" in plain) { key }
        val read = ScenarioJson.parse(ScenarioJson.write(scenario(""""x":50,"y":-9,"returns":true,"node":2""")), "x")
        val moon = read.forces.single() as SatelliteSpec
        assertTrue(moon.returns)
        assertEquals(2.0, moon.node)
    }
}
