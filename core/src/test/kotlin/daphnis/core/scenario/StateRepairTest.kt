package daphnis.core.scenario

import daphnis.core.format.SnapshotFormats
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

/** States of others as a start: spheres outside the box, overlaps, other boxes. */
class StateRepairTest {
    @TempDir
    lateinit var home: Path

    /** A scenario in a box of edge 10 that starts from [text] in `start.dump`. */
    private fun setup(
        text: String,
        placement: String = "",
        boundary: String = "{\"type\":\"periodic\"}",
        length: Double = 10.0,
    ): ScenarioSetup {
        val file = Files.writeString(home.resolve("start.dump"), text)
        val json = """{ "box": { "lengths": [$length, 10, 10] }, "boundary": $boundary,
            "placement": { "type": "file", "path": "$file"$placement },
            "restitution": { "type": "constant", "coefficient": 1 },
            "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 100 }"""
        return ScenarioSetup.of(ScenarioJson.parse(json, "s.json"), "s.json")
    }

    private fun dump(bounds: String, vararg rows: String) = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n${rows.size}\n" +
        "ITEM: BOX BOUNDS $bounds\nITEM: ATOMS id x y z vx vy vz radius mass\n" + rows.joinToString("") { "$it\n" }

    private fun upright(vararg rows: String) = dump("pp pp pp\n0 10\n0 10\n0 10", *rows)

    private fun refused(vararg words: String, act: () -> Unit) {
        val e = assertThrows(InputException::class.java, act)
        for (word in words) assertTrue(word in e.message!!) { "'$word' is not in ${e.message}" }
    }

    private val hair = upright("1 10.02 5 5 1 0 0 0.5 1", "2 5 5 -0.01 0 0 0 0.5 1")

    @Test
    fun `a sphere outside is refused with its coordinate in the file and the way out, or put back and said`() {
        refused("particle 1 at x = 10.02 ", "x from 0.0 to 10.0", "placement.wrap") { setup(hair) }
        val start = setup(hair, ", \"wrap\": true")
        assertEquals(-4.98, start.population.x[0], 1e-12)
        assertEquals(4.99, start.population.z[1], 1e-12)
        assertEquals(0, start.population.boxesCrossed(1, 0))
        assertTrue("2 spheres are outside" in start.notices.single() && "0.02" in start.notices.single()) {
            "${start.notices}"
        }
    }

    @Test
    fun `what single precision put outside is put back without being asked`() {
        val start = setup(upright("1 10.000001 5 5 1 0 0 0.5 1"))
        assertTrue("1 sphere is outside" in start.notices.single()) { "${start.notices}" }
        assertTrue(abs(start.population.x[0]) <= 5)
        assertEquals(emptyList<String>(), setup(upright("1 10 5 5 1 0 0 0.5 1")).notices)
    }

    @Test
    fun `far outside, and through a sliding face with the velocity of the image`() {
        val far = setup(upright("1 -27 5 5 1 0 0 0.5 1"), ", \"wrap\": true")
        assertEquals(-2.0, far.population.x[0], 1e-12)
        val sliding = "{\"type\":\"lees-edwards\",\"shearRate\":0.5}"
        val text = dump("xy xz yz pp pp pp\n0 12 2\n0 10 0\n0 10 0", "1 5 11 5 3 0 0 0.5 1")
        // The image above slides with 5 per unit of time; after 0.4 it is displaced by 2, as the file's box is.
        val start = setup(text, ", \"wrap\": true, \"time\": 0.4", sliding)
        assertEquals(3.0 - 5, start.population.vx[0], 1e-12)
        assertEquals(-2.0, start.population.x[0], 1e-12)
        assertEquals(-4.0, start.population.y[0], 1e-12)
    }

