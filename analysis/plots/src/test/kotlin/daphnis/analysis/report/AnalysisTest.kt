package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.requireReplacedWhole
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.CartAndRad
import daphnis.core.format.ExtendedXyz
import daphnis.core.format.FormatException
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.initial.SizesSpec
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.Surroundings
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.name

@Tag("jdk-neutral")
class AnalysisTest {
    @TempDir
    lateinit var directory: Path

    private fun run(name: String, vararg settings: String): Path {
        val path = directory.resolve(name)
        Run.start(BuiltIn.scenario(name, settings.asList()), name, path).use { it.execute() }
        return path
    }

    @Test
    fun `a ring patch gives tables, plots and one page with everything inside`() {
        val path = run("ring-patch", "untilOrbits=2", "box.lengths=[60,60,20]", "output.snapshotEvery=50")
        val seen = ArrayList<Int>()
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(elevation = 35.0, azimuth = 15.0)).write(path) {
                done,
                all,
                _,
            ->
            seen +=
                100 * done / all
        }
        assertEquals(100, seen.last())
        assertEquals(seen.sorted(), seen)
        val html = Files.readString(path.resolve("report.html"))
        val headings =
            "Numbers;The patch;Streamlines;Evolution;Profiles;Velocity ellipsoid;Structure;Occultation;Impacts;Run"
        for (heading in headings.split(';')) {
            assertTrue(">$heading</h2>" in html) { heading }
        }
        assertTrue("35° elevation and 15° azimuth" in html && "Pair correlation in the x-y plane" in html)
        // Without gravity there are no wakes to look for.
        assertTrue("pitch angle" !in html && "spacing of wakes" !in html)
        // Nothing from outside: every picture is data, no script, no link but those within the page.
        assertFalse(Regex("""(src|href)="(?!data:|#)""").containsMatchIn(html))
        assertFalse("<script" in html)
        val tables = Files.list(path.resolve("tables")).use { files -> files.map { it.name }.toList().toSet() }
        val wanted =
            "numbers streamlines-x streamlines-guiding-centre profile-radial profile-vertical evolution " +
                "pair-correlation structure-factor autocorrelation wakes occultation impact-speeds"
        for (name in wanted.split(' ')) {
            assertTrue("$name.csv" in tables) { name }
        }
        assertTrue(
            Files.readAllLines(
                path.resolve("tables/profile-radial.csv"),
            )[0].startsWith("centre [m],count,count_error,surface_density [kg/m^2]"),
        )
        assertEquals(NumberKeys.RING, NumberKeys.of(path))
        val known = ReferenceTest.patch().keys
        assertEquals(9, known.size)
        assertTrue(NumberKeys.RING.containsAll(known)) { "$known" }
        for (plot in listOf("temperature", "collision-rate", "energy", "dispersion")) {
            val image = ImageIO.read(path.resolve("plots/$plot.png").toFile())
            assertEquals(255, image.getRGB(image.width - 2, image.height / 2) ushr 24) { "$plot is filled to its edge" }
        }
        for (plot in listOf("patch-above", "patch-side", "streamlines", "velocity-ellipsoid")) {
            assertTrue(Files.size(path.resolve("plots/$plot.png")) > 1000)
            assertTrue(Files.readString(path.resolve("plots/$plot.svg")).startsWith("<svg"))
        }
    }

    @Test
    fun `a gas that cools is not told to run longer, and all that decides its physics is in the table of the run`() {
        val path = run("cooling-gas", "until=30", "particles.count=300", "output.snapshotEvery=100")
        Analysis(AnalysisInput.ofRun(path)).write(path)
        val html = Files.readString(path.resolve("report.html"))
        assertTrue("Not steady: granular temperature fell" in html && "a longer run is not steady either" in html)
        assertTrue("<sup>!</sup>" in html && "<sup>?</sup>" !in html) { "one mark for what is not steady" }
        assertTrue("its axes are no more unequal than chance makes them" in html && "is turned by" !in html)
        for (row in listOf(
            "boundary" to "periodic",
            "restitution" to "constant, coefficient 0.9",
            "forces" to "none",
            "timeStep" to "fixed, dt 0.1",
            "velocities" to "gaussian, sigma 1.0",
            "units" to "none",
        )) {
            assertTrue("<th scope=\"row\">${row.first}</th><td>${row.second}" in html) { "$row" }
        }
        assertTrue("<th scope=\"row\">particles</th><td>count 300, sizes (equal, radius 0.5), mass 1.0</td>" in html)
        assertTrue("<th scope=\"row\">guard</th><td>floor-speed, speed 1.7" in html)
        assertFalse("unless the run was resumed" in html)
    }

    @Test
    fun `the commands that do a run with chosen steps again have a condition`() {
        val path = directory.resolve("chosen")
        val settings = listOf("timeStep={\"type\":\"automatic\"}", "until=1", "particles.count=50")
        Run.start(BuiltIn.scenario("cooling-gas", settings), "gas", path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path)).write(path)
        val html = Files.readString(path.resolve("report.html"))
        assertTrue("number of threads, unless the run was resumed to another end than it had at first." in html)
    }

    @Test
    fun `the keys of all numbers are declared`() = NumberKeys.assertDeclared()

    @Test
    fun `a patch with self-gravity has the numbers of gravity`() {
        val path = run("self-gravity-wakes", "untilOrbits=0.05", "box.lengths=[60,60,20]", "output.transportEvery=5")
        Analysis(AnalysisInput.ofRun(path)).write(path)
        assertEquals(NumberKeys.RING.toSet() + NumberKeys.SELF_GRAVITY, NumberKeys.of(path).toSet())
    }

    @Test
    fun `a patch with self-gravity shows Q and viscosity over time, beside what they are held against`() {
        val steps = listOf("timeStep.steps=100", "untilOrbits=2", "box.lengths=[40,40,20]", "output.transportEvery=5")
        val path = run("self-gravity-wakes", *steps.toTypedArray())
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 0.0)).write(path)
        fun column(table: String, k: Int) = Files.readAllLines(path.resolve("tables/$table.csv")).drop(1)
            .map { it.split(',')[k].toDouble() }

        fun number(key: String) = Files.readAllLines(path.resolve("tables/numbers.csv")).map { it.split(',') }
            .single { it[0] == key }[1].toDouble()
        val q = column("toomre-q", 1)
        assertEquals(41, q.size)
        assertEquals(number("toomre_q"), Math.sqrt(q.zipWithNext { a, b -> (a * a + b * b) / 2 }.average()), 0.02)
        assertEquals(listOf(0.5, 1.5), column("viscosity-by-orbit", 0).map { Math.rint(it * 1e6) / 1e6 })
        val mean = column("viscosity-by-orbit", 1).average()
        assertEquals(number("viscosity_total"), mean, 1e-6 * mean)
        // No mark of averages, which begin with the run: the dashed line is that at Q = 1.
        for (plot in listOf("toomre-q", "viscosity")) {
            assertTrue("stroke-dasharray" in Files.readString(path.resolve("plots/$plot.svg"))) { plot }
        }
        val page = Files.readString(path.resolve("report.html"))
        assertTrue(
            "The upright line is Toomre&#39;s critical" in page || "The upright line is Toomre's critical" in page,
        )
    }

    @Tag("thorough")
    @Test
    fun `errors of a run whose sizes are drawn are said to be for its own radii`() {
        val said = "± is one standard error; numbers without it and without a mark follow from the particles " +
            "and the box themselves, or are conserved. It is for the radii of this run: another seed draws others"
        val drawn = "{\"type\":\"power-law\",\"minimum\":0.3,\"maximum\":0.6,\"exponent\":3}"
        for ((sizes, isSaid) in listOf(drawn to true, "{\"type\":\"list\",\"radii\":[0.3,0.6]}" to false)) {
            val box = listOf("particles.sizes=$sizes", "particles.count=100", "box.lengths=[9,9,9]")
            val gas = run("elastic-gas", *box.toTypedArray(), "until=30", "output.transportEvery=4")
            Analysis(AnalysisInput.ofRun(gas)).write(gas)
            assertEquals(isSaid, said in Files.readString(gas.resolve("report.html"))) { sizes }
            directory.resolve("elastic-gas").toFile().deleteRecursively()
        }
    }

    @Test
    fun `a sheared box has its mean flow, an open gas what an open gas has`() {
        val sheared = run("shear-cell", "until=1", "output.snapshotEvery=10", "output.transportEvery=2")
        Analysis(AnalysisInput.ofRun(sheared)).write(sheared)
        val html = Files.readString(sheared.resolve("report.html"))
        assertTrue(">Mean flow</h2>" in html)
        // Filled all around: no light through it, no wakes, and g(r) in space from contact on.
        assertFalse(">Occultation</h2>" in html || "Wakes" in html || "wakes" in html)
        assertTrue("Radial distribution function in space" in html && "2147483647" !in html)
        val pairs = Files.readAllLines(sheared.resolve("tables/pair-correlation.csv")).drop(1).map { row ->
            row.split(',').take(2).map { it.toDouble() }
        }
        val half = (pairs[1][0] - pairs[0][0]) / 2
        assertEquals(
            2 * BuiltIn.scenario("shear-cell", emptyList()).particles!!.sizes.let { (it as SizesSpec.Equal).radius },
            pairs[0][0] - half,
            1e-9,
        )
        assertTrue(pairs[0][1] > 1.5) { "g at contact is ${pairs[0][1]}" }
        assertEquals(NumberKeys.SHEARED, NumberKeys.of(sheared))
        val known = ReferenceTest.sheared().keys
        assertTrue(known.size == 3 && NumberKeys.SHEARED.containsAll(known)) { "$known" }
        val gas = ReferenceTest.elastic().keys
        assertTrue(gas.size == 5 && (NumberKeys.GAS + NumberKeys.HELFAND).containsAll(gas)) { "$gas" }
        val open = run("cooling-gas", "until=0.2", "boundary={\"type\":\"open\"}", "particles.count=200")
        Analysis(AnalysisInput.ofRun(open)).write(open)
        assertTrue("granular_temperature" in NumberKeys.of(open))
    }

    @Test
    fun `a gas that cools is said not to be steady, and marked so though its states are too few for an error`() {
        val cooling = run("cooling-gas", "until=20", "output.snapshotEvery=1000", "particles.count=300")
        Analysis(AnalysisInput.ofRun(cooling)).write(cooling)
        val html = Files.readString(cooling.resolve("report.html"))
        assertTrue("Not steady: granular temperature fell by" in html) {
            Regex("(?s)<h2 id=\"numbers.{0,1500}").find(html)?.value.orEmpty()
        }
        assertTrue("<sup>!</sup>" in html && "<sup>?</sup>" !in html)
        val row = Files.readAllLines(cooling.resolve("tables/numbers.csv")).first {
            it.startsWith("granular_temperature,")
        }
        assertEquals("not steady", row.split(',')[5]) { row }
    }

    @Tag("thorough")
    @Test
    fun `a gas that cools has no error though its rows are many, and the table says why`() {
        val cooling = run("cooling-gas", "until=20", "particles.count=300", "output.transportEvery=1")
        Analysis(AnalysisInput.ofRun(cooling), AnalysisOptions(from = 10.0)).write(cooling)
        val rows = Files.readAllLines(cooling.resolve("tables/numbers.csv")).drop(1).map { it.split(',') }
        // The collisions of a row scatter so much that they would have an error; a falling temperature has none anyway.
        assertEquals("not steady", rows.single { it[0] == "compressibility" }[5]) { "$rows" }
        assertTrue(rows.all { it[2].isEmpty() } && rows.single { it[0] == "mean_radius" }[5].isEmpty()) { "$rows" }
        val html = Files.readString(cooling.resolve("report.html"))
        assertTrue("<sup>!</sup> No error is given: the run is not steady" in html)
    }

    @Test
    fun `a patch of a thousand times its width has no scan across it`() {
        val path = run("ring-patch", "box.lengths=[20,20000,20]", "particles.opticalDepth=0.02", "untilOrbits=0.02")
        Analysis(AnalysisInput.ofRun(path)).write(path)
        assertTrue("No scan along x" in Files.readString(path.resolve("report.html")))
        assertFalse(Files.exists(path.resolve("plots/occultation.svg")))
    }

    @Tag("thorough")
    @Test
    fun `a patch that is not steady has no error anywhere, neither in tables nor on the page`() {
        val particles = "{\"count\":150,\"sizes\":{\"type\":\"list\",\"radii\":[1,2]},\"density\":900}"
        val settings =
            arrayOf("particles=$particles", "box.lengths=[40,40,40]", "velocities.sigma=2e-3", "untilOrbits=3")
        val path = run("ring-patch", *settings, "output.snapshotEvery=20", "output.transportEvery=10")
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 0.0)).write(path)
        val html = Files.readString(path.resolve("report.html"))
        assertTrue("Not steady: " in html && "There are no bars, since the run is not steady" in html)
        val errors = Regex(".{0,60}(±|Bars are).{0,60}").findAll(html.replace("no ± is given", "")).map { it.value }
        assertEquals(emptyList<String>(), errors.toList())
        val occultation = html.substringAfter(">Occultation</h2>").substringBefore("<h2")
        assertEquals(2, Regex("</sup></td>").findAll(occultation).count()) { "marks of two averages" }
        val tables = listOf("profile-radial", "pair-correlation", "size-classes", "mean-square-displacement", "wakes")
        for (name in tables) {
            val rows = Files.readAllLines(path.resolve("tables/$name.csv")).map { it.split(',') }
            for ((k, head) in rows[0].withIndex()) {
                if ("_error" in head) assertTrue(rows.drop(1).all { it[k].isEmpty() }) { "$name: $head" }
            }
        }
        // In the unit of all other dispersions of a ring.
        val sizes = Files.readString(path.resolve("plots/size-dispersion.svg"))
        assertTrue("velocity dispersion [r Ω]" in sizes) { sizes.takeLast(3000) }
    }

    @Tag("thorough")
    @Test
    fun `a clump that flies apart in open space is analysed, though its box grows`() {
        val clump =
            run(
                "cooling-gas",
                "until=2",
                "boundary={\"type\":\"open\"}",
                "particles.count=100",
                "box.lengths=[8,8,8]",
                "output.snapshotEvery=2",
            )
        Analysis(AnalysisInput.ofRun(clump), AnalysisOptions(from = 0.0)).write(clump)
        assertTrue(">Structure</h2>" in Files.readString(clump.resolve("report.html")))
        // And one that shrinks: the last state has the smallest box.
        val states =
            H5md.read(clump.resolve("snapshots/0000000020.h5")) + H5md.read(clump.resolve("snapshots/0000000000.h5"))
        fun inOrder(list: List<Snapshot>) = list.mapIndexed { k, f ->
            Snapshot(
                k.toLong(), k.toDouble(), f.lengths, f.periodic, 0.0, f.id, f.position, f.velocity, f.radius, f.mass,
            )
        }
        for ((name, list) in listOf("shrinks" to inOrder(states), "grows" to inOrder(states.reversed()))) {
            val file = directory.resolve("$name.h5")
            H5md.write(list, file, "test")
            val out = directory.resolve(name)
            Files.createDirectories(out)
            Analysis(AnalysisInput.ofFile(file, null, ""), AnalysisOptions(from = -1.0)).write(out)
        }
    }

    @Test
    fun `steadiness is told from the series where transport has few rows`() {
        val cooling =
            run("cooling-gas", "until=10", "particles.count=300", "output.transportEvery=25", "output.snapshotEvery=20")
        Analysis(AnalysisInput.ofRun(cooling)).write(cooling)
        assertTrue("Not steady: granular temperature fell by" in Files.readString(cooling.resolve("report.html")))
    }

    @Test
    fun `a patch that lets no light through is opaque, one that does in some states has a finite depth`() {
        fun rows(opaque: Int): String {
            val scenario = BuiltIn.scenario("ring-patch", listOf("box.lengths=[4,4,2]", "forces=[]"))
            val boundary = Surroundings.of(scenario, "ring-patch").boundary
            val states = List(3) { k ->
                val p = uniform(60, boundary, radius = 1.0).population
                // All in one place.
                if (k >= opaque) for (axis in listOf(p.x, p.y, p.z)) axis.fill(0.0)
                Snapshot.of(p, boundary, k.toLong(), k.toDouble())
            }
            val file = directory.resolve("light.h5")
            H5md.write(states, file, "test")
            Analysis(AnalysisInput.ofFile(file, scenario, "ring-patch"), AnalysisOptions(from = -1.0)).write(directory)
            val html = Files.readString(directory.resolve("report.html"))
            assertFalse("2147483647" in html || "Infinity" in html || "∞" in html)
            return html
        }
        assertTrue("opaque: no ray comes through" in rows(3))
        assertFalse("opaque: no ray" in rows(2))
    }

    @Tag("thorough")
    @Test
    fun `the report shows the time series of a run that wrote no transport, and where averages begin`() {
        val path =
            run(
                "cooling-gas",
                "until=4",
                "particles.count=200",
                "box.lengths=[10,10,10]",
                "output.snapshotEvery=10",
                "output.transportEvery=0",
            )
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 2.0)).write(path)
        val html = Files.readString(path.resolve("report.html"))
        assertTrue(">Evolution</h2>" in html)
        assertTrue("the dashed line is where averages begin, time 2 units of time." in html)
        assertTrue("Averages over 3 states of 5, time 2 to 4 units of time." in html)
        for (plot in listOf("temperature", "collision-rate", "energy")) {
            assertTrue(Files.size(path.resolve("plots/$plot.png")) > 1000) { plot }
        }
        assertTrue("time [units of time]" in Files.readString(path.resolve("plots/energy.svg")))
        val columns = Files.readAllLines(path.resolve("tables/time-series.csv"))[0].split(',')
        assertEquals(listOf("time [units of time]", "granular_temperature [units of length^2/time^2]"), columns.take(2))
        assertEquals("kinetic [units of mass length^2/time^2]", columns[2])
        assertFalse(Files.exists(path.resolve("plots/dispersion.png")))
        // Dashed, and at 2 of 4: the line upright is in the drawing only when averages begin within the run.
        val marked = Files.readString(path.resolve("plots/collision-rate.svg"))
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = -1.0)).write(path)
        assertTrue("averages are over all of it." in Files.readString(path.resolve("report.html")))
        val unmarked = Files.readString(path.resolve("plots/collision-rate.svg"))
        assertTrue("stroke-dasharray" in marked && "stroke-dasharray" !in unmarked)
        // Half a line at the end.
        fun read(acceptLoss: Boolean) = AnalysisInput.ofRun(path, acceptLoss)
        val series = Files.readString(path.resolve("series.csv"))
        Files.writeString(path.resolve("series.csv"), series.dropLast(series.length / 3))
        val refused = assertThrows(InputException::class.java) { read(false) }
        assertTrue("series.csv" in refused.message!! && refused.wayOut == WayOut.ANALYSE_WITH_LOSS) { refused.message }
        assertTrue(read(true).series!!.size in 20..35)
        assertTrue("series.csv" in read(true).notices.single())
        Files.writeString(path.resolve("series.csv"), series.replaceFirst("200", "many"))
        assertTrue("series.csv:2" in assertThrows(FormatException::class.java) { read(true) }.message!!)
    }

    @Test
    fun `averages that begin after the last state are refused in one line`() {
        val path = run("cooling-gas", "until=1", "particles.count=50", "box.lengths=[8,8,8]", "output.snapshotEvery=5")
        val input = AnalysisInput.ofRun(path)
        val message = assertThrows(InputException::class.java) {
            Analysis(input, AnalysisOptions(from = 1.5))
        }.message!!
        for (part in listOf("from: is 1.5", "last state is at time 1,", "at most")) {
            assertTrue(part in message) {
                message
            }
        }
        assertFalse('\n' in message)
        Analysis(input, AnalysisOptions(from = 1.0)).write(path)
        assertTrue("Averages over 1 state of 3, time 1 unit of time." in Files.readString(path.resolve("report.html")))
        Analysis(input, AnalysisOptions(from = -100.0))
    }

    @Test
    fun `a single particle gives its picture and a line for each section that would mean nothing`() {
        val file = Files.writeString(directory.resolve("one.csv"), "x,y,z,vx,vy,vz,radius\n0,0,0,1,0,0,1\n")
        val out = directory.resolve("out")
        Files.createDirectories(out)
        Analysis(AnalysisInput.ofFile(file, null, "")).write(out)
        val html = Files.readString(out.resolve("report.html"))
        assertTrue("1 sphere." in html && "1 spheres" !in html)
        assertTrue(">The box</h2>" in html)
        for (heading in listOf("Profiles", "Velocity ellipsoid", "Structure", "Occultation")) {
            assertFalse(">$heading</h2>" in html) { heading }
            assertTrue("<li>$heading: there is 1 particle; it takes 10 at least.</li>" in html) { heading }
        }
        assertTrue("<li>Evolution: a file of states has no time series.</li>" in html)
        val plots = Files.list(out.resolve("plots")).use { files -> files.map { it.name }.sorted().toList() }
        assertEquals(listOf("patch-above.png", "patch-above.svg", "patch-side.png", "patch-side.svg"), plots)
        assertTrue(">0.2 units of length</text>" in Files.readString(out.resolve("plots/patch-above.svg")))
    }

    @Test
    fun `a report has one notation for powers of ten and commands that can be pasted`() {
        val path = run("ring-patch", "untilOrbits=1", "box.lengths=[40,40,20]", "output.snapshotEvery=100")
        Analysis(AnalysisInput.ofRun(path)).write(path)
        val html = Files.readString(path.resolve("report.html")).replace(Regex("base64,[^\"]*"), "")
        assertEquals(
            null,
            Regex("""\d[eE][-+−]?\d""").find(html.substringAfter("<main>").substringBefore("state digest"))?.value,
        )
        assertTrue("· 10⁻" in html)
        assertTrue("daphnis compare $path $path-again" in html && "./daphnis" !in html) { html.takeLast(1500) }
        assertTrue("time [orbits]" in Files.readString(path.resolve("plots/temperature.svg")))
        assertTrue("<td>hill-sheet, radiallyOpen false</td>" in html)
    }

    @Test
    fun `foreign files give the states they hold`() {
        val path = run("elastic-gas", "until=0.2", "particles.count=300", "output.snapshotEvery=1")
        val original = AnalysisInput.ofRun(path).state(0).population
        val state = Snapshot.of(original, Periodic(Box.centred(40.0, 40.0, 40.0)), 0, 0.5)
        val xyz = directory.resolve("a.xyz")
        Files.newBufferedWriter(xyz).use {
            ExtendedXyz.write(state, it)
            ExtendedXyz.write(state.at(1.5), it)
        }
        val h5 = directory.resolve("a.h5")
        H5md.write(listOf(state), h5, "test")
        val bin = directory.resolve("a.bin")
        CartAndRad.write(original, bin)
        for ((file, count) in listOf(xyz to 2, h5 to 1, bin to 1)) {
            val input = AnalysisInput.ofFile(file, null, "")
            assertEquals(count, input.size)
            val p = input.state(count - 1).population
            assertArrayEquals(state.position[0], p.x, 1e-12) { file.toString() }
            assertArrayEquals(state.velocity[2], p.vz, 1e-12)
            assertArrayEquals(state.radius, p.radius, 1e-12)
        }
        val out = directory.resolve("out")
        Files.createDirectories(out)
        requireReplacedWhole(out, files = 10) { Analysis(AnalysisInput.ofFile(bin, null, "")).write(out) }
        assertTrue(Files.size(out.resolve("report.html")) > 10_000)
    }

    @Test
    fun `that the last line of a text has no end is a notice`() {
        val whole = "x,y,z,vx,vy,vz,radius\n0,0,0,1,2,3,0.5\n3,0,0,3,2,1,0.25\n"
        val file = Files.writeString(directory.resolve("a.csv"), whole)
        assertEquals(emptyList<String>(), AnalysisInput.ofFile(file, null, "").notices)
        Files.writeString(file, whole.dropLast(2))
        val notice = AnalysisInput.ofFile(file, null, "").notices.single()
        assertTrue("$file: the last line has no end" in notice) { notice }
    }

    @Test
    fun `what is wrong with a file is one line that names it`() {
        fun wrong(name: String, text: String, vararg words: String) {
            val file = directory.resolve(name)
            Files.writeString(file, text)
            val message = assertThrows(FormatException::class.java) { AnalysisInput.ofFile(file, null, "") }.message!!
            for (word in words.asList() + name) assertTrue(word in message) { message }
            assertFalse('\n' in message)
        }
        val head = "Properties=species:S:1:pos:R:3:radius:R:1\n"
        wrong("nan.xyz", "1\n${head}X 0 0 NaN 1\n", ":3:", "'NaN'")
        wrong("cut.xyz", "2\n${head}X 0 0 0 1\n", "cut short", "2 particles")
        wrong("count.xyz", "two\n$head", "'two'")
        wrong("radius.xyz", "1\n${head}X 0 0 0 -1\n", "> 0")
        wrong("columns.xyz", "1\n${head}X 0 0 0\n", "4 values", "5")
        wrong("empty.xyz", "", "no frame")
        wrong("none.xyz", "0\n$head", "no particle")
        wrong("cut.bin", "abc", "CartAndRad")
        wrong("cut.h5", "abc", "HDF5")
        wrong("what.vtp", "abc", "unknown format")
        wrong("nan.csv", "x,y,z,radius\n0,0,NaN,1\n", ":2:", "finite")
        assertThrows(InputException::class.java) { AnalysisInput.ofFile(directory.resolve("nowhere.xyz"), null, "") }
        assertThrows(InputException::class.java) { AnalysisInput.ofRun(directory.resolve("nowhere")) }
        assertThrows(InputException::class.java) { AnalysisInput.ofRun(directory) }
    }
}
