package daphnis.analysis.sweep

import daphnis.analysis.plot.Figures
import daphnis.analysis.report.ReportNumber
import daphnis.analysis.requireReplacedWhole
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

class SweepTest {
    @TempDir
    lateinit var folder: Path

    private fun number(value: Double, key: String = "depth") = ReportNumber(key, "depth τ", "m^2/s", value)

    private fun run(values: List<String>, seed: Long, value: Double) =
        SweepRun("${values.joinToString()},seed=$seed", values, seed, listOf(number(value)))

    private fun failed(values: List<String>, seed: Long) =
        SweepRun("${values.joinToString()},seed=$seed", values, seed, emptyList(), "no place, \"none\"")

    private fun oneKey() = Sweep(
        listOf("a.b"),
        listOf(
            run(listOf("1"), 1, 2.0),
            run(listOf("1"), 2, 4.0),
            run(listOf("10"), 1, 7.0),
            failed(listOf("10"), 2),
        ),
    )

    private fun written(write: (Path) -> Unit): List<String> {
        val file = folder.resolve("table.csv")
        write(file)
        return Files.readAllLines(file)
    }

    @Test
    fun `one standard error of made runs covers the truth in 60 to 75 percent, and of each point alone`() {
        val random = SeededRandom(8)
        val covered = IntArray(2)
        repeat(REALISATIONS) {
            val runs = listOf(3.0, 50.0).flatMapIndexed { k, truth ->
                (1L..8).map { run(listOf("$k"), it, truth + (k + 1) * random.nextGaussian()) }
            }
            for ((k, point) in Sweep(listOf("x"), runs).points.withIndex()) {
                val mean = point.mean("depth")
                if (abs(mean.mean - listOf(3.0, 50.0)[k]) <= mean.error) covered[k]++
            }
        }
        for (c in covered) assertTrue(c.toDouble() / REALISATIONS in 0.60..0.75) { "$c of $REALISATIONS" }
    }

    @Test
    fun `the table of means has a row for each point and quantity, and says which runs failed`() {
        val lines = written { SweepTables(oneKey()).writeMeans(it) }
        assertEquals("a.b,quantity,unit,mean,standard_error,runs,remark", lines[0])
        assertEquals("1,depth,m^2/s,3.0,1.0,2,", lines[1])
        assertEquals("10,depth,m^2/s,7.0,,1,\"seed 2 failed: no place, \"\"none\"\"\"", lines[2])
        assertEquals(3, lines.size)
    }

    @Test
    fun `tables and plots are replaced whole`() {
        val place = folder.resolve("sweep")
        requireReplacedWhole(place, files = 4) {
            Files.createDirectories(place)
            SweepTables(oneKey()).writeMeans(place.resolve("means.csv"))
            SweepTables(oneKey()).writeRuns(place.resolve("runs.csv"))
            SweepPlots(oneKey()).write(place.resolve("plots"))
        }
    }

    @Test
    fun `the table of runs has every number of every run`() {
        val lines = written { SweepTables(oneKey()).writeRuns(it) }
        assertEquals("run,a.b,seed,depth [m^2/s],remark", lines[0])
        assertEquals("\"1,seed=2\",1,2,4.0,", lines[2])
        assertEquals("\"10,seed=2\",10,2,,\"failed: no place, \"\"none\"\"\"", lines[4])
    }

    @Test
    fun `a sweep in which all failed still has its points`() {
        val sweep = Sweep(listOf("a"), listOf(failed(listOf("1"), 1)))
        val lines = written { SweepTables(sweep).writeMeans(it) }
        assertEquals("1,,,,,0,\"seed 1 failed: no place, \"\"none\"\"\"", lines[1])
        assertEquals("failed: 1,seed=1: no place, \"none\"", SweepText(sweep).text(80))
        assertEquals(0, SweepPlots(sweep).write(folder.resolve("plots")))
    }

    @Test
    fun `the printed table has an error where there are two seeds, and says how often it covers`() {
        val text = SweepText(oneKey()).text(80)
        assertEquals("| a.b           |         1 |        10 |", text.lines()[0])
        assertEquals("| depth τ, m²/s | 3.0 ± 1.0 | 7 (n = 1) |", text.lines()[2])
        assertTrue("n = 2 runs" in text && "50 % of cases" in text) { text }
        assertTrue("failed: 10,seed=2: no place" in text) { text }
    }

