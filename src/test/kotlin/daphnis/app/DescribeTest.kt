package daphnis.app

import daphnis.core.input.Quantities
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

/**
 * `describe` says the physics first and in units in which a mistake of a thousand is seen; numbers against those worked
 * out by hand.
 */
class DescribeTest {
    @TempDir
    lateinit var home: Path

    private fun assertNear(expected: Double, found: String) = assertTrue(abs(found.toDouble() / expected - 1) < 6e-4) {
        "$found is not $expected"
    }

    private fun after(text: String, words: String) = text.substringAfter(words).trim().takeWhile {
        it in "0123456789.e-"
    }

    @Test
    fun `metres taken for kilometres are seen`() {
        val right = describe("ring-patch")
        val wrong = describe("ring-patch", "units.lengthInMetres=1000")
        assertTrue("radius 1.483 m" in row(right, "particles") && "radius 1.483 km" in row(wrong, "particles"))
        assertTrue(row(right, "box").startsWith("200 m x 200 m x 20 m")) { right }
        assertTrue(row(wrong, "box").startsWith("200 km x 200 km x 20 km")) { wrong }
        assertEquals("900 kg/m3", row(right, "density"))
        assertEquals("9e-7 kg/m3", row(wrong, "density"))
    }

    @Test
    fun `around an oblate planet apses and nodes turn`() {
        val harmonics = """frame.oblateness={"radiusInKm":60330,"j2":16290.71e-6,"j4":-935.83e-6,"j6":86.14e-6}"""
        val row = row(describe("ring-patch", harmonics, "frame.distanceInKm=140224"), "epicycles")
        assertTrue("apses turn by 2.698 degrees a day, nodes by -2.6" in row) { row }
        assertFalse("epicycles" in describe("ring-patch"))
    }

    @Test
    fun `a gas that cools has the length from which on vortices form, others have none`() {
        val row = row(describe("cooling-gas"), "critical length")
        // 2π √(2η/ζρ) with η* = 1.1756 η₀, ζ* = 0.1034 nT/η₀ at φ = 0.1 and ε = 0.9.
        assertNear(28.5, after(row, ""))
        assertTrue("none form in this box" in row) { row }
        assertTrue("vortices will form" in describe("cooling-gas", "restitution.coefficient=0.7"))
        for (other in listOf(
            "restitution.coefficient=1",
            "restitution.coefficient=0.5",
            "boundary={\"type\":\"walls\"}",
        )) {
            assertFalse("critical length" in describe("cooling-gas", other)) { other }
        }
        for (name in listOf("elastic-gas", "ring-patch", "shear-cell")) assertFalse("critical length" in describe(name))
    }

    @Test
    fun `a patch of ring in numbers`() {
        val text = describe("ring-patch")
        assertNear(0.5, row(text, "optical depth"))
        // Σ = 4/3 ρ r τ; the orbit at 130,000 km: 2π √(a³/GM); 0.0004 m/s is 0.04 cm/s.
        assertNear(4.0 / 3 * 900 * 1.4826 * 0.5, row(text, "surface density").substringBefore(" "))
        assertNear(13.284, row(text, "orbit").substringBefore(" h"))
        assertTrue("130000 km from saturn" in row(text, "orbit") && "40 orbits" in row(text, "orbit")) { text }
        assertEquals(0.04, row(text, "velocities").substringBefore(" cm/s").toDouble(), 0.002)
        assertTrue("0.340 at 1 cm/s" in row(text, "restitution")) { text }
        val outputs = row(text, "outputs")
        assertTrue(
            "41 snapshots" in outputs && "401 rows of series.csv" in outputs && "401 rows of transport.csv" in outputs,
        ) {
            outputs
        }
        assertTrue(
            text.indexOf("particles") < text.indexOf("steps") && text.indexOf("optical depth") < text.indexOf("cells"),
        ) {
            text
        }
    }

    @Test
    fun `the run time counts collisions, from those of a loose ring to those of a full one`() {
        // Has 10.3 million collisions, and takes 33 s; 198,000 at optical depth 0.5 in 70 orbits.
        val wave = row(describe("overstability"), "run time")
        val (least, most) = Regex("about ([0-9]+) s to ([0-9]+) s .* ([0-9]+) to ([0-9]+) collisions").find(wave)!!
            .destructured.let { (a, b, c, d) -> (a.toInt() to c.toDouble()) to (b.toInt() to d.toDouble()) }
        assertTrue(least.first in 5..12 && most.first in 25..40) { wave }
        assertEquals(10.3e6, most.second, 0.5e6)
        val thin = row(describe("overstability", "particles.opticalDepth=0.5", "untilOrbits=70"), "run time")
        assertEquals(198e3, Regex("([0-9]+) to [0-9]+ collisions").find(thin)!!.groupValues[1].toDouble(), 30e3)
        val gas = row(describe("elastic-gas"), "run time")
        assertTrue(gas.endsWith(" on one core, roughly; with the 212000 collisions of the start")) { gas }
    }

