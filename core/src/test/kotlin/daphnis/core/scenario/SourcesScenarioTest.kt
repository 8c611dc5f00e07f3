package daphnis.core.scenario

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.input.InputException
import daphnis.core.population.stateDigest
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import daphnis.core.run.Summary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

/** Sources and sinks, from a scenario to the rows of its series, and on from each of its states. */
class SourcesScenarioTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(vararg settings: String) = ScenarioJson.parse(GAS, "test", settings.toList())

    private fun run(name: String, from: RunOrigin? = null, vararg settings: String): Summary =
        Run.start(scenario(*settings), "test", home.resolve(name), from = from).use { it.execute() }

    /** The columns of the series of [run], by name without its unit. */
    private fun series(run: String): Map<String, List<Double>> {
        val rows = Files.readAllLines(home.resolve("$run/series.csv")).map { it.split(',') }
        val names = rows[0].map { it.substringBefore(" [") }
        return names.indices.associate { k -> names[k] to rows.drop(1).map { it[k].toDouble() } }
    }

    @Test
    fun `number, mass, momentum and energy are what came less what left, in each row`() {
        run("smooth")
        assertBudget(series("smooth"))
        // Perfectly rough spheres keep their energy, too.
        run("rough", null, "roughness={\"type\": \"constant\", \"coefficient\": 1}")
        val rows = series("rough")
        assertTrue(rows.getValue("rotational_energy").last() > 10)
        assertBudget(rows)
    }

    private fun assertBudget(rows: Map<String, List<Double>>) {
        var exchanged = 0.0
        for (k in rows.getValue("time").indices) {
            fun all(what: String) = (0..3).sumOf { rows.getValue("source${it}_$what")[k] }
            fun assertSum(column: String, what: String, scale: Double) {
                val values = rows.getValue(column)
                val difference = values[k] - values[0] - all(what)
                assertTrue(abs(difference) < 1e-12 * scale) { "$column at row $k: $difference" }
            }
            val number = rows.getValue("particles")
            assertEquals(number[k] - number[0], all("came") - all("left"))
            assertEquals(number[k] - number[0], all("mass"), 1e-9)
            assertSum("total_energy", "energy", rows.getValue("total_energy").max())
            // Walls across z take momentum along z.
            assertSum("momentum_x", "momentum_x", 1e3)
            assertSum("momentum_y", "momentum_y", 1e3)
            exchanged = all("came")
        }
        assertTrue(exchanged > 300) { "$exchanged" }
        assertTrue(rows.getValue("source3_refused").last() > 10)
        assertTrue(rows.getValue("source1_came").all { it == 0.0 } && rows.getValue("source1_left").last() > 50)
    }

    @Test
    fun `from each of its states a run goes on to the same end`() {
        val whole = run("whole")
        val recorded = Run.open(home.resolve("whole"))
        for (step in recorded.steps().dropLast(1)) {
            val again = run("$step", RunOrigin(recorded, recorded.atStep(step)))
            assertEquals(whole.stateDigest, again.stateDigest) { "step $step" }
        }
    }

    @Test
    fun `a run that was cut off writes the same rows`() {
        val whole = run("whole")
        val settings = arrayOf("output.checkpointEvery=3")
        Run.start(scenario(*settings), "test", home.resolve("cut")).use { run ->
            run.execute(cancelled = { run.simulation.step >= 7 })
        }
        val resumed = Run.resume(home.resolve("cut")).use { it.execute() }
        assertEquals(whole.stateDigest, resumed.stateDigest)
        assertEquals(series("whole"), series("cut"))
    }

    @Test
    fun `a step that fails after spheres came and left is as if it had not been, and gives the same when done again`() {
        val setup = ScenarioSetup.of(scenario(), "test")
        fun simulation(fails: Boolean): Simulation {
            var left = if (fails) 1 else 0
            val failing = Output { if (it.step == 5L && left-- > 0) error("on purpose") }
            return Simulation(
                setup.population.copy(),
                setup.boundary,
                setup.collisions(),
                FixedTimeStep(0.05),
                outputs = listOf(failing),
                sources = setup.sources,
            )
        }
        val smooth = simulation(false)
        val torn = simulation(true)
        val boxes = ArrayList<List<Int>>()
        for (simulation in listOf(smooth, torn)) {
            repeat(4) { simulation.advance() }
            val before = stateDigest(simulation.population)
            if (simulation === torn) {
                assertThrows(IllegalStateException::class.java) { simulation.advance() }
                assertEquals(before, stateDigest(simulation.population))
                assertEquals(0, simulation.sources!!.sums.counts.sum())
            }
            repeat(4) { simulation.advance() }
            boxes += simulation.population.id.sorted().flatMap { id ->
                (0..2).map { simulation.population.boxesCrossed(id, it) }
            }
        }
        assertEquals(stateDigest(smooth.population), stateDigest(torn.population))
        assertEquals(boxes[0], boxes[1])
        assertTrue(boxes[0].distinct().size > 1)
    }

    @Test
    fun `spheres are as the scenario says, or as the source says`() {
        val materials = """particles={"count": 60, "materials": [
            {"name": "a", "share": 0.5, "mass": 3, "sizes": {"type": "equal", "radius": 0.3}},
            {"name": "b", "share": 0.5, "density": 2, "sizes": {"type": "equal", "radius": 0.2}}]}"""
        val sources = """sources=[{"type": "inflow", "rate": 400, "particles": {"material": "b"}}, {"type": "inflow", "rate": 400},
            {"type": "inflow", "rate": 400, "particles": {"material": "a", "mass": 7, "sizes": {"type": "equal", "radius": 0.1}}}]"""
        val setup = ScenarioSetup.of(scenario(materials, sources), "test")
        val p = setup.population
        Simulation(p, setup.boundary, setup.collisions(), setup.timeStep, sources = setup.sources).use { it.advance() }
        val found = (0 until p.size).filter { p.id[it] >= 60 }
            .map { listOf(p.materials[p.material[it].toInt()], "${p.radius[it]}", "${p.mass[it]}".take(5)) }.distinct()
        val b = "${2 * 4.0 / 3 * Math.PI * 0.2 * 0.2 * 0.2}".take(5)
        assertEquals(setOf(listOf("b", "0.2", b), listOf("a", "0.3", "3.0"), listOf("a", "0.1", "7.0")), found.toSet())
    }

    @Test
    fun `what cannot be is refused with its key`() {
        fun inflow(rest: String) = "sources=[{\"type\": \"inflow\", $rest}]"
        fun reservoir(rest: String) = "sources=[{\"type\": \"reservoir\", $rest}]"
        val gas = "\"fillingFactor\": 0.1, \"temperature\": 1"
        for ((settings, words) in listOf(
            arrayOf(inflow("\"rate\": -1")) to "sources[0].rate: is -1.0; must be > 0",
            arrayOf(inflow("\"rate\": 0")) to "sources[0].rate",
            arrayOf(inflow("\"rate\": 3e9")) to "sources[0].rate: is 3.0E9; brings",
            arrayOf(inflow("\"rat\": 1")) to "sources[0]",
            arrayOf(inflow("\"rate\": 1, \"velocity\": [1, 2]")) to "sources[0].velocity",
            arrayOf(inflow("\"rate\": 1, \"sigma\": -1")) to "sources[0].sigma",
            arrayOf(inflow("\"rate\": 1, \"sigma\": 1e70")) to "sources[0].sigma",
            arrayOf(inflow("\"rate\": 1.9e9"), "until=1", "timeStep={\"type\": \"fixed\", \"dt\": 0.1}") to
                "sources[0].rate: is 1.9E9; brings 1.9E8 spheres in a step",
            arrayOf(reservoir("\"temperature\": 1e150, \"fillingFactor\": 0.1")) to "sources[0].temperature",
            arrayOf(inflow("\"rate\": 1, \"region\": {\"x\": [1, 99]}")) to "sources[0].region.x",
            arrayOf(inflow("\"rate\": 1, \"region\": {\"y\": [1, -1]}")) to "the lower one first",
            arrayOf(inflow("\"rate\": 1, \"region\": {\"y\": [1]}")) to "sources[0].region.y",
            arrayOf(inflow("\"rate\": 1, \"through\": \"left\", \"sigma\": 1")) to "must be one of lowerX, upperX",
            arrayOf(inflow("\"rate\": 1, \"through\": \"lowerX\"")) to "sources[0].velocity",
            arrayOf(inflow("\"rate\": 1, \"through\": \"lowerX\", \"velocity\": [-1, 0, 0], \"sigma\": 1")) to
                "must go inward",
            arrayOf(inflow("\"rate\": 1, \"through\": \"lowerX\", \"sigma\": 1, \"region\": {\"x\": [0, 1]}")) to
                "sources[0].region: has x",
            arrayOf(inflow("\"rate\": 1, \"particles\": {\"mass\": 0}")) to "sources[0].particles.mass",
            arrayOf(inflow("\"rate\": 1, \"particles\": {\"density\": -1}")) to "sources[0].particles.density",
            arrayOf(inflow("\"rate\": 1, \"particles\": {\"material\": \"ice\"}")) to "sources[0].particles.material",
            arrayOf(inflow("\"rate\": 1, \"particles\": {\"sizes\": {\"type\": \"list\", \"radii\": [0.1]}}")) to
                "sources[0].particles.sizes",
            arrayOf(inflow("\"rate\": 1, \"particles\": {\"sizes\": {\"type\": \"equal\", \"radius\": 9}}")) to
                "box.lengths",
            arrayOf(reservoir("\"temperature\": 1, \"fillingFactor\": 0.5")) to "sources[0].fillingFactor",
            arrayOf(reservoir("\"temperature\": 0, \"fillingFactor\": 0.1")) to "sources[0].temperature",
            arrayOf(reservoir("$gas, \"trials\": 0")) to "sources[0].trials",
            arrayOf(
                reservoir(
                    "$gas, \"particles\": {\"sizes\": {\"type\": \"power-law\", \"minimum\": 0.1, " +
                        "\"maximum\": 0.2, \"exponent\": 3}}",
                ),
            ) to "sources[0].particles.sizes: must be those of equal spheres",
            arrayOf(reservoir(gas), "forces=[{\"type\": \"uniform-acceleration\", \"acceleration\": [0, 0, -1]}]") to
                "sources[0]: needs spheres on which no force acts",
            arrayOf(reservoir(gas), "merging={\"type\": \"always\"}") to "neither merge nor break",
            arrayOf(reservoir(gas), "boundary={\"type\": \"lees-edwards\", \"shearRate\": 1}") to "is not sheared",
            arrayOf(inflow("\"rate\": 1"), "boundary={\"type\": \"sheared-periodic\", \"velocityJump\": 1}") to
                "sources[0]: needs a box that is not sheared",
            arrayOf(
                inflow("\"rate\": 1"),
                "boundary.faces={\"upperZ\": {\"motion\": {\"type\": \"piston\", " +
                    "\"mass\": 9}}}",
            ) to "no pistons",
            arrayOf(
                "bodies=[{\"radius\": 1, \"position\": [0, 0, 0], \"mass\": 1}]",
            ) to "sources: need spheres without",
            arrayOf("interaction={\"type\": \"square-well\", \"ratio\": 1.2, \"depth\": 1}") to "sources: need",
            arrayOf(
                "bonds={\"length\": 2, \"greatest\": 1.2}",
            ) to "sources: need spheres without interaction and bonds",
        )) {
            val e = assertThrows(InputException::class.java) { ScenarioSetup.of(scenario(*settings), "test") }
            assertTrue(words in e.message!!) { "${settings.toList()}: ${e.message}" }
            assertTrue('\n' !in e.message!!)
        }
    }

    private companion object {
        const val GAS = """{"name": "sources", "until": 1, "box": {"lengths": [9, 9, 9]},
            "boundary": {"type": "walls", "axes": "z"}, "placement": {"type": "random"},
            "particles": {"count": 150, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
            "velocities": {"type": "gaussian", "sigma": 2.0},
            "sources": [{"type": "reservoir", "region": {"x": [-4.5, 0]}, "fillingFactor": 0.1, "temperature": 3},
                {"type": "outflow", "region": {"x": [1, 3], "y": [-2, 3]}},
                {"type": "inflow", "rate": 60, "region": {"x": [2, 4.5]}, "velocity": [1, 0, -1], "sigma": 0.5},
                {"type": "inflow", "rate": 150, "through": "lowerZ", "sigma": 3}],
            "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.05},
            "output": {"snapshotEvery": 4, "seriesEvery": 1}}"""
    }
}
