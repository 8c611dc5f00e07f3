package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.occultation.Footprint
import daphnis.analysis.occultation.ObservedDepths
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class OccultationPartsTest {
    @TempDir
    lateinit var directory: Path

    private fun run(name: String, vararg settings: String): Path {
        val path = directory.resolve(name)
        val all = listOf("untilOrbits=2", "box.lengths=[40,40,20]", "output.snapshotEvery=20") + settings
        Run.start(BuiltIn.scenario("ring-patch", all), name, path).use { it.execute() }
        return path
    }

    private fun table(path: Path, name: String): Map<String, List<String>> {
        val rows = Files.readAllLines(path.resolve("tables/$name.csv")).map { it.split(',') }
        return rows[0].withIndex().associate { (k, head) -> head to rows.drop(1).map { it[k] } }
    }

    @Test
    fun `a grid, scans and observed depths are on the page and in tables, and what was there stays as it was`() {
        val path = run("ring")
        val plain = directory.resolve("plain")
        Files.createDirectories(plain)
        val input = AnalysisInput.ofRun(path)
        Analysis(input, AnalysisOptions(from = 0.0)).write(plain)
        val seen = Files.writeString(
            directory.resolve("seen.csv"),
            "elevation,azimuth,transmission,error\n28,0,0.3,0.05\n90,0,1.6,0.4\n",
        )
        val options = OccultationOptions(
            doubleArrayOf(60.0, 20.0),
            4,
            Footprint.rectangle(5.0, 4.0),
            90.0,
            200.0,
            ObservedDepths.read(seen),
        )
        Analysis(input, AnalysisOptions(from = 0.0, occultation = options)).write(path)

        val before = Files.readString(plain.resolve("report.html"))
        val html = Files.readString(path.resolve("report.html"))
        fun row(page: String, name: String) = Regex("<td>$name.*?</tr>").find(page)?.value
        for (name in listOf("rays that come through", "normal optical depth", "geometric optical depth")) {
            assertEquals(row(before, name)!!, row(html, name)) { name }
        }
        assertEquals(
            Files.readString(plain.resolve("tables/occultation.csv")),
            Files.readString(path.resolve("tables/occultation.csv")),
        )
        assertFalse(Files.exists(plain.resolve("tables/occultation-grid.csv")))
        for (plot in listOf("grid", "scan", "autocorrelation", "observed")) {
            assertTrue(Files.size(path.resolve("plots/occultation-$plot.png")) > 1000) { plot }
        }

        val svg = Files.readString(path.resolve("plots/occultation-observed.svg"))
        assertTrue(">28, 0<" in svg && ">90, 0<" in svg)
        // Spheres a radius of 1 m behind footprints of 5 m: nothing is remembered from one to the next.
        assertTrue("shorter than a footprint" in html && "whose footprint is 5 m × 4 m." in html)
        assertEquals("", table(path, "occultation-scan-moments").getValue("autocorrelation_length [m]").single())

        val grid = table(path, "occultation-grid")
        assertEquals(
            listOf("20.0", "20.0", "20.0", "20.0", "60.0", "60.0", "60.0", "60.0"),
            grid["elevation [degrees]"],
        )
        assertEquals(listOf("0.0", "45.0", "90.0", "135.0"), grid["azimuth [degrees]"]!!.take(4))
        val light = grid.getValue("transmission").map { it.toDouble() }
        assertTrue(light.take(4).max() < light.drop(4).min()) { "$light" }
        // The observed table asks for one of the rays that the section has anyway.
        val compared = table(path, "occultation-observed")
        val one = table(path, "occultation").getValue("transmission_mean").map { it.toDouble() }.average()
        assertEquals(one, compared.getValue("patch")[0].toDouble(), 0.01)
        assertEquals(0.3 - compared.getValue("patch")[0].toDouble(), compared.getValue("residual")[0].toDouble(), 1e-12)
        assertTrue("χ² against the observed transmissions" in html && "2 expected, ± 2" in html)
        assertTrue("Line 3 of the file has the transmission 1.6" in html)

        val scan = table(path, "occultation-scan")
        // Along the orbit the patch has room for eight footprints, and for ten tracks beside.
        assertEquals(80, scan.getValue("track").size)
        assertTrue(
            scan.getValue("transmission").all {
                (it.toDouble() * 200) % 1.0 < 1e-9 ||
                    (it.toDouble() * 200) % 1.0 > 1 - 1e-9
            },
        )
        val moments = table(path, "occultation-scan-moments").mapValues { it.value.single().toDoubleOrNull() }
        val noise = moments["mean"]!! / 200
        assertEquals(moments["variance"]!! - noise, moments["excess_variance"]!!, 1e-12)
        assertEquals(one, moments["mean"]!!, 0.01)
        // Spheres that do not overlap, beside each other in a dense ring, are more even than random ones.
        assertTrue(moments["excess_variance"]!! in 0.1 * moments["random_variance"]!!..moments["random_variance"]!!) {
            "$moments"
        }
    }

    @Test
    fun `footprints that do not fit and numbers out of range are refused in one line`() {
        val path = run("small")
        val input = AnalysisInput.ofRun(path)
        fun of(options: OccultationOptions) =
            Analysis(input, AnalysisOptions(from = 0.0, occultation = options)).write(path)
        fun refused(words: String, act: () -> Unit) {
            val e = assertThrows(InputException::class.java, act)
            assertTrue(e.message!!.startsWith(words)) { e.message }
        }
        refused("footprint: is a disc of diameter 41 m: it must fit into the patch, which has room for 40.0 along") {
            of(OccultationOptions(footprint = Footprint.disc(41.0)))
        }
        assertFalse(Files.exists(path.resolve("report.html")))
        refused("elevations: is 0.0; it must be in 0.1..90 degrees") { OccultationOptions(doubleArrayOf(30.0, 0.0)) }
        refused("elevations: is 91.0") { OccultationOptions(doubleArrayOf(91.0)) }
        refused("azimuths: is 0; it must be in 1..180") { OccultationOptions(azimuths = 0) }
        refused("scanPath: is NaN; it must be in -360..360 degrees") { OccultationOptions(scanPath = Double.NaN) }
        refused("photons: is -1.0; it must be in (0,") { OccultationOptions(photons = -1.0) }
    }

    @Tag("thorough")
    @Test
    fun `where nothing comes through along any line there is nothing to compare`() {
        val path = run("opaque")
        val seen = directory.resolve("low.csv")
        Files.writeString(seen, "elevation,azimuth,optical_depth,error\n1,30,0.5,0.1\n")
        val options = OccultationOptions(observed = ObservedDepths.read(seen))
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 0.0, occultation = options)).write(path)
        val html = Files.readString(path.resolve("report.html"))
        assertTrue("there is nothing to compare" in html && "χ² against" !in html)
        val compared = table(path, "occultation-observed")
        // The way to radians and back would give 29.999999999999996.
        assertEquals("30.0", compared.getValue("azimuth [degrees]").single())
    }

    @Tag("thorough")
    @Test
    fun `a patch that ends along x has scans along its axes only`() {
        val path = run("ringlet", "boundary.radiallyOpen=true")
        val input = AnalysisInput.ofRun(path)
        fun of(degrees: Double) = AnalysisOptions(
            from = 0.0,
            occultation = OccultationOptions(footprint = Footprint.disc(4.0), scanPath = degrees),
        )
        Analysis(input, of(90.0)).write(path)
        val e = assertThrows(InputException::class.java) { Analysis(input, of(30.0)).write(path) }
        assertTrue("the path leaves the patch, which does not repeat along x" in e.message!!) { e.message }
    }
}
