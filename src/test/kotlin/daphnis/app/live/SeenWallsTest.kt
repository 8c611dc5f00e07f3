package daphnis.app.live

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import daphnis.core.population.Population
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.Surroundings
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sqrt

class SeenWallsTest {
    /** What a page is told of two spheres within [boundary], at a [time]. */
    private fun seen(boundary: String, lengths: String, time: Double = 0.0): DecodedState {
        val isFlat = lengths.count { it == ',' } == 1
        val scenario = ScenarioJson.parse(
            """{"name": "walls", "seed": 1, "dimensions": ${if (isFlat) 2 else 3}, "box": {"lengths": [$lengths]},
            "boundary": {"type": "walls", $boundary},
            "particles": {"count": 2, "sizes": {"type": "equal", "radius": 0.1}, "mass": 1},
            "placement": {"type": "random"}, "velocities": {"type": "gaussian", "sigma": 0.1},
            "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.1},
            "until": 10}""",
            "test",
        )
        val around = Surroundings.of(scenario, "test")
        val none = DoubleArray(2)
        val x = doubleArrayOf(-0.3, 0.4)
        val radii = DoubleArray(2) { 0.1 }
        val state =
            State(Population(x, none, none, none, none, none, radii, DoubleArray(2) { 1.0 }), around.boundary, time)
        val walls = SeenWalls(around.boundary, scenario.boundary, time)
        return DecodedState(StateBytes(PlotScale(UnitNames(null), null, 1.0)).of(state, walls, 0))
    }

    /** Ends of lines in space, three numbers each. */
    private val DecodedState.ends: List<List<Double>>
        get() {
            val origin = numbers("origin")
            return numbers("lines").chunked(3).map { end -> end.mapIndexed { k, it -> it + origin[k] } }
        }

    private fun DecodedState.says(words: String) = assertTrue(words in text("about")) { text("about") }

    private val DecodedState.halves get() = numbers("halves").map { Math.round(it * 1e6) * 1e-6 }

    @Test
    fun `a drum is a cylinder between its end plates, and there is no box`() {
        val drum = seen(
            """"axes": "x", "surfaces": [{"type": "cylinder", "axis": [1, 0, 0], "radius": 10, "angularVelocity": 0.2}]""",
            "3, 20, 20",
        )
        drum.says("room 3.000 × 20.00 × 20.00 units of length")
        drum.says("walls across x, cylinder of radius 10.00 units of length along x that turns")
        assertEquals(listOf(1.5, 10.0, 10.0), drum.halves)
        assertTrue(drum.ends.all { (_, y, z) -> abs(hypot(y, z) - 10) < 1e-4 })
        // Two rings of 64 pieces, and eight lines from one to the other.
        for (plate in listOf(-1.5, 1.5)) assertTrue(drum.ends.count { it[0] == plate } in 128 + 8..128 + 16)
    }

    @Test
    fun `a vessel and a ball in it are great circles, and the ball is where it has moved to`() {
        val vessel = seen(
            """"axes": "", "surfaces": [{"type": "sphere", "radius": 4, "centre": [1, 0, 0]},
            {"type": "sphere", "radius": 1, "room": "outside", "motion": {"type": "steady", "velocity": 0.5}}]""",
            "10, 10, 10",
            2.0,
        )
        vessel.says("room 8.000 × 8.000 × 8.000")
        vessel.says(
            "sphere of radius 4.000 units of length, sphere of radius 1.000 units of length that moves, spheres outside",
        )
        val (large, small) = vessel.ends.partition { (x, y, z) -> abs(hypot(hypot(x - 1, y), z) - 4) < 1e-4 }
        assertEquals(3 * 64 * 2, large.size)
        assertEquals(3 * 64 * 2, small.size)
        assertTrue(small.all { (x, y, z) -> abs(hypot(hypot(x, y), z - 1) - 1) < 1e-4 })
    }

    @Test
    fun `planes are drawn where they cut the box, and only within other walls`() {
        val slope = seen(
            """"axes": "xyz", "surfaces": [{"type": "plane", "point": [0, 0, -2], "normal": [1, 0, 1]}]""",
            "8, 8, 8",
        )
        slope.says("box 8.000 × 8.000 × 8.000 units of length")
        slope.says("walls across xyz, plane with normal (1 0 1)")
        val onPlane = slope.ends.filter { (x, _, z) -> abs(x + z + 2) < 1e-4 }
        assertTrue(onPlane.any { it[0] == -4.0 && abs(it[2] - 2) < 1e-4 } && onPlane.any { it[2] == -4.0 })
        assertTrue(onPlane.size >= 2 * (4 + 10)) { "${onPlane.size}" }
        val silo = seen(
            """"axes": "z", "surfaces": [{"type": "cylinder", "axis": [0, 0, 1], "radius": 3},
            {"type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1]}]""",
            "8, 8, 8",
        )
        val floor = silo.ends.filter { abs(it[2] + 2) < 1e-4 }
        assertTrue(floor.isNotEmpty() && floor.all { (x, y, _) -> hypot(x, y) < 3.1 }) { "$floor" }
        // Nothing of the cylinder is below the floor.
        assertTrue(silo.ends.none { it[2] < -2.1 })
    }

    @Test
    fun `faces that move are drawn where they are, and pistons are named`() {
        val bed = """"axes": "z", "faces": {"lowerZ": {"motion": {"type": "sine", "amplitude": 0.5, "frequency": 1}}}"""
        val floor = seen(bed, "4, 4, 10", 0.25)
        floor.says("walls across z, lower z moves")
        assertEquals(-4.5, floor.ends.minOf { it[2] }, 1e-5)
        assertEquals(5.0, floor.ends.maxOf { it[2] }, 1e-5)
        val piston = """"axes": "z", "faces": {"upperZ": {"motion": {"type": "piston", "mass": 9, "position": -2}}}"""
        val cell = seen(piston, "4, 4, 10")
        cell.says("upper z is a piston")
        assertEquals(3.0, cell.ends.maxOf { it[2] }, 1e-5)
    }

    @Test
    fun `in a plane a cylinder is a ring`() {
        val ring = seen(""""axes": "", "surfaces": [{"type": "cylinder", "axis": [0, 0, 1], "radius": 2}]""", "4, 4")
        ring.says("room 4.000 × 4.000 units of length · cylinder of radius 2.000 units of length along z")
        assertEquals(2 * 64, ring.ends.size)
        assertTrue(ring.ends.all { (x, y, z) -> z == 0.0 && abs(sqrt(x * x + y * y) - 2) < 1e-5 })
    }
}
