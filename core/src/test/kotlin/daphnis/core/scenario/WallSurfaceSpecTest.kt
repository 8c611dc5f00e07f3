package daphnis.core.scenario

import daphnis.core.boundary.facing
import daphnis.core.collision.GuardSpec
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Surfaces in scenarios: what is made of them, and one line for each that is wrong. */
class WallSurfaceSpecTest {
    private fun text(
        surfaces: String,
        axes: String = "xyz",
        lengths: String = "[10, 12, 10]",
        more: String = "",
        amount: String = "\"fillingFactor\": 0.1",
    ) = """
        {
          "name": "s", "box": {"lengths": $lengths},
          "boundary": {"type": "walls", "axes": "$axes", "surfaces": [$surfaces]},
          "particles": {$amount, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1},
          "velocities": {"type": "gaussian", "sigma": 1},
          "restitution": {"type": "constant", "coefficient": 1},
          "until": 1 $more
        }
    """

    private fun setup(text: String) = ScenarioSetup.of(ScenarioJson.parse(text, "s", emptyList()), "s")

    private fun assertSays(part: String, text: String) {
        val e = assertThrows(InputException::class.java) { setup(text) }
        assertTrue(part in e.message!!) { e.message }
        assertTrue('\n' !in e.message!!)
    }

    private val drum = """{"type": "cylinder", "axis": [0, 2, 0], "radius": 5}"""

    @Test
    fun `the filling factor is of the room, and spheres are placed inside`() {
        val sphere = Math.PI / 6
        val half = """{"type": "plane", "point": [0, 0, 0], "normal": [1, 0, 1]}"""
        val body = """{"type": "sphere", "radius": 3, "room": "outside"}"""
        val rooms = listOf(
            text(drum) to Math.PI * 25 * 12,
            text(drum, axes = "y") to Math.PI * 25 * 12,
            text(drum, axes = "") to Math.PI * 25 * 12,
            text("""{"type": "sphere", "radius": 5}""") to 4.0 / 3 * Math.PI * 125,
            text(half) to 600.0,
            text("$drum, $half") to Math.PI * 25 * 6,
            text("$drum, $body") to Math.PI * 25 * 12 - 4.0 / 3 * Math.PI * 27,
        )
        for ((text, room) in rooms) {
            val setup = setup(text)
            assertEquals(room, setup.boundary.volume, 1e-4 * room)
            assertEquals(Math.rint(0.1 * setup.boundary.volume / sphere), setup.population.size.toDouble())
            val p = setup.population
            for (surface in setup.boundary.walls.surfaces) {
                for (k in 0 until p.size) assertTrue(surface.distance(p.x[k], p.y[k], p.z[k]) >= 0.5)
            }
        }
    }

    @Test
    fun `discs are in a circle`() {
        val circle = """{"type": "cylinder", "axis": [0, 0, 1], "radius": 5}"""
        val text = text(circle, "xy", "[10, 10]", """, "dimensions": 2""")
        val setup = setup(text)
        assertEquals(Math.PI * 25, setup.boundary.volume, 1e-9)
        assertEquals(10, setup.population.size)
        val cut =
            text(
                "$circle, {\"type\": \"plane\", \"point\": [0, 0, 0], \"normal\": [0, 1, 0]}",
                "xy",
                "[10, 10]",
                """, "dimensions": 2""",
            )
        assertEquals(Math.PI * 12.5, setup(cut).boundary.volume, 1e-3)
        assertSays(
            "with dimensions 2",
            text("""{"type": "sphere", "radius": 5}""", "xy", "[10, 10]", """, "dimensions": 2"""),
        )
    }

    @Test
    fun `walls that leave a gap or no room are refused in one line with the place`() {
        assertSays("boundary.surfaces[0]: leaves a gap: the box repeats along x", text(drum, "y", "[9, 12, 10]"))
        assertSays(
            "leaves a gap: the box repeats along y",
            text("""{"type": "sphere", "radius": 5.5}""", "xz", "[12, 10, 12]"),
        )
        assertSays(
            "leaves a gap: the box repeats along z",
            text("""{"type": "plane", "point": [0, 0, 0], "normal": [1, 0, 1]}""", "x"),
        )
        assertSays("leave no room in the box", text("""{"type": "plane", "point": [9, 0, 0], "normal": [1, 0, 0]}"""))
        assertSays(
            "must exceed that of the largest sphere",
            text("""{"type": "cylinder", "axis": [0, 1, 0], "radius": 0.4}""", amount = "\"count\": 1"),
        )
        assertSays(
            "the room between the walls has no place for more",
            text("""{"type": "sphere", "radius": 0.9}""", amount = "\"count\": 2"),
        )
    }

    @Test
    fun `wrong values are refused in one line with the place`() {
        fun plane(more: String) = text("""{"type": "plane", "point": [0, 0, 0], $more}""")
        assertSays("boundary.surfaces[0].normal", plane(""""normal": [0, 0, 0]"""))
        assertSays("must be three numbers", plane(""""normal": [0, 1]"""))
        assertSays("is of a piston", plane(""""normal": [1, 0, 0], "motion": {"type": "piston", "mass": 40}"""))
        assertSays("along the plane", plane(""""normal": [0, 0, 1e-300], "belt": [0, 0, 1]"""))
        assertSays("boundary.surfaces[0].belt", plane(""""normal": [0, 0, 1], "belt": [0, 0, 1]"""))
        assertSays("boundary.surfaces[0].restitution", plane(""""normal": [0, 0, 1], "restitution": 2"""))
        assertSays("give one of the two", plane(""""normal": [0, 0, 1], "restitution": 1, "temperature": 1"""))
        assertSays(
            "cannot be rough",
            plane(""""normal": [0, 0, 1], "temperature": 1, "roughness": {"type": "constant", "coefficient": 0}"""),
        )
        assertSays("boundary.surfaces[0].radius", text("""{"type": "cylinder", "axis": [0, 1, 0], "radius": -1}"""))
        assertSays(
            "steady or a sine",
            text("""{"type": "sphere", "radius": 5, "motion": {"type": "steady", "velocity": 1}}"""),
        )
        assertSays(
            "is of no wall",
            text(drum).replace("\"surfaces\"", "\"faces\": {\"lowerX\": {\"restitution\": 0}}, \"surfaces\""),
        )
        val crystal = """, "placement": {"type": "lattice", "lattice": "fcc"}"""
        assertSays("placement: must be random", text(drum, more = crystal))
    }

