package daphnis.core.scenario

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.function.ThrowingSupplier
import java.time.Duration
import kotlin.math.ceil

/** Values that a scenario can hold and no simulation can have: one line each, soon, and the same on every machine. */
class HostileScenarioTest {
    private val gas = """
        { "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
          "particles": { "count": 20, "sizes": { "type": "equal", "radius": 0.5 } },
          "velocities": { "type": "gaussian", "sigma": 1 },
          "restitution": { "type": "constant", "coefficient": 0.9 }, "timeStep": { "type": "fixed", "dt": 0.1 },
          "until": 1 }
    """.trimIndent()

    private fun setup(vararg settings: String): ScenarioSetup {
        val read =
            ThrowingSupplier { ScenarioSetup.of(ScenarioJson.parse(gas, "my.json", settings.asList()), "my.json") }
        return assertTimeoutPreemptively(Duration.ofSeconds(60), read)
    }

    private fun assertWrong(settings: List<String>, vararg parts: String) {
        val message = assertThrows(InputException::class.java) { setup(*settings.toTypedArray()) }.message.orEmpty()
        assertTrue(message.length < 1000) { message }
        assertFalse(message.any { it.isISOControl() }) { message }
        for (part in parts) assertTrue(part in message) { "'$part' is not in: $message" }
        val before = assertThrows(InputException::class.java, { check(*settings.toTypedArray()) }) { message }
        assertEquals(message, before.message)
    }

    private fun check(vararg settings: String) =
        ScenarioSetup.check(ScenarioJson.parse(gas, "my.json", settings.asList()), "my.json")

    private val slab = "box.lengths=[100,100,10]"
    private val powerLaw = """{"type":"power-law","minimum":0.1,"maximum":1,"exponent":3}"""

    @Test
    fun `a force or a frame with which no step can begin is refused by key, before and after spheres are placed`() {
        fun pull(a: String) = """{"type":"uniform-acceleration","acceleration":[0,$a,0]}"""
        assertWrong(listOf("forces=[${pull("1")},${pull("1e300")}]"), "forces[1]: cannot act in the first step")
        for ((factor, key) in listOf("1e9" to "frame.verticalFactor", "0.5" to "frame")) {
            val ring = listOf(
                """frame={"type":"hill","angularSpeed":1,"verticalFactor":$factor}""",
                """boundary={"type":"hill-sheet"}""",
                """timeStep={"type":"orbit-fraction","steps":3}""",
                """velocities={"type":"rest"}""",
            )
            assertWrong(ring, "$key: cannot act in the first step", "at most a quarter")
        }
    }

    @Test
    fun `masses whose sums or energies a double does not hold are refused by the key they follow from`() {
        val exact = "velocities.exact=true"
        for (density in listOf("1e-320", "1e-300", "1e300")) {
            assertWrong(listOf("particles.density=$density", exact), "particles.density: is", "the mass")
            val body = """{"radius":1,"position":[0,0,0],"density":$density}"""
            assertWrong(listOf("bodies=[$body]", exact), "bodies[0].density: is", "the mass")
        }
        for (mass in listOf("1e-300", "1e300")) {
            assertWrong(listOf("particles.mass=$mass"), "particles.mass: is", "1.0E-290 to 1.0E290")
        }
        assertTrue(setup("particles.density=1e-280", exact).population.vx.all { it.isFinite() })
    }

    @Test
    fun `a body outside the box is refused by its own key`() {
        val second = """{"radius":0.1,"position":[0,1e9,0]}"""
        val e = assertThrows(InputException::class.java) {
            setup("""bodies=[{"radius":0.1,"position":[0,0,0]},$second]""")
        }
        assertTrue("bodies[1].position: particle" in e.message.orEmpty()) { e.message.orEmpty() }
    }

    @Test
    fun `edges and radii whose cubes no double holds are refused by key`() {
        for (edge in listOf("5e-324", "1e-300", "1e300")) {
            assertWrong(listOf("box.lengths=[10,$edge,10]"), "box.lengths[1]", "> 0")
        }
        for (r in listOf("5e-324", "1e-120", "1e120")) {
            assertWrong(listOf("particles.sizes.radius=$r"), "particles.sizes", "> 0")
        }
        assertWrong(listOf("bodies=[{\"radius\":1e-200,\"position\":[0,0,0]}]"), "bodies[0].radius", "> 0")
    }

    @Test
    fun `the memory that spheres need is said in the unit of what there is`() {
        val tiny = """{"type":"equal","radius":0.001}"""
        val needed = ceil(150_000_000 * ScenarioSetup.BYTES_PER_SPHERE / (1 shl 20).toDouble()).toLong()
        assertWrong(
            listOf("particles.count=150000000", "particles.sizes=$tiny"),
            "particles.count",
            "need about $needed MiB, the JVM has ",
        )
    }

    @Test
    fun `more than a box can hold is said before memory, however it is asked for`() {
        for (count in listOf(5_000_000, 200_000_000)) {
            assertWrong(listOf("particles.count=$count"), "particles.count", "filling factor")
        }
        // Beyond the memory of any machine, too: least and largest radius leave open whether it fits.
        assertWrong(
            listOf("particles.count=150000000", "particles.sizes=$powerLaw", "box.lengths=[200,200,200]"),
            "particles.count",
            "filling factor",
        )
        for (sizes in listOf(
            """{"type":"equal","radius":0.01}""",
            """{"type":"power-law","minimum":0.009,"maximum":0.01,"exponent":3}""",
        )) {
            for (key in listOf("opticalDepth", "surfaceDensity")) {
                assertWrong(
                    listOf(slab, "particles={\"$key\":1e6,\"sizes\":$sizes}"),
                    "particles.$key",
                    "filling factor",
                    "0.7405",
                )
            }
        }
    }

