package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.format.ExportOptions
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos

/** What reports say of files of other programs. */
@Tag("jdk-neutral")
class ForeignReportTest {
    @TempDir
    lateinit var home: Path

    private fun numbers(input: AnalysisInput) =
        Analysis(input, AnalysisOptions(from = 0.0)).numbers().associate { it.key to it.value }

    @Test
    fun `a sheared gas has the temperature of its scenario without it, in every format that has a box`() {
        val settings = listOf("particles.count=500", "box.lengths=[9.55,9.55,9.55]", "timeStep.dt=0.05", "until=6")
        // With every 20 steps the box is upright in each state.
        for (every in listOf(20, 7)) {
            val scenario = BuiltIn.scenario("shear-cell", settings + "output.snapshotEvery=$every")
            val path = home.resolve("run$every")
            Run.start(scenario, "shear-cell", path).use { it.execute() }
            val run = RunDirectory(path)
            val states = run.snapshotSteps().map { run.readSnapshot(it) }
            for (word in listOf("xyz", "lammps", "h5md")) {
                val directory = Files.createDirectories(home.resolve("$word$every"))
                val format = SnapshotFormats.named(word)
                val file = format.export(states.asSequence(), directory, ExportOptions("test")).path
                val with = numbers(AnalysisInput.ofFile(file, scenario, "shear-cell"))
                val without = numbers(AnalysisInput.ofFile(file, null, ""))
                val key = "granular_temperature"
                assertEquals(with.getValue(key), without.getValue(key), 1e-9 * with.getValue(key)) { "$word $every" }
                assertTrue(without.getValue(key) < 2) { "$without" }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `an export has the numbers of its run, diffusion too, in every format that has a box`() {
        val gas = listOf("particles.count=100", "box.lengths=[7,7,7]", "until=30", "output.snapshotEvery=5")
        val cell = listOf("particles.count=200", "box.lengths=[7,7,7]", "timeStep.dt=0.05", "until=30")
        val ring =
            listOf("box.lengths=[60,60,60]", "untilOrbits=8", "output.snapshotEvery=20")
        val runs = listOf("elastic-gas" to gas, "shear-cell" to cell + "output.snapshotEvery=17", "ring-patch" to ring)
        for ((name, settings) in runs) {
            val scenario = BuiltIn.scenario(name, settings)
            val path = home.resolve(name)
            Run.start(scenario, name, path).use { it.execute() }
            val run = RunDirectory(path)
            val states = run.snapshotSteps().map { run.readSnapshot(it) }
            assertTrue(states.last().image!!.any { axis -> axis.any { it != 0 } }) { name }
            val there = numbers(AnalysisInput.ofRun(path))
            // With transport.csv a run has averages over more than its snapshots.
            val ofStates = if (Files.exists(run.transport)) emptyList() else listOf("granular_temperature")
            val keys = ofStates + listOf("filling_factor", "self_diffusion", "self_diffusion_x", "self_diffusion_y") +
                "self_diffusion_z" + "guiding_centre_diffusion"
            val diffusion = keys.filter { "diffusion" in it && it in there }
            assertTrue(diffusion.isNotEmpty()) { "$name: $there" }
            for (word in listOf("xyz", "lammps", "h5md")) {
                val directory = Files.createDirectories(home.resolve("$name-$word"))
                val file = SnapshotFormats.named(
                    word,
                ).export(states.asSequence(), directory, ExportOptions("test")).path
                // A ring needs its frame.
                val known = scenario.takeIf { name == "ring-patch" }
                val here = numbers(AnalysisInput.ofFile(file, known, name))
                for (key in keys) {
                    val value = there[key] ?: continue
                    assertEquals(value, here[key] ?: Double.NaN, 1e-6 * Math.abs(value)) { "$name $word $key" }
                }
            }
        }
    }

    private fun page(input: AnalysisInput, name: String): String {
        val directory = Files.createDirectories(home.resolve(name))
        Analysis(input, AnalysisOptions(from = 0.0)).write(directory)
        return Files.readString(directory.resolve("report.html"))
    }

    @Test
    fun `a file without velocities has no numbers of motion, and says so`() {
        val input = AnalysisInput.ofFile(walk(hasTimes = true) { IntArray(200) { k -> k } }, null, "")
        assertEquals(1, input.notices.count { "has no velocities" in it }) { "${input.notices}" }
        val html = page(input, "walk")
        assertTrue("the file has no velocities" in html)
        assertTrue("NaN %" !in html && "granular temperature" !in html)
        assertTrue("granular_temperature" !in Files.readString(home.resolve("walk/tables/numbers.csv")))
    }

    @Test
    fun `faces are named by axis where they differ`() {
        val x = DoubleArray(50) { it * 0.1 }
        val state = Snapshot(
            0L, 0.0, doubleArrayOf(10.0, 10.0, 10.0), booleanArrayOf(true, true, false), 0.0, IntArray(50) { it },
            arrayOf(x, x, x), arrayOf(x, x, x), DoubleArray(50) { 0.01 }, DoubleArray(50) { 1.0 },
        )
        val file = SnapshotFormats.named("xyz").export(sequenceOf(state), home, ExportOptions("test")).path
        assertTrue("periodic along x, y; open along z" in page(AnalysisInput.ofFile(file, null, ""), "slab"))
    }

    @Test
    fun `what a run warned of stands in its report, and energy that does not balance is told from chance`() {
        val settings = listOf("frame.verticalFactor=3.6", "particles.opticalDepth=0.1", "untilOrbits=0.3")
        val path = home.resolve("coarse")
        Run.start(BuiltIn.scenario("ring-patch", settings), "ring-patch", path).use { it.execute() }
        assertTrue("The run warned: " in page(AnalysisInput.ofRun(path), "report"))
        val plain = home.resolve("plain")
        val gas = BuiltIn.scenario("cooling-gas", listOf("particles.count=50", "until=1"))
        Run.start(gas, "cooling-gas", plain).use { it.execute() }
        assertTrue("The run warned: " !in page(AnalysisInput.ofRun(plain), "fine"))
        for ((balance, error, isOff) in listOf(
            Triple(0.958, 0.0019, true),
            Triple(1.02, 0.001, true),
            Triple(0.995, 0.0005, false),
            Triple(1.05, 0.02, false),
            Triple(0.9, Double.NaN, false),
        )) {
            assertEquals(isOff, RunWarnings.isOff(balance, error)) { "$balance ± $error" }
        }
    }

    @Test
    fun `wakes have their pitch and spacing with errors, on the page and where errors are held against seeds`() {
        val hill = "frame={\"type\":\"hill\",\"angularSpeed\":1}"
        val scenario = BuiltIn.scenario("ring-patch", listOf(hill, "box.lengths=[60,72,20]"))
        val file = SnapshotFormats.named("xyz").export(waves().asSequence(), home, ExportOptions("test")).path
        val input = AnalysisInput.ofFile(file, scenario, "waves")
        val rows = Analysis(input, AnalysisOptions(from = 0.0)).rows().associateBy { it.name }
        val pitch = rows.getValue("pitch angle of the wakes")
        val spacing = rows.getValue("radial spacing of the wakes")
        assertEquals(Math.toDegrees(atan2(2 / 72.0, 4 / 60.0)), pitch.value, 4 * pitch.error)
        assertEquals(15.0, spacing.value, 4 * spacing.error)
        assertTrue(pitch.error < 2 && spacing.error < 1) { "${pitch.error} ${spacing.error}" }
        val html = page(input, "waves")
        assertTrue("<td>radial spacing of the wakes</td>" in html && "correlation of their autocorrelations" in html)
        assertTrue("No pitch angle" !in html)
    }

    /** 20 states of 800 particles with the density 1 + 0.7 cos(k·r + some phase), each when images stand upright. */
    private fun waves(): List<Snapshot> {
        val random = Random(3)
        val rest = DoubleArray(800)
        return List(20) { k ->
            val phase = random.nextDouble()
            val at = Array(3) { DoubleArray(800) }
            for (i in 0 until 800) {
                do {
                    at[0][i] = 60 * (random.nextDouble() - 0.5)
                    at[1][i] = 72 * (random.nextDouble() - 0.5)
                    val turns = 4 * at[0][i] / 60 + 2 * at[1][i] / 72 + phase
                } while (random.nextDouble() * 1.7 > 1 + 0.7 * cos(2 * PI * turns))
            }
            Snapshot(
                k.toLong(), 0.8 * k, doubleArrayOf(60.0, 72.0, 20.0), booleanArrayOf(true, true, false), 0.0,
                IntArray(800) { it }, at, arrayOf(rest, rest, rest), DoubleArray(800) { 1.25 },
                DoubleArray(800) { 1.0 },
            )
        }
    }

    /** A walk of 200 particles with D = 1/2, in a box of edge 10 and 60 states, of which [id] names the particles. */
    private fun walk(hasTimes: Boolean, id: (Int) -> IntArray): Path {
        val random = Random(5)
        val at = Array(3) { DoubleArray(200) { random.nextDouble() * 10 - 5 } }
        val none = DoubleArray(200)
        val states = List(60) { k ->
            for (axis in 0..2) for (i in 0 until 200) at[axis][i] += random.nextGaussian()
            Snapshot(
                10L * k, k.toDouble(), doubleArrayOf(10.0, 10.0, 10.0), BooleanArray(3) { true }, 0.0, id(k),
                Array(3) { at[it].copyOf() }, arrayOf(none, none, none), DoubleArray(200) { 0.4 },
                DoubleArray(200) { 1.0 },
            ).unwrapped().folded()
        }
        val file = home.resolve("walk.dump")
        Files.newBufferedWriter(file).use { out ->
            for (s in states) {
                if (hasTimes) out.append("ITEM: TIME\n${s.time}\n")
                out.append("ITEM: TIMESTEP\n${s.step}\nITEM: NUMBER OF ATOMS\n200\nITEM: BOX BOUNDS pp pp pp\n")
                repeat(3) { out.append("-5 5\n") }
                out.append("ITEM: ATOMS id x y z ix iy iz radius\n")
                for (i in 0 until 200) {
                    val places = (0..2).joinToString(" ") { "${s.position[it][i]}" }
                    out.append("${s.id[i]} $places ${(0..2).joinToString(" ") { "${s.image!![it][i]}" }} 0.4\n")
                }
            }
        }
        return file
    }

    private val all = IntArray(200) { it + 1 }

    @Test
    fun `steps are no times for diffusion, and the report says what would make them`() {
        val file = walk(hasTimes = false) { all }
        val silent = AnalysisInput.ofFile(file, null, "")
        assertTrue(numbers(silent).keys.none { "diffusion" in it })
        val out = Files.createDirectories(home.resolve("out"))
        Analysis(silent, AnalysisOptions(from = 0.0)).write(out)
        val page = Files.readString(out.resolve("report.html"))
        assertTrue("Diffusion: the file has no times" in page)
        assertTrue("time 0 to 590 steps" in page)
        assertEquals(0.5, numbers(AnalysisInput.ofFile(file, null, "", 0.1)).getValue("self_diffusion"), 0.05)
        assertEquals(0.5, numbers(AnalysisInput.ofFile(walk(true) { all }, null, "")).getValue("self_diffusion"), 0.05)
    }

    @Test
    fun `diffusion is of the particles that are in every state`() {
        val file = walk(hasTimes = true) { k -> if (k < 30) all else all.copyOf().also { it[199] = 900 } }
        assertEquals(0.5, numbers(AnalysisInput.ofFile(file, null, "")).getValue("self_diffusion"), 0.05)
    }

    /** 300 particles at random in boxes of [edges], which repeat along z or do not. */
    private fun changing(name: String, isSlab: Boolean, edges: List<DoubleArray>): Path {
        val random = Random(11)
        val n = 300
        val states = edges.mapIndexed { k, l ->
            Snapshot(
                k.toLong(), k.toDouble(), l, booleanArrayOf(true, true, !isSlab), 0.0, IntArray(n) { it },
                Array(3) { a -> DoubleArray(n) { (random.nextDouble() - 0.5) * l[a] } }, Array(3) { DoubleArray(n) },
                DoubleArray(n) { 0.4 }, DoubleArray(n) { 1.0 },
            )
        }
        return home.resolve(name).also { H5md.write(states, it, "test") }
    }

    @Tag("thorough")
    @Test
    fun `a box that changes from frame to frame is measured in every section`() {
        val ways = mapOf<String, (Int) -> DoubleArray>(
            "breathes" to { k -> DoubleArray(3) { 10 * (1 + 0.02 * Math.sin(1.0 * k)) } },
            "shrinks" to { k -> DoubleArray(3) { 10 - 0.2 * k } },
            "grows" to { k -> DoubleArray(3) { 10 + 0.5 * k } },
            "strains" to { k -> doubleArrayOf(10 + 0.3 * k, 10 - 0.2 * k, 10.0) },
        )
        for ((name, edges) in ways) {
            for (isSlab in listOf(false, true)) {
                val file = changing("$name$isSlab.h5", isSlab, List(12) { edges(it) })
                val out = Files.createDirectories(home.resolve("$name$isSlab"))
                Analysis(AnalysisInput.ofFile(file, null, ""), AnalysisOptions(from = 0.0)).write(out)
                val found = table(out, "profile-radial")
                val depths = found.map { it.getValue("optical_depth") }
                val mean = depths.average()
                for (end in listOf(depths.first(), depths.last())) {
                    assertEquals(mean, end, mean / 2) {
                        "$name: $depths"
                    }
                }
                val lags = table(out, "autocorrelation")
                val middle = (0..11).map { edges(it)[0] }.average()
                assertEquals(middle / 2, lags.maxOf { it.getValue("dx") }, middle / 20) { name }
                assertTrue(table(out, "pair-correlation").isNotEmpty() && table(out, "structure-factor").isNotEmpty())
                assertEquals(isSlab, Files.exists(out.resolve("tables/occultation.csv")))
                assertTrue("The box changes: bins are" in Files.readString(out.resolve("report.html")))
            }
        }
    }

    private fun table(out: Path, name: String): List<Map<String, Double>> {
        val lines = Files.readAllLines(out.resolve("tables/$name.csv")).filter { !it.startsWith("#") }
        val names = lines[0].split(',').map { it.substringBefore(' ').trim('"') }
        return lines.drop(1).map { row -> names.zip(row.split(',').map { it.toDoubleOrNull() ?: Double.NaN }).toMap() }
    }

    @Test
    fun `a box that shrinks is reported as it is at the end`() {
        val states = listOf(20.0, 10.0).mapIndexed { k, l ->
            val p = doubleArrayOf(-3.0, 3.0)
            Snapshot(
                k.toLong(), k.toDouble(), doubleArrayOf(l, l, l), BooleanArray(3) { true }, 0.0, intArrayOf(0, 1),
                arrayOf(p, DoubleArray(2), DoubleArray(2)), Array(3) { DoubleArray(2) }, doubleArrayOf(1.0, 1.0),
                doubleArrayOf(1.0, 1.0),
            )
        }
        val file = home.resolve("shrinks.h5")
        H5md.write(states, file, "test")
        assertEquals(8 * Math.PI / 3000, numbers(AnalysisInput.ofFile(file, null, "")).getValue("filling_factor"), 1e-9)
    }
}