    @Test
    fun `a surface so far away that distances from it have no digits is refused`() {
        fun cylinder(r: String) =
            text("""{"type": "cylinder", "room": "outside", "axis": [0, 0, 1], "radius": $r, "point": [-$r, 0, 0]}""")
        assertSays("boundary.surfaces[0]: a cylinder of radius 1.0E15", cylinder("1e15"))
        assertSays("distances are known to", cylinder("1e7"))
        setup(cylinder("1e6"))
        assertSays("nearer points", text("""{"type": "plane", "point": [0, 1e8, 5], "normal": [0, 0, -1]}"""))
        assertSays("boundary.surfaces[0]: a sphere", text("""{"type": "sphere", "radius": 1e7, "centre": [0, 0, 0]}"""))
    }

    @Test
    fun `the smallest normal is a direction`() {
        val down = """{"type": "plane", "point": [0, 0, 2], "normal": [0, 0, -1e-300], "belt": [1, 0, 0]}"""
        assertEquals(3.0, setup(text(down)).boundary.walls.surfaces[0].distance(0.0, 0.0, -1.0))
    }

    @Test
    fun `planes that will come too near to a wall are refused`() {
        fun plane(x: Double, n: Int, v: Double) =
            """{"type": "plane", "point": [$x, 0, 0], "normal": [$n, 0, 0], "motion": {"type": "steady", "velocity": $v}}"""
        fun run(surfaces: String, until: Double) = text(surfaces).replace("\"until\": 1", "\"until\": $until")
        // 10 lengths from the other face, of which spheres need 1.
        assertSays("boundary.surfaces[0]: comes as near to the wall upperX as 1", run(plane(-5.0, 1, 1.0), 9.0))
        setup(run(plane(-5.0, 1, 1.0), 8.9))
        assertSays("boundary.surfaces[0]: comes as near to the wall lowerX", run(plane(5.0, -1, 1.0), 9.0))
        setup(run(plane(5.0, -1, -1.0), 9.0))
        val two = plane(-4.0, 1, 1.0) + ", " + plane(4.0, -1, 1.0)
        assertSays("boundary.surfaces[0]: comes as near to boundary.surfaces[1] as", run(two, 3.5))
        setup(run(two, 3.4))
        // Those that go the same way stay apart, though each alone would come too near to the other where that is now.
        setup(run(plane(-4.0, 1, 0.5) + ", " + plane(1.0, -1, -0.5), 8.5))
    }

    @Test
    fun `a plane may lie across from a piston`() {
        val floor = """{"type": "plane", "point": [-4, 0, 0], "normal": [1, 0, 0], "belt": [0, 1, 0]}"""
        val lid = """{"upperX": {"motion": {"type": "piston", "mass": 50, "position": -3}}}"""
        val boundary = setup(text(floor).replace("\"surfaces\"", "\"faces\": $lid, \"surfaces\"")).boundary
        assertEquals(listOf(6.0), boundary.walls.facing(0.0, 9.0).filter { !it.areFaces }.map { it.apart })
    }

    @Test
    fun `surfaces that shake too often in a step, and falls through a drum, are refused as those of faces are`() {
        val dt = """, "timeStep": {"type": "fixed", "dt": 1}"""
        val shakes = """{"type": "plane", "point": [-4, 0, 0], "normal": [1, 0, 0],
            "motion": {"type": "sine", "amplitude": 0.1, "frequency": 2000}}"""
        assertSays("timeStep: is so long that boundary.surfaces[0] has 2000", text(shakes, more = dt))
        val pulled = """$dt, "forces": [{"type": "uniform-acceleration", "acceleration": [0, 0, -1e8]}]"""
        assertSays("times through the room across z in a step", text(drum, more = pulled))
    }

    @Test
    fun `discs stay in their plane`() {
        fun belt(z: Int) = text(
            """{"type": "plane", "point": [-4, 0, 0], "normal": [1, 0, 0], "belt": [0, 1, $z]}""",
            "xy",
            "[10, 10]",
            """, "dimensions": 2""",
        )
        setup(belt(0))
        assertSays("boundary.surfaces[0].belt: moves along z, out of the plane of the discs", belt(1))
    }

    @Test
    fun `a plastic surface gets a guard against collapse, and its words are told`() {
        val plastic =
            """{"type": "cylinder", "axis": [0, 1, 0], "radius": 5, "restitution": 0.5, "angularVelocity": 2}"""
        assertTrue(setup(text(plastic)).scenario.guard is GuardSpec.FloorSpeed)
        assertTrue(setup(text(drum)).scenario.guard is GuardSpec.None)
        val words = setup(text(plastic)).scenario.boundary.inWords({ "$it" }, { "$it" })
        assertTrue("cylinder of radius 5.0 along (0.0 1.0 0.0), restitution 0.5, turns with 2.0 rad" in words) { words }
    }
}
