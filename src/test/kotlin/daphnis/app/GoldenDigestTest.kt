package daphnis.app

import daphnis.core.Simulation
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.population.stateDigest
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.EngineSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.parallel.Execution
import org.junit.jupiter.api.parallel.ExecutionMode
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource

/**
 * State digests that are written down, of the built-in scenarios and of some odd ones. What engines give is compared
 * with these and not only with one another, so a change that alters the bits of all of them fails here. A new digest
 * takes an ADR and a line in the changelog (ADR 28).
 */
@Execution(ExecutionMode.SAME_THREAD)
class GoldenDigestTest {
    @Tag("thorough")
    @ParameterizedTest
    @MethodSource("built")
    fun `every engine gives the pinned digests of a built-in scenario in its first steps`(name: String) {
        val engines = allEngines.names.map { it to if (allEngines.isSpecification(it)) 1 else 2 } + ("islands" to 3)
        val steps = if (LONG) LONG_STEPS else FIRST_STEPS
        check(BuiltIn.scenario(name), name, steps, engines.map { (engine, threads) -> made(engine, threads) })
    }

    @ParameterizedTest
    @MethodSource("odd")
    fun `every engine gives the pinned digest of an odd case at its end`(name: String) {
        val text = checkNotNull(javaClass.getResource("/golden/$name.json")).readText()
        val byName = allEngines.names.flatMap { engine ->
            (if (allEngines.isSpecification(engine)) listOf(1) else listOf(1, 3)).map { made(engine, it) }
        }
        check(ScenarioJson.parse(text, name, emptyList()), name, null, byName + islands)
    }

    @Tag("thorough")
    @ParameterizedTest
    @MethodSource("whole")
    fun `the default engine gives the pinned digest at the end of a built-in scenario`(name: String) {
        val engine = EngineSpec()
        check(BuiltIn.scenario(name), name, null, listOf(made(engine.name, engine.threads)))
    }

    @Test
    fun `every pin is of a case that is tested, and all cases are pinned`() {
        assertEquals((BuiltIn.names + ODD).toSet(), PINS.keys.map { it.first }.toSet())
        assertTrue(BuiltIn.names.all { PINS.containsKey(it to FIRST_STEPS) && PINS.containsKey(it to LONG_STEPS) })
    }

    private fun made(engine: String, threads: Int): () -> CollisionEngine = { allEngines.create(engine, threads)!! }

    /** @param steps to do, or null for all */
    private fun check(scenario: Scenario, name: String, steps: Int?, engines: List<() -> CollisionEngine>) {
        for (make in engines) {
            val setup = ScenarioSetup.of(scenario, name)
            val engine = make()
            val forcing = setup.collisions(engine)
            val simulation = Simulation(
                setup.population,
                setup.boundary,
                forcing,
                setup.timeStep,
                setup.forces,
                sources = setup.sources,
            )
            val digest = simulation.use {
                while (if (steps != null) it.step < steps else it.time < setup.scenario.end * (1 - SLACK)) it.advance()
                stateDigest(it.population)
            }
            assertEquals(PINS[name to steps], digest) {
                "$name after ${steps ?: "all"} steps, ${engine.name} on ${engine.threads}"
            }
        }
    }

    private companion object {
        val LONG = System.getProperty("daphnis.long") == "true"
        const val FIRST_STEPS = 6
        const val LONG_STEPS = 30

        // Few spheres go the serial way unless told otherwise.
        val islands: () -> CollisionEngine = { IslandsEngine(FixedPool(2), fewest = 0) }

        /** A whole number of steps can fall short of the end by round-off. */
        const val SLACK = 1e-9
        val QUICK = listOf(
            "paper-figure-1",
            "elastic-gas",
            "cooling-gas",
            "driven-gas",
            "rough-gas",
            "mixture",
            "hard-discs",
            "shear-cell",
            "ring-patch",
            "rough-ring",
        )
        val ODD = listOf(
            "open-clump", "periodic-thin", "walls-gravity", "walls-driven", "walls-lattice", "sheared-dense",
            "lees-edwards-sizes", "ring-gravity", "ring-mesh", "ring-waves", "moonlet-small", "ringlet-moon", "moons",
            "big-among-small", "discs-rough",
        )

        /** Lines of `name,steps,digest`, steps empty for the end. */
        val PINS: Map<Pair<String, Int?>, String> =
            checkNotNull(GoldenDigestTest::class.java.getResource("/golden/digests.csv")).readText().lines()
                .drop(1).filter { it.isNotEmpty() }.map { it.split(',') }
                .associate { (name, steps, digest) -> (name to steps.toIntOrNull()) to digest }

        @JvmStatic
        fun built() = BuiltIn.names

        @JvmStatic
        fun odd() = ODD

        /** Those that end within seconds; all of them when there is time. */
        @JvmStatic
        fun whole() = if (LONG) BuiltIn.names else QUICK
    }
}
