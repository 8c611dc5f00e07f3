package daphnis.app

import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** What the script that starts the JVM makes of limits and options; `echo` stands for the JVM. */
@Tag("jdk-neutral")
class LauncherTest {
    private fun launched(options: String, before: String = ":", words: String = "run gas"): Pair<Int, String> {
        val script = Repository.root.resolve("src/dist/lib/launch.sh")
        val text = """
            set -eu
            . '$script'
            java=echo release=/dev/null major=17
            archived() { return 1; }
            settled() { return 0; }
            $before
            launch some.jar $words
        """.trimIndent()
        val builder = ProcessBuilder("sh", "-c", text).redirectErrorStream(true)
        for (name in listOf("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS")) builder.environment().remove(name)
        builder.environment()["JAVA_OPTS"] = options
        val process = builder.start()
        val said = process.inputStream.use { String(it.readAllBytes()) }.trim()
        return process.waitFor() to said
    }

    @Test
    fun `a small heap brings no flags of which the JVM warns, and too small a one is a line`() {
        for (options in listOf("", "-Xmx100m", "-Xmx8g -Dk=1k", "-Xmx100000000")) {
            val (code, said) = launched(options)
            assertEquals(0, code) { said }
            assertTrue("-Xms8m" in said && "-XX:MaxNewSize=64m" in said && options in said) { "$options: $said" }
        }
        for (options in listOf("-Xmx12m", "-Xmx8M", "-Dk=1 -Xmx64m -Dl=2", "-Xmx60000k", "-Xmx16777216")) {
            val (code, said) = launched(options)
            assertEquals(0, code) { said }
            assertTrue("Xms" !in said && "NewSize" !in said && "-XX:+UseSerialGC" in said) { "$options: $said" }
        }
        for (options in listOf("-Xmx1m", "-Xmx7m", "-Xmx6000k", "-Xmx1000000")) {
            val (code, said) = launched(options)
            assertEquals(1, code) { said }
            assertTrue(said.startsWith("daphnis: not enough memory") && said.lines().size == 1) { said }
        }
    }

    @Test
    fun `an analysis has a late second compiler, for loops over many particles, and the collector that was named`() {
        for (options in listOf("", "-XX:+UseParallelGC")) {
            val (code, said) = launched(options, words = "analyze runs/ring")
            assertEquals(0, code) { said }
            assertTrue("-XX:Tier4BackEdgeThreshold=4000000" in said && "TieredStopAtLevel" !in said) { said }
            assertEquals(options.isEmpty(), "-XX:+UseSerialGC" in said) { said }
        }
        assertTrue("Tier4" !in launched("").second)
    }

    @Test
    fun `a limit of open files below what the libraries take is a line that names it`() {
        val (code, said) = launched("", before = "ulimit -n 80")
        assertEquals(1, code) { said }
        assertEquals("daphnis: the limit of open files is 80, and 128 are needed at least; set it with ulimit -n", said)
        assertEquals(0, launched("", before = "ulimit -n 128").first)
    }
}
