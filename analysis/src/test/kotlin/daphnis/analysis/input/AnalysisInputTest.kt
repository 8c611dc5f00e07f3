package daphnis.analysis.input

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class AnalysisInputTest {
    @TempDir
    lateinit var directory: Path

    @Test
    fun `a file without radii says so in a line, one with radii says nothing`() {
        fun notices(properties: String, row: String): List<String> {
            val text = "1\nProperties=$properties\n$row\n"
            return AnalysisInput.ofFile(Files.writeString(directory.resolve("a.xyz"), text), null, "").notices
        }
        val line = notices("species:S:1:pos:R:3:velo:R:3", "X 0 0 0 1 2 3").single()
        for (part in listOf("a.xyz", "has no radii", "0.5 is taken")) assertTrue(part in line) { line }
        assertEquals(emptyList<String>(), notices("species:S:1:pos:R:3:velo:R:3:radius:R:1", "X 0 0 0 1 2 3 1"))
    }

    @Test
    fun `a file of which one state has no velocities has none, and the notice names the state`() {
        val moving = "1\nTime=0 Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1\nX 0 0 0 1 2 3 1\n"
        val silent = "1\nTime=1 Properties=species:S:1:pos:R:3:radius:R:1\nX 0 0 0 1\n"
        fun input(text: String) = AnalysisInput.ofFile(Files.writeString(directory.resolve("b.xyz"), text), null, "")
        assertTrue(input(moving).hasVelocities)
        val mixed = input(moving + silent)
        assertFalse(mixed.hasVelocities)
        assertTrue(mixed.notices.any { "has no velocities in frame 1" in it }) { "${mixed.notices}" }
    }
}