    @Test
    fun `with one seed there is no error anywhere`() {
        val sweep = Sweep(listOf("a"), listOf(run(listOf("1"), 1, 2.0), run(listOf("2"), 1, 3.5)))
        assertFalse("±" in SweepText(sweep).text(80))
        assertTrue("| 3.500 |" in SweepText(sweep).text(80)) { SweepText(sweep).text(80) }
        assertEquals("1,depth,m^2/s,2.0,,1,", written { SweepTables(sweep).writeMeans(it) }[1])
    }

    @Test
    fun `points that do not fit beside each other stand below each other`() {
        val sweep = Sweep(listOf("a"), (1..9).map { run(listOf("$it"), 1, it * 1.0) })
        val narrow = SweepText(sweep).text(40)
        assertTrue(narrow.lines().all { it.length <= 40 } && "\n\n" in narrow) { narrow }
        assertFalse("\n\n" in SweepText(sweep).text(200))
        assertEquals(9, SweepText(sweep).text(1).split("\n\n").size)
    }

    @Test
    fun `a plot has error bars, one for each quantity and axis, and curves for the other key`() {
        assertEquals(0, SweepPlots(oneKey().let { Sweep(it.keys, it.runs.take(2)) }).write(folder))
        assertEquals(1, SweepPlots(oneKey()).write(folder))
        assertTrue(Files.size(folder.resolve("depth.png")) > 1000)
        val runs = listOf("1", "2").flatMap { a ->
            listOf("8", "9").flatMap { b -> (1L..3).map { run(listOf(a, b), it, it + a.toDouble() * b.toDouble()) } }
        }
        assertEquals(2, SweepPlots(Sweep(listOf("a", "f[0].b"), runs)).write(folder))
        val svg = Files.readString(folder.resolve("depth-against-f-0-.b.svg")).replace(Regex("\\s"), "")
        assertTrue("a1" in svg && "a2" in svg && "f[0].b" in svg)
    }

    @Test
    fun `a number that is the same for all runs but for round-off has no plot`() {
        val runs = listOf("1", "2").map { run(listOf(it), 1, 0.1 + it.toDouble() * 1e-16) }
        assertEquals(0, SweepPlots(Sweep(listOf("a"), runs)).write(folder))
        assertEquals(1, SweepPlots(Sweep(listOf("a"), runs + run(listOf("2"), 2, 0.1001))).write(folder))
    }

    @Test
    fun `values that are no numbers stand at the axis in their order`() {
        val runs = listOf("[2,1]", "[1,3]").flatMap { a -> (1L..2).map { run(listOf(a), it, it * 1.0) } }
        assertEquals(1, SweepPlots(Sweep(listOf("box"), runs)).write(folder))
        val svg = Files.readString(folder.resolve("depth.svg"))
        assertTrue(svg.indexOf("[2,1]") in 1..<svg.indexOf("[1,3]"))
    }

    @Test
    fun `what is zero in all runs has no row in the text, and drifting averages are marked where they stand`() {
        fun run(seed: Long) = SweepRun(
            "$seed",
            emptyList(),
            seed,
            listOf(
                number(0.0, "end_momentum_x"),
                ReportNumber("temperature", "temperature", "", seed * 1.0, isSteady = seed == 3L),
                number(seed * 2.0, "count"),
            ),
        )
        val sweep = Sweep(emptyList(), (1L..3).map { run(it) })
        val text = SweepText(sweep).text(80)
        assertEquals(2, text.lines().count { "±" in it && it.startsWith("|") }) { text }
        assertTrue("0 in all runs: depth τ." in text && "2.00 ± 0.58 !" in text) { text }
        assertTrue("!: not steady over the time averaged, in 2 of 3 runs" in text) { text }
        val means = written { SweepTables(sweep).writeMeans(it) }
        assertTrue(means[1].startsWith("end_momentum_x,m^2/s,0.0,0.0,3,") && means[1].endsWith(",")) { means[1] }
        assertTrue(means[2].endsWith(",\"seeds 1, 2 not steady over the time averaged\"")) { means[2] }
        assertTrue(means[3].endsWith(",3,")) { means[3] }
        val runs = written { SweepTables(sweep).writeRuns(it) }
        assertTrue(runs[2].endsWith(",not steady over the time averaged") && runs[3].endsWith(",")) { "$runs" }
    }

