package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** What `describe` accepts, a run can begin; what no run could, is refused with its key and its value. */
class HugeNumbersTest {
    @TempDir
    lateinit var folder: Path

    private val sheared = """boundary={"type":"sheared-periodic","velocityJump":1}"""
    private val sliding = """boundary={"type":"lees-edwards","shearRate":1}"""
    private val keys = listOf(
        listOf("boundary.velocityJump", sheared),
        listOf("boundary.shearRate", sliding),
        listOf("velocities.sigma"),
        listOf("velocities.sigma", sheared),
        listOf("timeStep.dt"),
        listOf("timeStep.dt", sheared),
        listOf("until"),
        listOf("box.lengths[1]"),
        listOf("box.lengths[1]", sheared),
        listOf("guard.speed", """guard={"type":"floor-speed","speed":1}"""),
        listOf("guard.duration", """guard={"type":"contact-duration","duration":1}"""),
        listOf("restitution.prefactor", """restitution={"type":"bridges","prefactor":0.3,"exponent":-0.2}"""),
        listOf("restitution.exponent", """restitution={"type":"bridges","prefactor":0.3,"exponent":-0.2}"""),
        listOf("restitution.criticalSpeed", """restitution={"type":"borderies","criticalSpeed":1}"""),
        listOf("restitution.speed", """restitution={"type":"step","speed":1,"coefficient":0.5}"""),
        listOf("restitution.points[0][0]", """restitution={"type":"table","points":[[0,0.5],[1e301,0.4]]}"""),
        listOf("restitution.speed", VISCOELASTIC),
        listOf("restitution.radius", VISCOELASTIC),
        listOf("restitution.mass", VISCOELASTIC),
        listOf("units.speedInCmPerSecond"),
        listOf("units.speedInCmPerSecond", VISCOELASTIC),
    )

    @Tag("thorough")
    @Test
    fun `what is described can begin, whatever the numbers`() {
        val wrong = ArrayList<String>()
        for ((n, key) in keys.withIndex()) {
            for (value in listOf("1e300", "-1e300", "1e100", "1e69", "-1e20", "1e20", "1e-20", "1e-300", "4.9e-324")) {
                val words = (listOf("particles.count=10") + key.drop(1) + "${key[0]}=$value").flatMap {
                    listOf("--set", it)
                }
                val described = daphnis("describe", "cooling-gas", *words.toTypedArray())
                if (described.code != 0) {
                    assertRefused(described)
                    continue
                }
                val out = "${folder.resolve("$n$value")}"
                val run = daphnis("run", "cooling-gas", *words.toTypedArray(), "--steps", "3", "--quiet", "--out", out)
                if (run.code != 0) wrong += "${key.joinToString()} $value: ${run.err.trim()}"
            }
        }
        assertEquals("", wrong.joinToString("\n"))
    }

    @Test
    fun `a jump of the speed that no run can make is refused with its key and its value`() {
        val words = arrayOf("--set", sheared, "--set", "boundary.velocityJump=1e300")
        for (command in listOf("describe", "run")) {
            assertRefused(daphnis(command, "cooling-gas", *words), "boundary.velocityJump: is 1.0E300; must be in")
        }
        assertTrue(assertDone(daphnis("describe", "cooling-gas", "--set", sheared)).isNotEmpty())
    }

    private companion object {
        const val VISCOELASTIC =
            """restitution={"type":"viscoelastic","coefficient":0.5,"speed":1,"radius":1,"mass":1}"""
    }
}
