package daphnis.app.trial

import daphnis.core.Repository
import daphnis.core.input.Ingredients
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.math.abs
import kotlin.math.exp

/** A force and a law that no file of the program knows work wherever its own do. */
class TrialIngredientsTest {
    @TempDir
    lateinit var home: Path

    @BeforeEach
    fun library() {
        val services = Files.createDirectories(home.resolve("library/META-INF/services"))
        Files.writeString(services.resolve(Ingredients::class.qualifiedName!!), TrialIngredients::class.qualifiedName!!)
        Files.writeString(home.resolve("blown.json"), scenario("""{"type": "constant", "coefficient": 1}"""))
        Files.writeString(
            home.resolve("sticky.json"),
            scenario("""{"type": "adhesive", "coefficient": 0.9, "threshold": 0.3}"""),
        )
    }

    private fun scenario(law: String) = """{
        "box": {"lengths": [10, 10, 10]},
        "boundary": {"type": "periodic"},
        "particles": {"count": 200, "sizes": {"type": "equal", "radius": 0.4}},
        "velocities": {"type": "gaussian", "sigma": 1, "exact": true},
        "restitution": $law,
        "forces": [{"type": "drag", "rate": 0.1}],
        "timeStep": {"type": "fixed", "dt": 0.1},
        "until": 5,
        "output": {"seriesEvery": 5, "snapshotEvery": 10, "transportEvery": 1}
    }"""

    /** Spheres that fall into a cone, through which the wind blows. */
    private fun funnel() = scenario("""{"type": "adhesive", "coefficient": 0.95, "threshold": 0.01}""")
        .replace("""{"type": "periodic"}""", """{"type": "walls", "surfaces": [$CONE]}""")
        .replace("\"forces\": [", """"forces": [{"type": "uniform-acceleration", "acceleration": [0, 0, -1]}, """)
        .replace(""""count": 200""", """"count": 60""").replace(""""radius": 0.4""", """"radius": 0.25""")

    private class Said(val code: Int, val text: String)

    /** Types [words] where the library is on the class path. */
    private fun typed(vararg words: String): Said {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val path = System.getProperty("java.class.path") + File.pathSeparator + home.resolve("library")
        val options = listOf("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", path)
        val process = ProcessBuilder(listOf(java) + options + "daphnis.app.MainKt" + words)
            .directory(home.toFile()).redirectErrorStream(true).start()
        val text = process.inputStream.use { String(it.readAllBytes()) }
        return Said(process.waitFor(), text)
    }

    private fun done(vararg words: String): String = typed(*words).run {
        assertEquals(0, code) { text }
        text
    }

