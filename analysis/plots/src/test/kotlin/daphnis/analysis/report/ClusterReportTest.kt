package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.neighbour.ClusterCriterion
import daphnis.analysis.neighbour.ClusterSizes
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
import kotlin.math.abs

/** What reports say of clusters. */
class ClusterReportTest {
    @TempDir
    lateinit var home: Path

    private fun run(name: String, vararg settings: String): Path {
        val path = home.resolve(name)
        val all = listOf(
            "particles.count=200",
            "box.lengths=[14,14,14]",
            "until=12",
            "output={\"snapshotEvery\":3,\"seriesEvery\":1}",
        )
        Run.start(BuiltIn.scenario("elastic-gas", all + settings), "elastic-gas", path).use { it.execute() }
        return path
    }

    private fun report(path: Path, ratio: Double? = null): String {
        val options = AnalysisOptions(from = 3.0, clusterRatio = ratio)
        Analysis(AnalysisInput.ofRun(path), options).write(path)
        return Files.readString(path.resolve("report.html"))
    }

    private fun rows(path: Path, table: String) =
        Files.readAllLines(path.resolve("tables/$table.csv")).map { it.split(',') }

    @Test
    fun `spheres that attract each other have clusters as far as the attraction reaches`() {
        val path = run("well", "interaction={\"type\":\"square-well\",\"ratio\":1.5,\"depth\":1}")
        val page = report(path)
        assertTrue("Clusters</h2>" in page)
        assertTrue("they attract each other: their centres are up to 1.5 sums of their radii apart, by way" in page)
        val numbers = rows(path, "numbers").associateBy { it[0] }
        val keys = listOf("count", "share", "size", "size_of_sphere", "size_slope", "spanning_share")
        for (key in keys.map { "cluster_$it" } + "largest_cluster") {
            val row = numbers.getValue(key)
            assertTrue(row[1].toDouble() >= 0 && (row[2].isEmpty() != row[5].isEmpty())) { row.joinToString() }
        }
        assertTrue(numbers.getValue("cluster_share")[1].toDouble() in 0.3..0.9)
        // The last state, in three tables: single spheres are in that of sizes only.
        val sizes = rows(path, "cluster-sizes")
        assertEquals(listOf("size_from", "size_to", "clusters", "clusters_error", "clusters_last"), sizes[0])
        val clusters = rows(path, "clusters").drop(1)
        assertEquals(sizes.drop(2).sumOf { it[4].toDouble() }, clusters.size.toDouble())
        val history = rows(path, "cluster-history")
        val last = history[0].map { it.substringBefore(" [") }.zip(history.last()).toMap()
        assertEquals(last.getValue("clusters").toDouble(), clusters.size.toDouble())
        assertEquals(last.getValue("largest"), clusters[0][0])
        assertEquals(200 * last.getValue("share").toDouble(), clusters.sumOf { it[0].toDouble() }, 1e-9)
        assertEquals(41, history.size - 1) { "the whole run, not only what is averaged" }
        for (plot in listOf("cluster-sizes", "cluster-history")) {
            assertTrue(Files.exists(path.resolve("plots/$plot.svg"))) { plot }
        }
        assertEquals(
            numbers.keys.count { "cluster" in it },
            Analysis(AnalysisInput.ofRun(path)).numbers().count {
                "cluster" in
                    it.key
            },
        )
    }

    @Test
    fun `others have them where they are asked for`() {
        val path = run("plain")
        assertFalse("Clusters</h2>" in report(path))
        assertFalse(Files.exists(path.resolve("tables/clusters.csv")))
        assertTrue("up to 1.2 sums of their radii apart" in report(path, 1.2))
        assertTrue(rows(path, "numbers").any { it[0] == "cluster_count" })
        assertTrue("spheres of a cluster would be farther apart than the box is wide" in report(path, 20.0))
        assertTrue(
            "in no state are there two where their centres are up to 1 sums of their radii apart" in report(path, 1.0),
        )
        for (wrong in listOf(0.9, 101.0, Double.NaN)) {
            val e = assertThrows(InputException::class.java) { AnalysisOptions(clusterRatio = wrong) }
            assertTrue("is $wrong; it must be in 1..100 sums of radii" in e.message!!) { e.message }
        }
    }

    @Test
    fun `only materials that attract are linked, and a shoulder is none`() {
        val materials = "particles={\"materials\":[" +
            "{\"name\":\"a\",\"count\":100,\"sizes\":{\"type\":\"equal\",\"radius\":0.5}}," +
            "{\"name\":\"b\",\"count\":100,\"sizes\":{\"type\":\"equal\",\"radius\":0.3}}]}"
        val well = "{\"type\":\"square-well\",\"ratio\":1.5,\"depth\":2}"
        val path = run("two", materials, "contacts=[{\"between\":[\"a\",\"a\"],\"interaction\":$well}]")
        val page = report(path)
        assertTrue("as far as the interaction of their materials does" in page)
        val mass = rows(path, "clusters").drop(1).map { it[1].toDouble() / it[0].toDouble() }
        // All members are of the larger kind.
        assertTrue(mass.isNotEmpty() && mass.all { it > 0.52 }) { "$mass" }
        val shoulder = run("shoulder", "interaction={\"type\":\"square-shoulder\",\"ratio\":1.5,\"height\":1}")
        assertTrue("up to 1.1 sums of their radii apart" in report(shoulder))
        assertFalse(rows(shoulder, "numbers").any { "cluster" in it[0] })
    }

    @Tag("thorough")
    @Test
    fun `errors of real runs cover the mean over seeds`() {
        val criterion = ClusterCriterion(1.5)
        val runs = (1..SEEDS).map { seed ->
            val path = run(
                "seed-$seed",
                "interaction={\"type\":\"square-well\",\"ratio\":1.5,\"depth\":1}",
                // Without a bath each seed would have the energy, and so the temperature, of its placement.
                "forces=[{\"type\":\"andersen\",\"rate\":1,\"temperature\":2}]",
                "particles.count=100",
                "box.lengths=[11,11,11]",
                "until=100",
                "output={\"snapshotEvery\":10}",
                "seed=$seed",
            )
            val input = AnalysisInput.ofRun(path)
            val averages = Averages(ClusterSizes(criterion))
            for (k in 20 until input.size) averages.add(input.state(k))
            ClusterSizes.NUMBERS.indices.map { averages.average(it) } + averages.average(ClusterSizes.NUMBERS.size + 1)
        }
        for (k in runs[0].indices) {
            if (ClusterSizes.NUMBERS.getOrNull(k) == "spanning_share") continue
            val truth = runs.map { it[k].mean }.average()
            val known = runs.filter { it[k].isLevelled }
            val covered = known.count { abs(it[k].mean - truth) <= it[k].error }
            assertTrue(known.size > 0.9 * SEEDS && covered.toDouble() / known.size in 0.55..0.8) { "$k: $covered" }
        }
    }

    private companion object {
        const val SEEDS = 100
    }
}
