package daphnis.analysis.input

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
