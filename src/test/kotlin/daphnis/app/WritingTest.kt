package daphnis.app

import daphnis.core.run.RunException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What is said of directories into which something is to be written. */
class WritingTest {
    @Test
    fun `long work does not begin where nothing can be written`() {
        // Not even root can.
        val directory = Path.of("/proc")
        assumeTrue(Files.isDirectory(directory))
        var isBegun = false
        val e = assertThrows(RunException::class.java) { writingLater(directory) { isBegun = true } }
        assertTrue(e.message!!.startsWith("cannot write to /proc: ")) { e.message }
        assertEquals(false, isBegun)
    }

    @Test
    fun `a directory is made, and nothing but the work is left in it`(@TempDir temp: Path) {
        val directory = temp.resolve("a/b")
        assertEquals(7, writingLater(directory) { 7 })
        assertEquals(0, Files.list(directory).use { it.count() })
    }
}
