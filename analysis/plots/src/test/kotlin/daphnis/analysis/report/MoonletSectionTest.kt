package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.moonlet.RandomWalk
import daphnis.core.format.FormatException
import daphnis.core.initial.SeededRandom
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.Scenario
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI

class MoonletSectionTest {
    @TempDir
    lateinit var home: Path

    /** Some 260 particles around a moonlet of 8 m, whose Hill radius is 10 m. */
    private fun scenario(vararg settings: String): Scenario = BuiltIn.scenario("moonlet-walk", SMALL + settings)

    private fun analysed(name: String, vararg settings: String): Path = home.resolve(name).also { path ->
        Run.start(scenario(*settings), name, path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 15_000.0)).write(path)
    }

    private fun numbers(path: Path): Map<String, List<String>> =
        Files.readAllLines(path.resolve("tables/numbers.csv")).drop(1).map { it.split(',') }.associateBy { it[0] }

    @Test
    fun `a report shows the ring around a moonlet, where it went and what pushed it`() {
        val path = analysed("walk", "untilOrbits=5")
        val html = Files.readString(path.resolve("report.html"))
        assertTrue(">Moonlets</h2>" in html && "bodies.csv from time 15000 s" in html)
        for (plot in listOf("moonlet", "moonlet-wake", "moonlet-walk", "moonlet-eccentricity")) {
            assertTrue(Files.size(path.resolve("plots/$plot.svg")) > 1000) { plot }
        }
        assertTrue("bodies included, which block light too" in html && "Daisaka et al." !in html)
        assertTrue("A·e of moonlets" !in html && "a·e of moonlets over the whole run" in html)
        assertTrue(Regex("The same 2 to [0-9](\\.[1-9])? Hill radii").containsMatchIn(html))
        // The scale ends where nothing is left.
        val map = Files.readString(path.resolve("plots/moonlet.svg"))
        assertTrue(">−1.0<" in map || ">−1<" in map) { map.takeLast(1000) }
        val numbers = numbers(path)
        val always = NumberKeys.MOONLET - listOf("propeller_separation", "propeller_depth")
        assertEquals(emptyList<String>(), always.filter { it !in numbers })
        // 400 kg/m³ of 8 m at 130,000 km.
        assertEquals(10.3, numbers.getValue("moonlet_hill_radius")[1].toDouble(), 0.1)
        val drift = numbers.getValue("moonlet_drift")
        assertEquals("m/orbit", drift[3])
        assertEquals("", drift[2]) { "two changes of two orbits are too few for an error" }
        assertEquals("kg m/s^2", numbers.getValue("moonlet_force_impacts")[3].replace("N", "kg m/s^2"))
        val cells = Files.readAllLines(path.resolve("tables/moonlet-map.csv"))
        assertEquals("dx [m],dy [m],excess", cells[0])
        assertEquals(0.0, cells.drop(1).map { it.substringAfterLast(',').toDouble() }.average(), 1e-9)
    }

    @Tag("thorough")
    @Test
    fun `a walk whose changes depend on those before has no diffusion, and says why`() {
        val path = analysed("short", "untilOrbits=1")
        val input = AnalysisInput.ofRun(path)
        val part = WalkPart(Study(input, 0.0, listOf(input.size - 1), AnalysisOptions(), path))
        val orbit = 2 * PI / input.omega!!
        fun rows(change: (Int) -> Double): List<NumberRow> {
            var x = 0.0
            val time = DoubleArray(41) { 2 * orbit * it }
            val walk = DoubleArray(41) { x.also { _ -> x += change(it) } }
            return part.of(RandomWalk.settled(listOf(time), listOf(walk), 2 * orbit))
        }
        val random = SeededRandom(3)
        val free = rows { random.nextGaussian() }
        assertEquals(listOf("moonlet_drift", "moonlet_diffusion", "moonlet_walk"), free.map { it.key })
        assertTrue(free.all { it.value.isFinite() && it.error > 0 })
        // A push that grows.
        val bound = rows { it.toDouble() }
        assertEquals(listOf("moonlet_drift", "moonlet_diffusion"), bound.map { it.key })
        assertTrue(bound.last().value.isNaN() && "depend on those before (correlation " in bound.last().note)
    }

    @Tag("thorough")
    @Test
    fun `without bodies,csv the report says so, without bodies it is silent, and damage is one line`() {
        val path = analysed("map", "untilOrbits=3", "output.bodiesEvery=0")
        val page = Files.readString(path.resolve("report.html"))
        assertTrue("bodies.csv was not written (output.bodiesEvery)" in page && "rows of bodies.csv" !in page)
        assertFalse("moonlet_drift" in numbers(path))
        val none = analysed("none", "untilOrbits=3", "bodies=[]", "forces=[]")
        assertFalse(">Moonlets</h2>" in Files.readString(none.resolve("report.html")))
        val damaged = home.resolve("damaged")
        Run.start(scenario("untilOrbits=0.5", "output.bodiesEvery=20"), "damaged", damaged).use { it.execute() }
        val file = damaged.resolve("bodies.csv")
        val text = Files.readString(file)
        Files.writeString(file, text.replaceFirst("\n20,", "\n2O,"))
        assertThrows(InputException::class.java) { AnalysisInput.ofRun(damaged) }
        val e = assertThrows(FormatException::class.java) { AnalysisInput.ofRun(damaged, acceptLoss = true) }
        assertTrue("bodies.csv:3: step is '2O'" in e.message.orEmpty()) { e.message }
    }

    private companion object {
        val SMALL = listOf(
            "box.lengths=[150,200,24]",
            "bodies=[{\"radius\":8,\"density\":400,\"position\":[0,0,0]}]",
            "output.seriesEvery=20",
            "output.snapshotEvery=50",
        )
    }
}