    @Test
    fun `an optical depth that no slab holds is refused without a search`() {
        fun deep(depth: Double) =
            listOf(slab, "particles={\"opticalDepth\":$depth,\"sizes\":{\"type\":\"equal\",\"radius\":0.5}}")
        assertWrong(deep(8.0), "particles.opticalDepth", "8.0", "jam", "lattice")
        assertWrong(deep(50.0), "particles.opticalDepth", "50.0", "filling factor", "0.7405")
        assertEquals(1273, setup(*deep(0.1).toTypedArray()).population.size)
    }

    @Test
    fun `a count beyond any machine's is said as such`() {
        val tiny = """{"type":"power-law","minimum":1e-9,"maximum":2e-9,"exponent":3}"""
        assertWrong(listOf("particles={\"fillingFactor\":0.1,\"sizes\":$tiny}"), "particles.fillingFactor", "200000000")
        assertWrong(
            listOf("particles={\"fillingFactor\":0.1,\"sizes\":{\"type\":\"equal\",\"radius\":1e-9}}"),
            "particles.fillingFactor",
            "200000000",
        )
    }

    @Test
    fun `steps that cannot be counted, or do not bring the time forward, are refused`() {
        assertWrong(listOf("until=1e300", "timeStep.dt=1e-300"), "timeStep.dt", "1.0E-300", "steps")
        assertWrong(listOf("until=1e16"), "timeStep.dt", "steps")
        assertWrong(listOf("timeStep={\"type\":\"cell-crossing\",\"longest\":1e-20}"), "timeStep.longest", "steps")
    }

    @Test
    fun `a cubic lattice of one sphere between walls is a state`() {
        for (boundary in listOf("walls", "open")) {
            for (count in listOf(1, 2, 3, 9)) {
                val setup =
                    setup(
                        "boundary={\"type\":\"$boundary\"}",
                        "particles.count=$count",
                        """placement={"type":"lattice","lattice":"cubic"}""",
                    )
                assertEquals(count, setup.population.size)
            }
        }
        val hill =
            arrayOf(
                """boundary={"type":"hill-sheet"}""",
                """frame={"type":"hill","angularSpeed":1}""",
                """placement={"type":"lattice","lattice":"cubic"}""",
            )
        for (count in listOf(1, 2, 3, 9)) assertEquals(count, setup(*hill, "particles.count=$count").population.size)
    }

    @Test
    fun `a path with a NUL, and text that a terminal would obey, are shown and not obeyed`() {
        val file = "placement={\"type\":\"file\",\"path\":\"a\\u0000b.h5\"}"
        assertWrong(listOf("particles=null", "velocities=null", file), "placement.path", "a\\u0000b.h5", "NUL")
        assertWrong(listOf("restitution.type=\"\\u001b[2J\""), "restitution.type")
        assertWrong(listOf("restitution.type=\"\u202e\u0085x\""), "restitution.type")
        for (depth in listOf(65, 300, 3000, 30_000, 300_000)) {
            val parts = listOf("[" to "]", "{\"a\":" to "}")
            for ((open, close) in parts) {
                assertWrong(listOf("until=${open.repeat(depth)}1${close.repeat(depth)}"), "until", "nested too deeply")
            }
        }
        assertWrong(listOf("until=${"[".repeat(64)}1${"]".repeat(64)}"), "until", "number")
        assertWrong(listOf("${"k".repeat(100_000)}=1"), "kkk…", "unknown key")
        assertWrong(listOf("until=${"9".repeat(100_000)}"), "until", "finite number")
    }

    @Test
    fun `JSON nested beyond reason is refused where it is parsed`() {
        for (depth in listOf(300, 3000, 30_000, 300_000)) {
            val deep = gas.replace("\"until\": 1", "\"until\": ${"[".repeat(depth)}1${"]".repeat(depth)}")
            val parse =
                ThrowingSupplier { assertThrows(InputException::class.java) { ScenarioJson.parse(deep, "my.json") } }
            val message = assertTimeoutPreemptively(Duration.ofSeconds(60), parse).message.orEmpty()
            assertTrue(message.startsWith("my.json") && message.length < 300) { message }
        }
    }

    @Test
    fun `units and planets that give no finite constants are named`() {
        val hill = """boundary={"type":"hill-sheet"}"""
        fun planet(km: String) =
            arrayOf(hill, "frame={\"type\":\"hill\",\"distanceInKm\":$km}", "units.lengthInMetres=1")
        assertWrong(planet("1e-300").asList(), "frame.distanceInKm", "angular speed")
        assertWrong(planet("1e300").asList(), "frame.distanceInKm", "angular speed")
        assertWrong(
            listOf("units.lengthInMetres=1e-200", "units.massInKg=1e300", """forces=[{"type":"self-gravity"}]"""),
            "units",
            "Newton's constant",
        )
    }
}