    private fun digest(run: String): String =
        Regex(""""stateDigest": "(\w+)"""").find(Files.readString(home.resolve("$run/summary.json")))!!.groupValues[1]

    @Test
    fun `a force is described, run by every engine to one digest, analysed and resumed`() {
        val described = done("describe", "blown.json")
        assertTrue("[0] drag 0.1 per unit of time in a wind of" in described) { described }
        for (engine in listOf("serial", "horizon", "thread-pool")) {
            done("run", "blown.json", "--engine", engine, "--out", engine)
        }
        val digest = digest("serial")
        assertEquals(digest, digest("horizon"))
        assertEquals(digest, digest("thread-pool"))
        // Elastic collisions keep the energy, and the drag takes e^−2γt of it.
        val rows = Files.readAllLines(home.resolve("serial/series.csv"))
        val energy = rows[0].split(',').indexOfFirst { it.startsWith("kinetic_energy") }
        fun energyOf(row: String) = row.split(',')[energy].toDouble()
        assertTrue(abs(energyOf(rows.last()) / energyOf(rows[1]) - exp(-1.0)) < 1e-9) { rows.last() }
        done("run", "blown.json", "--until", "3", "--out", "half")
        done("resume", "half", "--until", "5")
        assertEquals(digest, digest("half"))
        val analysed = done("analyze", "serial")
        assertTrue("report" in analysed) { analysed }
    }

    @Test
    fun `a law is described, run, guarded and analysed`() {
        val described = done("describe", "sticky.json")
        assertTrue("adhesive, 0.9 far above 0.3 cm/s, 0 below: " in described) { described }
        // What has no restitution at rest can collapse.
        assertTrue("elastic below" in described) { described }
        for (engine in listOf("serial", "horizon")) done("run", "sticky.json", "--engine", engine, "--out", engine)
        assertEquals(digest("serial"), digest("horizon"))
        done("analyze", "serial")
    }

    @Test
    fun `a wall is described, run by every engine to one digest, and analysed`() {
        Files.writeString(home.resolve("funnel.json"), funnel())
        val described = done("describe", "funnel.json")
        assertTrue("cone of slope 0.9 along (0 0 1)" in described) { described }
        for (engine in listOf("serial", "horizon")) done("run", "funnel.json", "--engine", engine, "--out", engine)
        assertEquals(digest("serial"), digest("horizon"))
        assertTrue("daphnis" in done("analyze", "serial"))
        val flat = typed("describe", "funnel.json", "--set", "boundary.surfaces[0].slope=0")
        assertTrue("boundary.surfaces[0].slope: is 0.0; must be > 0" in flat.text) { flat.text }
    }

    @Test
    fun `wrong values, keys and types are one line that knows the library`() {
        val negative = typed("describe", "blown.json", "--set", "forces[0].rate=-1")
        assertEquals(2, negative.code)
        assertTrue("forces[0].rate: is -1.0; must be at least 0" in negative.text) { negative.text }
        val mistyped = typed("describe", "blown.json", "--set", "forces[0].wnid=[1,0,0]")
        assertTrue("did you mean 'wind'?" in mistyped.text) { mistyped.text }
        val unknown = typed("describe", "blown.json", "--set", "forces[0].type=darg")
        assertTrue("did you mean 'drag'?" in unknown.text) { unknown.text }
        val schema = done("scenarios", "--schema")
        for (name in listOf("\"drag\"", "\"adhesive\"")) assertTrue(name in schema) { name }
    }

    @Tag("thorough")
    @Test
    fun `several nodes run a force, a law and a wall as one process does`() {
        Files.writeString(home.resolve("funnel.json"), funnel())
        done("run", "funnel.json", "--engine", "serial", "--out", "one")
        done("run", "funnel.json", "--nodes", "2", "--out", "two")
        assertEquals(digest("one"), digest("two"))
    }

    @Test
    fun `a library that cannot be used is one line`() {
        val services = home.resolve("library/META-INF/services/${Ingredients::class.qualifiedName}")
        for ((name, why) in listOf(
            "nobody.Knows" to "nobody.Knows not found",
            TwiceDrag::class.qualifiedName to "'drag'",
        )) {
            Files.writeString(services, "$name\n${TrialIngredients::class.qualifiedName}")
            val said = typed("describe", "blown.json")
            assertEquals(2, said.code) { said.text }
            assertEquals(1, said.text.trim().lines().size) { said.text }
            assertTrue(why in said.text) { said.text }
        }
    }

    /** The files and lists that it names are there; its code is an example here. */
    @Test
    fun `the page on adding says what is so`() {
        val page = Files.readString(Repository.root.resolve("docs/internals/adding.md"))
        val names = Regex("`(\\w+\\.kt)`").findAll(page).map { it.groupValues[1] }.toSet()
        assertTrue(names.size > 10) { "$names" }
        val files = listOf("core", "analysis/plots").flatMap { module ->
            Files.walk(Repository.root.resolve("$module/src/main")).use { all -> all.map { it.name }.toList() }
        }
        assertEquals(emptySet<String>(), names - files.toSet())
        val kinds = Regex("`(\\w+Kinds)`").findAll(page).map { it.groupValues[1] }.toSet()
        assertEquals(setOf("ForceKinds", "RestitutionKinds", "WallSurfaceKinds"), kinds)
    }

    private companion object {
        const val CONE = """{"type": "cone", "apex": [0, 0, -5], "axis": [0, 0, 1], "slope": 0.9}"""
    }
}