    /** Soft spheres: a cubic lattice of 64 that overlap their neighbours by [depth] of a diameter, a bit displaced. */
    private fun soft(depth: Double): String {
        val rows = ArrayList<String>()
        val r = 1.25 / (1 - depth)
        var random = 12345L
        fun next(): Double {
            random = random * 6364136223846793005L + 1442695040888963407L
            return (random ushr 11) * (1.0 / (1L shl 53)) - 0.5
        }
        for (k in 0 until 60) {
            fun place(i: Int) = 1.25 + 2.5 * i + next() * 1e-6
            rows +=
                "${k + 1} ${place(
                    k % 4,
                )} ${place(k / 4 % 4)} ${place(k / 16)} ${next()} ${next()} ${next()} $r ${1 + k % 2}"
        }
        return upright(*rows.toTypedArray())
    }

    private fun deepest(p: Population, setup: ScenarioSetup) = Overlap.deepest(p, setup.boundary, 0.0).depth

    @ParameterizedTest
    @ValueSource(doubles = [1e-7, 1e-5, 4e-3])
    fun `overlaps are refused with the way out, or one factor on all radii takes them away`(depth: Double) {
        refused("overlap by", "placement.overlaps", "shrink", "relax") { setup(soft(depth)) }
        val start = setup(soft(depth), ", \"overlaps\": \"shrink\"")
        val before = SnapshotFormats.read(home.resolve("start.dump")).single()
        assertTrue(deepest(start.population, start) <= 0)
        val radii = start.population.radius
        assertTrue(radii.all { it == radii[0] } && abs(radii[0] / 1.25 - 1) < 1e-5) { "${radii[0]}" }
        for (axis in 0..2) assertArrayEquals(before.position[axis], start.population.position(axis))
        assertArrayEquals(before.mass, start.population.mass)
        assertTrue("multiplied by" in start.notices.single()) { "${start.notices}" }
    }

    /** Pairs and a chain across a face with room around them. */
    private val loose = upright(
        "1 0.2 5 5 1 0 0 0.5 1",
        "2 9.2004 5 5 0 2 0 0.5 3",
        "3 8.204 5.001 5 0 0 3 0.5 1",
        "4 5 5 5 -1 0 0 0.5 1",
        "5 5 5.7 5.7 0 0 0 0.49999 1",
        "6 3 3 3 0 0 0 0.5 1",
    )

    @Test
    fun `spheres are moved apart until none overlap, their centre of mass and all velocities stay`() {
        val start = setup(loose, ", \"overlaps\": \"relax\"")
        val p = start.population
        assertTrue(deepest(p, start) <= 0)
        val again = setup(loose, ", \"overlaps\": \"relax\"").population
        for (axis in 0..2) {
            assertArrayEquals(again.position(axis), p.position(axis))
            // Once moved across a face, a sphere is a box away.
            val sum = (0 until p.size).sumOf { p.mass[it] * p.position(axis)[it] }
            val was = listOf(
                doubleArrayOf(0.2, 9.2004, 8.204, 5.0, 5.0, 3.0),
                doubleArrayOf(5.0, 5.0, 5.001, 5.0, 5.7, 3.0),
            )
                .getOrElse(axis) { doubleArrayOf(5.0, 5.0, 5.0, 5.0, 5.7, 3.0) }
                .withIndex().sumOf { p.mass[it.index] * (it.value - 5) }
            assertEquals(was, sum, 1e-12)
        }
        assertArrayEquals(doubleArrayOf(1.0, 0.0, 0.0, -1.0, 0.0, 0.0), p.vx)
        assertArrayEquals(doubleArrayOf(-2.0, -2.0, -2.0), doubleArrayOf(p.x[5], p.y[5], p.z[5]))
        assertTrue("moved by up to" in start.notices.single() && "spheres are" in start.notices.single())
    }

    @Test
    fun `where there is no room, relaxing ends in a line, and shrinking is named`() {
        refused("placement.overlaps", "no room", "shrink") {
            // Four spheres of radius 1.38 along each edge of 10.
            val rows = (0 until 64).map {
                "${it + 1} ${1.25 + 2.5 * (it % 4)} ${1.25 + 2.5 * (it / 4 % 4)} ${1.25 + 2.5 * (it / 16)} 0 0 0 1.38 1"
            }
            setup(upright(*rows.toTypedArray()), ", \"overlaps\": \"relax\"")
        }
    }

    @Test
    fun `what is no rounding and no soft contact is not taken away`() {
        val deep = upright("1 5 5 5 0 0 0 0.5 1", "2 5.5 5 5 0 0 0 0.5 1")
        for (way in listOf("shrink", "relax")) {
            refused("particles 1 and 2", "0.5 of the sum", "at most 0.1") { setup(deep, ", \"overlaps\": \"$way\"") }
        }
        val e = assertThrows(InputException::class.java) { setup(deep) }
        assertTrue("placement.overlaps" !in e.message!!) { e.message!! }
    }

    @Test
    fun `a sphere that sticks into a wall shrinks or is moved off it`() {
        val walls = "{\"type\":\"walls\",\"axes\":\"z\"}"
        val text = dump("pp pp ff\n0 10\n0 10\n0 10", "1 5 5 0.499 0 0 1 0.5 1", "2 5 5 8 0 0 1 0.5 1")
        refused(
            "particle 1 at z = 0.499 with radius 0.5 reaches out of the box, z from 0.0 to 10.0",
            "placement.overlaps",
        ) {
            setup(text, "", walls)
        }
        val out = dump("pp pp ff\n0 10\n0 10\n0 10", "1 5 5 -0.2 0 0 1 0.5 1")
        refused("particle 1 at z = -0.2 is outside the box") { setup(out, "", walls) }
        assertEquals(0.499, setup(text, ", \"overlaps\": \"shrink\"", walls).population.radius[1], 1e-12)
        val moved = setup(text, ", \"overlaps\": \"relax\"", walls).population
        assertTrue(moved.z[0] + 5 >= 0.5 && moved.z[0] + 5 < 0.501)
        assertEquals(3.0, moved.z[1])
    }

    @Test
    fun `a box that is not the scenario's is refused with both values`() {
        val text = upright("1 5 5 5 1 0 0 0.5 1")
        refused("box.lengths[0]", "is 12.0", "is 10.0 along x") { setup(text, length = 12.0) }
        setup(text, length = 10.000001)
        val leaning = dump("xy xz yz pp pp pp\n0 12 2\n0 10 0\n0 10 0", "1 5 5 5 3 0 0 0.5 1")
        refused("boundary", "do not slide", "leans by 2.0 along x across y") { setup(leaning) }
        val sliding = "{\"type\":\"lees-edwards\",\"shearRate\":0.5}"
        refused("placement.time", "missing") { setup(leaning, "", sliding) }
        refused("boundary", "slid by 2.5", "leans by 2.0") { setup(leaning, ", \"time\": 0.5", sliding) }
        setup(leaning, ", \"time\": 0.4", sliding)
        // One box farther is the same place.
        setup(leaning, ", \"time\": 2.4", sliding)
        setup(upright("1 5 5 5 1 0 0 0.5 1"), "", "{\"type\":\"open\"}", length = 12.0)
    }

    @Test
    fun `images that slide across another axis are another box, however far they slid`() {
        val sliding = "{\"type\":\"lees-edwards\",\"shearRate\":0.5}"
        val row = "1 5 5 5 3 0 0 0.5 1"
        val across = dump("xy xz yz pp pp pp\n0 12 0\n0 10 2\n0 10 0", row)
        refused("slid by 2.0 along x across y", "leans by 2.0 along x across z") {
            setup(across, ", \"time\": 0.4", sliding)
        }
        val along = dump("abc origin pp pp pp\n10 2 0 0\n0 10 0 0\n0 0 10 0", row)
        refused("slid by 2.0 along x across y", "leans by 2.0 along y across x") {
            setup(along, ", \"time\": 0.4", sliding)
        }
        val sheet = "{\"type\":\"hill-sheet\"}, \"frame\": {\"type\":\"hill\",\"angularSpeed\":0.1}"
        refused("along y across x at time 2.0", "leans by 0.0") { setup(upright(row), ", \"time\": 2", sheet) }
        setup(upright(row), ", \"time\": 20", sheet)
        refused("slid by 2.0", "leans by 0.0") { setup(upright(row), ", \"time\": 0.4", sliding) }
        setup(upright(row), ", \"time\": 2", sliding)
    }

    @Test
    fun `what a file does not have is said`() {
        val silent = "ITEM: TIMESTEP\n70\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 10\n0 10\n0 10\n" +
            "ITEM: ATOMS id x y z radius mass\n1 5 5 5 0.5 1\n"
        val notices = setup(silent).notices
        assertTrue(notices.any { "has no velocities: all spheres start at rest" in it }) { "$notices" }
        assertTrue(notices.any { "does not repeat along z; here it does" in it }) { "$notices" }
        val walls = setup(silent, "", "{\"type\":\"walls\",\"axes\":\"z\"}").notices
        assertTrue(walls.none { "repeat" in it }) { "$walls" }
        assertEquals(emptyList<String>(), setup(upright("1 5 5 5 1 0 0 0.5 1")).notices)
        val leaning = silent.replace("pp pp ff\n0 10\n0 10\n0 10", "xy xz yz pp pp pp\n0 12 2\n0 10 0\n0 10 0")
        refused("placement.time", "does not say of which time it is") {
            setup(leaning, "", "{\"type\":\"lees-edwards\",\"shearRate\":0.5}")
        }
    }
}
