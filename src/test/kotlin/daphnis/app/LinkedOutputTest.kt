package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path

/** Links in a directory of somebody else, where the names of files to come are known beforehand. */
class LinkedOutputTest {
    @TempDir
    lateinit var home: Path

    @Test
    fun `exports and movies are written through no link, whether it has their name or that of their beginning`() {
        val settings = listOf("particles.count=20", "until=1", "output.snapshotEvery=5")
        val small = settings.flatMap { listOf("--set", it) }.toTypedArray()
        val run = "${home.resolve("run")}"
        assertDone(daphnis("run", "cooling-gas", *small, "--out", run, "--quiet"))
        val precious = Files.writeString(home.resolve("precious"), "precious")
        val out = Files.createDirectories(home.resolve("out"))
        val commands = mapOf(
            "trajectory.xyz" to arrayOf("export", run, "--format", "xyz", "--out", "$out"),
            "m.gif" to arrayOf("movie", run, "--quiet", "--width", "240", "--out", "$out/m.gif"),
        )
        for ((name, command) in commands) {
            for (link in listOf(name, "$name.part")) {
                Files.deleteIfExists(out.resolve(name))
                Files.createSymbolicLink(out.resolve(link), precious)
                assertDone(daphnis(*command))
                assertEquals("precious", Files.readString(precious)) { link }
                assertTrue(Files.isRegularFile(out.resolve(name), NOFOLLOW_LINKS)) { link }
            }
        }
    }
}
