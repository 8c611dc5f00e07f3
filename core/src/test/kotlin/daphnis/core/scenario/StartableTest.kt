package daphnis.core.scenario

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource

/** [ScenarioSetup.check] refuses nothing that can start; what it refuses is in [HostileScenarioTest]. */
class StartableTest {
    @ParameterizedTest
    @MethodSource("names")
    fun `every scenario that is built in can start`(name: String) {
        ScenarioSetup.check(BuiltIn.scenario(name), name)
    }

    @Test
    fun `a step that is long only without the flow at the places of spheres is not refused`() {
        val settings = listOf(
            "particles.count=50",
            "placement.type=random",
            "velocities={\"type\":\"rest\",\"shearProfile\":true}",
            "timeStep={\"type\":\"cell-crossing\",\"longest\":1000}",
        )
        val scenario = BuiltIn.scenario("shear-cell", settings)
        ScenarioSetup.of(scenario, "cell")
        ScenarioSetup.check(scenario, "cell")
    }

    @Test
    fun `that spheres find no place is told by their placement alone`() {
        val full = BuiltIn.scenario("cooling-gas", listOf("particles.count=50", "box.lengths=[3.4,3.4,3.4]"))
        ScenarioSetup.check(full, "full")
        assertThrows(InputException::class.java) { ScenarioSetup.of(full, "full") }
        val most = BuiltIn.scenario("cooling-gas", listOf("particles.count=60", "box.lengths=[3.4,3.4,3.4]"))
        val e = assertThrows(InputException::class.java) { ScenarioSetup.check(most, "most") }
        assertTrue("particles.count: is 60" in e.message!!) { e.message!! }
    }

    @Test
    fun `what forces would do in the first step is tried on a copy of the state`() {
        val settings = listOf(
            "particles.count=50",
            "velocities={\"type\":\"rest\"}",
            "forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[1,2,3]}]",
            "timeStep={\"type\":\"fixed\",\"dt\":0.1}",
        )
        val start = ScenarioSetup.of(BuiltIn.scenario("cooling-gas", settings), "gas").population
        for (axis in 0..2) assertTrue(start.velocity(axis).all { it == 0.0 })
    }

    private companion object {
        @JvmStatic
        fun names() = BuiltIn.names
    }
}
