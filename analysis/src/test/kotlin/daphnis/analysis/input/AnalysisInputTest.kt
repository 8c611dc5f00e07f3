package daphnis.analysis.input

import daphnis.analysis.report.Analysis
import daphnis.analysis.report.AnalysisOptions
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.format.Snapshot
import daphnis.core.hill.HillSheet
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class AnalysisInputTest {
    @TempDir
    lateinit var directory: Path

    @Test
    fun `an analysis reads each state that it needs once, the last one too`() {
        val omega = 1.0
        val boundary = HillSheet(Box.centred(12.0, 12.0, 6.0), omega)
        val snapshots = List(24) { k ->
            val state = uniform(60, boundary, seed = 1L + k, radius = 0.3, omega = omega) { it.nextGaussian() }
            Snapshot.of(state.population, boundary, k.toLong(), k.toDouble())
        }
        val reads = IntArray(snapshots.size)
        val read = { k: Int -> snapshots[k].also { reads[k]++ } }
        val input = AnalysisInput(
            "made", null, Int.MAX_VALUE, null, DoubleArray(snapshots.size) { it.toDouble() }, read, { boundary },
            omega, null, null, null, null, emptyList(),
        )
        // Five are averaged, twenty are followed for diffusion, and the last is pictured.
        Analysis(input, AnalysisOptions(from = 4.0, frames = 5)).write(directory)
        assertTrue(">Diffusion</h2>" in Files.readString(directory.resolve("report.html")))
        assertArrayEquals(IntArray(snapshots.size) { if (it < 4) 0 else 1 }, reads)
    }

    @Test
    fun `a file without radii says so in a line, one with radii says nothing`() {
        fun notices(properties: String, row: String): List<String> {
            val text = "1\nProperties=$properties\n$row\n"
            return AnalysisInput.ofFile(Files.writeString(directory.resolve("a.xyz"), text), null, "").notices
        }
        val line = notices("species:S:1:pos:R:3", "X 0 0 0").single()
        for (part in listOf("a.xyz", "has no radii", "0.5 is taken")) assertTrue(part in line) { line }
        assertEquals(emptyList<String>(), notices("species:S:1:pos:R:3:radius:R:1", "X 0 0 0 1"))
    }
}