    @Test
    fun `a mesh needs memory`() {
        fun memory(vararg settings: String) =
            row(describe("self-gravity-wakes", *settings), "memory").substringAfter("Java, ").substringBefore(' ')
        assertEquals("340", memory())
        val mesh = memory("""forces[0]={"type":"self-gravity","method":"mesh"}""").toDouble()
        // As the heap has after a step: 160 to 200 B for a point per sphere, here 2.2 points.
        assertEquals(340 + 270.0, mesh, 60.0)
    }

    @Test
    fun `steps, cells and memory have units, and one of a kind is named as one`() {
        val ring = describe("ring-patch", "output.seriesEvery=8001")
        assertEquals("8000 of 3.985 min to time 1913000 s, 22.14 days", row(ring, "steps"))
        assertTrue(Regex("[0-9.]+ m x [0-9.]+ m x [0-9.]+ m").matches(row(ring, "reach in a step"))) { ring }
        assertTrue(Regex("[0-9x ]+, each [0-9.]+ m x [0-9.]+ m x [0-9.]+ m").matches(row(ring, "cells"))) { ring }
        assertTrue("1 row of series.csv," in row(ring, "outputs")) { ring }
        assertTrue(row(ring, "memory").endsWith(" of the heap of Java, 340 B per sphere")) { ring }
        val gas = describe("cooling-gas", "output.snapshotEvery=0")
        assertTrue("1 snapshot," in row(gas, "outputs")) { gas }
        assertEquals("1000 of 0.1 time units to time 100 time units", row(gas, "steps"))
        assertTrue("1 mass unit each, 2000 mass units" in row(gas, "mass")) { gas }
    }

    @Test
    fun `gravity has its scales`() {
        val text = describe("self-gravity-wakes")
        val omega = 0.00013143527
        val surface = row(text, "surface density").substringBefore(" ").toDouble()
        assertNear(
            4 * Math.PI * Math.PI * 6.6743e-11 * surface / (omega * omega),
            after(row(text, "Toomre"), "critical wavelength"),
        )
        val c = row(text, "velocities").substringBefore(" cm/s").toDouble() / 100
        assertNear(c * omega / (3.36 * 6.6743e-11 * surface), after(row(text, "Toomre"), "Q ="))
        // Of equal density r_p = (ρ 8πG / 9Ω²)^⅓ / 2 whatever the size.
        assertNear(
            Math.cbrt(400 * 8 * Math.PI * 6.6743e-11 / (9 * omega * omega)) / 2,
            after(row(text, "Hill radius"), "(r_1 + r_2) ="),
        )
        assertFalse("no self-gravity" in text)
        assertTrue("self-gravity, opening angle 0.7, softening 0.1 m, reaches 500 m" in row(text, "forces")) { text }
        assertTrue("no self-gravity" in describe("ring-patch"))
        fun gravity(keys: String) =
            row(describe("self-gravity-wakes", """forces=[{"type":"self-gravity",$keys}]"""), "forces")
        // 1,476 spheres on 200 m by 200 m are 5.2 m apart; 48 points are the next length of a transform.
        assertEquals(
            "[0] self-gravity by a mesh, points 4.167 m apart, softening 0.1 m, with all images",
            gravity(""""method":"mesh","softening":0.1"""),
        )
        assertEquals(
            "[0] self-gravity along x alone, 8 waves down to 25 m",
            gravity(""""method":"radial-modes","modes":8"""),
        )
    }

    @Test
    fun `a satellite has its mass, distance and wakes`() {
        val row = row(describe("satellite-wake", "forces[0].e=0.5"), "forces")
        assertNear(8.71e-12 * 3.7931206e16 * 1e0 / 6.6743e-11, after(row, "satellite of"))
        assertTrue("radius 14 km" in row && "167 km inside" in row && "e a = 500 m" in row) { row }
        assertNear(3 * Math.PI * 167, after(row, "wakes"))
        assertFalse("returns" in row || "i a =" in row) { row }
    }

    @Test
    fun `a moon that returns says when, and how far it leaves the plane`() {
        val row = row(describe("satellite-wake", "forces[0].returns=true", "forces[0].inclination=3"), "forces")
        assertTrue("i a = 3 km" in row) { row }
        // 133,746 km over 3/2 · 167 km; as many epicycles around a point mass.
        assertNear(133_746 / (1.5 * 167), after(row, "returns every"))
        assertNear(133_746 / (1.5 * 167), after(row, "orbits,"))
    }

