package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.format.Snapshot
import daphnis.core.hill.HillSheet
import daphnis.core.orbit.OrbitalFrequencies
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.function.IntFunction

@Tag("jdk-neutral")
class StatesReadOnceTest {
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
        val read = IntFunction { k -> snapshots[k].also { reads[k]++ } }
        val times = DoubleArray(snapshots.size) { it.toDouble() }
        val input = AnalysisInput.ofStates("made", times, boundary, OrbitalFrequencies(omega), read)
        // Five are averaged, twenty are followed for diffusion, the last is pictured, and has the radii of the first.
        Analysis(input, AnalysisOptions(from = 4.0, frames = 5)).write(directory)
        assertTrue(">Diffusion</h2>" in Files.readString(directory.resolve("report.html")))
        assertArrayEquals(IntArray(snapshots.size) { if (it in 1 until 4) 0 else 1 }, reads)
    }
}