    @Test
    fun `averages of runs that are too short to be judged say so, and those that drift come first`() {
        fun run(seed: Long) = SweepRun(
            "$seed",
            emptyList(),
            seed,
            listOf(
                ReportNumber("a", "a", "", seed * 1.0, isSteady = seed > 1, isJudged = seed != 2L),
                ReportNumber("b", "b", "", seed * 1.0, isSteady = true, isJudged = seed != 2L),
                number(seed * 2.0, "count"),
            ),
        )
        val sweep = Sweep(emptyList(), (1L..3).map { run(it) })
        val text = SweepText(sweep).text(80)
        assertEquals(
            listOf(" !", " ?", ".2"),
            text.lines().filter { "±" in it && it.startsWith("|") }.map { row ->
                row.removeSuffix(" |").takeLast(2)
            },
        ) { text }
        assertTrue(
            "?: not known to be steady: too few rows in the time averaged, in 1 of 3 runs; it takes 24" in text,
        ) {
            text
        }
        val means = written { SweepTables(sweep).writeMeans(it) }
        assertTrue(means[2].endsWith(",seed 2 not known to be steady: too few rows in the time averaged")) { means[2] }
        assertTrue(means[3].endsWith(",3,")) { means[3] }
        val runs = written { SweepTables(sweep).writeRuns(it) }
        assertTrue(runs[2].endsWith(",not known to be steady: too few rows in the time averaged")) { runs[2] }
    }

    @Test
    fun `two points are not joined by a line, and three only along numbers`() {
        fun lines(vararg values: String): Boolean {
            val runs = values.flatMap { a -> (1L..2).map { run(listOf(a), it, it + a.length * 1.0) } }
            val svg = Figures.svg(SweepPlots(Sweep(listOf("a"), runs)).plots().single().second)
            return svg.lines().any { "<path fill=\"none\" stroke=\"${Figures.COLOURS[0]}\"" in it }
        }
        assertFalse(lines("1", "20"))
        assertTrue(lines("1", "20", "300"))
        assertFalse(lines("[1]", "[2,1]", "[1,3,1]"))
    }

    @Test
    fun `an object as a value stands at the axis in words, or below it by number where words have no room`() {
        fun texts(values: List<String>): String {
            SweepPlots(Sweep(listOf("law"), values.map { run(listOf(it), 1, it.length * 1.0) })).write(folder)
            return Files.readString(folder.resolve("depth.svg")).replace(Regex("\\s+"), " ")
        }
        val short = listOf("{\"type\":\"bridges\"}", "{\"type\":\"borderies\"}")
        assertTrue(texts(short).let { ">bridges<" in it && ">borderies<" in it && "(1)" !in it })
        val four =
            listOf(short[0], "{\"type\":\"bridges\",\"prefactor\":0.3}") +
                listOf("{\"type\":\"borderies\",\"criticalSpeed\":0.1}", "{\"type\":\"none")
        val svg = texts(four)
        assertTrue(">(4)<" in svg && "(2) bridges, prefactor 0.3" in svg && "(3) borderies, criticalSpeed 0.1" in svg)
        assertTrue("(4) {\"type" in svg) { "what is malformed stays as it is" }
    }

    @Test
    fun `an axis has the label of its key`() {
        val runs = listOf("1", "2").map { run(listOf(it), 1, it.toDouble()) }
        SweepPlots(Sweep(listOf("a.b"), runs, listOf("a: b [m]"))).write(folder)
        val svg = Files.readString(folder.resolve("depth.svg"))
        assertTrue("a: b [m]" in svg && "a.b" !in svg)
        assertThrows(IllegalArgumentException::class.java) { Sweep(listOf("a.b"), runs, emptyList()) }
    }

    @Test
    fun `a quantity that has no meaning in any run is left out, one that has it in some is averaged over those`() {
        val runs = (1L..3).map {
            val some = number(if (it == 2L) Double.NaN else it.toDouble(), "some")
            SweepRun("$it", emptyList(), it, listOf(number(Double.NaN, "none"), some))
        }
        val sweep = Sweep(emptyList(), runs)
        assertEquals(listOf("some"), sweep.quantities.map { it.key })
        assertEquals("some,m^2/s,2.0,1.0,2,", written { SweepTables(sweep).writeMeans(it) }[1])
        assertTrue("2.0 ± 1.0 (n = 2)" in SweepText(sweep).text(80))
        assertTrue("in 58 % of cases, and in 50 % with n = 2." in SweepText(sweep).text(80))
        assertEquals(0, SweepPlots(sweep).write(folder.resolve("plots")))
    }

    @Test
    fun `more curves than colours are drawn`() {
        val runs = (1..10).flatMap { a -> listOf("x", "y").map { run(listOf("v$a", it), 1, a * 1.0) } }
        assertEquals(1, SweepPlots(Sweep(listOf("a", "b"), runs)).write(folder))
    }

    @Test
    fun `runs without a value for each key are refused`() {
        assertThrows(IllegalArgumentException::class.java) { Sweep(listOf("a", "b"), listOf(run(listOf("1"), 1, 1.0))) }
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