    @Test
    fun `what has no unit is said to have none`() {
        val text = describe("cooling-gas")
        assertTrue("radius 0.5 length units" in row(text, "particles") && "units of speed" in row(text, "velocities")) {
            text
        }
        assertFalse(" m\n" in text || "kg" in text || "Toomre" in text || "orbit" in text) { text }
    }

    @Test
    fun `laws by name say what they are, and the coefficient at two speeds`() {
        val units = """units={"speedInCmPerSecond":2}"""
        fun said(law: String) = row(describe("cooling-gas", "restitution=$law", units), "restitution")
        val speed = "at 1.999 cm/s (as at the start)"
        assertEquals(
            "step, 0.9 below 1.5 cm/s, 0.4 from there on: 0.400 $speed, 0.900 at 1 cm/s",
            said("""{"type":"step","speed":1.5,"coefficient":0.4,"below":0.9}"""),
        )
        assertEquals(
            "table of 3 points from 0.9 at 0.5 cm/s to 0.1 at 3 cm/s: 0.367 $speed, 0.700 at 1 cm/s",
            said("""{"type":"table","points":[[0.5,0.9],[1.5,0.5],[3,0.1]]}"""),
        )
        assertEquals(
            "viscoelastic, 0.8 at 2 cm/s; of two of radius 0.5 length units and mass 1 mass unit: 0.800 $speed, 0.822 at 1 cm/s",
            said("""{"type":"viscoelastic","coefficient":0.8,"speed":2}"""),
        )
    }

    @Test
    fun `rough spheres have a law of surfaces, a moment of inertia and spins, smooth ones no such rows`() {
        val text = describe("rough-gas", """spins={"type":"rest","mean":[3,0,4]}""")
        assertEquals(
            "constant, β = 0.5 (-1 smooth, 1 perfectly rough); moment of inertia 0.4 m r^2",
            row(text, "roughness"),
        )
        assertEquals(
            "5 radians per unit of time (root mean square of the whole vector, the mean included) at the start",
            row(text, "spins"),
        )
        val one = describe("rough-gas", """spins={"type":"rest","mean":[0,0,1]}""", "roughness.coefficient=-0.5")
        assertTrue(row(one, "spins").startsWith("1 radian per unit of time (root")) { one }
        assertTrue(row(one, "roughness").startsWith("constant, β = -0.5 (-1 smooth, 1 perfectly rough);")) { one }
        assertTrue(row(text, "memory").endsWith(" of the heap of Java, 412 B per sphere")) { text }
        val coulomb = """roughness={"type":"coulomb","friction":0.3,"sticking":0.2,"momentFactor":0.5}"""
        val words = "sticking 0.2 unless friction 0.3 is too weak for that; moment of inertia 0.5 m r^2"
        assertEquals(words, row(describe("ring-patch", coulomb), "roughness"))
        val inMetres = """spins={"type":"rest","mean":[0,1,0]}"""
        val ring = describe("ring-patch", coulomb, inMetres, "units={\"lengthInMetres\":1,\"speedInCmPerSecond\":0.02}")
        assertEquals(
            "0.0002 rad/s (root mean square of the whole vector, the mean included) at the start",
            row(ring, "spins"),
        )
        assertEquals("none at the start", row(describe("rough-gas"), "spins"))
        val half = """{"type":"constant","coefficient":0.5}"""
        fun between(walls: String) = describe("cooling-gas", """boundary={"type":"walls","axes":"z",$walls}""")
        fun box(walls: String) = row(between(walls), "box").substringAfter(", walls")
        val all = "constant, β = 0.5 (-1 smooth, 1 perfectly rough)"
        assertEquals(" across z, restitution 1, surfaces smooth", box(""""restitution":1"""))
        assertEquals(
            " across z, restitution 0.8, surfaces $all",
            box(""""restitution":0.8,"roughness":{"all":$half}"""),
        )
        val slippery = """"roughness":{"lowerZ":{"type":"coulomb","friction":0.3,"sticking":0},"all":$half}"""
        assertEquals(
            " across z, restitution 1, surfaces lowerZ sticking 0 unless friction 0.3 is too weak for that; others $all",
            box(slippery),
        )
        assertEquals(
            " across z, restitution 1, surfaces upperZ $all; others smooth",
            box(""""roughness":{"upperZ":$half}"""),
        )
        assertEquals(
            " across z, restitution 1, surfaces lowerZ $all; upperZ smooth",
            box(""""roughness":{"lowerZ":$half,"upperZ":{"type":"smooth"}}"""),
        )
        val between = between(slippery)
        assertEquals("smooth; moment of inertia 0.4 m r^2", row(between, "roughness"))
        val smooth = describe("cooling-gas")
        assertFalse("roughness" in smooth || "spins" in smooth) { smooth }
    }

    @Test
    fun `bodies have no part in the velocities at the start`() {
        // σ = 0.0001 m/s of the particles; the moonlet is at rest.
        assertEquals(0.01, row(describe("moonlet"), "velocities").substringBefore(" cm/s").toDouble(), 0.0002)
    }

    @Test
    fun `threads and speeds that are none are refused in one line`() {
        assertRefused(daphnis("describe", "cooling-gas", "--set", "engine.threads=-3"), "engine.threads", "-3")
        assertRefused(daphnis("describe", "cooling-gas", "--set", "velocities.sigma=1e308"), "velocities", "double")
    }

    @Test
    fun `what a run would warn of stands at the end`() {
        assertTrue("60.0 steps per orbit" in row(describe("ring-patch", "timeStep.steps=60"), "note"))
        assertFalse("\nnote" in describe("ring-patch"))
    }

    @Test
    fun `what is written is what a run writes`() {
        for (steps in listOf(20, 25)) {
            val settings =
                listOf(
                    "particles.count=3000",
                    "until=${steps / 10.0}",
                    "output.snapshotEvery=10",
                    "output.seriesEvery=4",
                )
            val outputs = row(describe("cooling-gas", *settings.toTypedArray()), "outputs")
            val directory = home.resolve("a$steps")
            assertDone(
                daphnis(
                    "run",
                    "cooling-gas",
                    "--quiet",
                    "--out",
                    "$directory",
                    *settings.flatMap {
                        listOf("--set", it)
                    }.toTypedArray(),
                ),
            )
            val snapshots = Files.list(directory.resolve("snapshots")).use { it.toList() }
            assertTrue("${snapshots.size} snapshots" in outputs) { outputs }
            assertEquals(
                snapshots.sumOf { Files.size(it) } / 1e3,
                after(outputs, "snapshots,").toDouble(),
                0.1 * snapshots.sumOf { Files.size(it) } / 1e3,
            )
            val rows = Files.readAllLines(directory.resolve("series.csv")).size - 1
            assertTrue(outputs.lines().any { it.startsWith("$rows rows of series.csv") }) { outputs }
        }
    }

    @Test
    fun `edges of what can be described`() {
        val one = describe("cooling-gas", "particles.count=1", """velocities={"type":"rest"}""")
        assertTrue("1 sphere," in row(one, "particles") && "0 units of speed" in row(one, "velocities")) { one }
        assertTrue("none" in row(describe("ring-patch"), "guard"))
        assertTrue("bodies" in describe("moonlet") && "40 m" in row(describe("moonlet"), "bodies"))
    }

    @Test
    fun `numbers are short and written out where that is short`() {
        val cases = listOf(
            0.0 to "0", 1.0 to "1", -2.5 to "-2.5", 133746.0 to "133700", 12600.0 to "12600", 0.00013143 to "0.0001314",
            1.0e-6 to "1e-6", 1.2345678e10 to "1.235e10",
            -1.5e-20 to "-1.5e-20", 1e20 to "1e20", 1e-10 to "1e-10", Double.NaN to "NaN",
        )
        for ((value, text) in cases) assertEquals(text, Quantities.number(value))
    }

    @Test
    fun `discs are called so, and have no cells along z`() {
        val text = describe("hard-discs")
        assertTrue("per disc" in row(text, "memory") && "disc" in row(text, "particles")) { text }
        for (label in listOf("cells", "reach in a step")) {
            assertEquals(if (label == "cells") 2 else 1, row(text, label).split(" x ").size - 1) { text }
        }
        assertFalse("sphere" in row(text, "steps"))
    }

    @Test
    fun `collisions of what becomes denser are at least those of the start`() {
        for (pressed in listOf("vibrated-bed", "drum")) {
            assertTrue("at least about" in row(describe(pressed), "run time"))
        }
        assertFalse("at least" in row(describe("cooling-gas"), "run time"))
        val still = describe("shear-cell", "velocities={\"type\":\"rest\",\"shearProfile\":true}")
        assertTrue("at least" in row(still, "run time")) { still }
    }

    @Test
    fun `spins count for the collisions to come, and many in a step are told of`() {
        val spins = "spins={\"type\":\"gaussian\",\"temperature\":1.0}"
        val fast = describe("rough-gas", "velocities={\"type\":\"rest\"}", spins, "timeStep.dt=0.1")
        assertFalse("the 0 collisions" in row(fast, "run time")) { fast }
        val slow = describe("rough-gas", "timeStep.dt=4.0", "until=200")
        assertTrue("collisions of each sphere in a step, which is slow" in slow) { slow }
        assertFalse("which is slow" in fast) { fast }
    }
}
