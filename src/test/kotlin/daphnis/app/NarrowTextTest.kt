package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

class NarrowTextTest {
    @TempDir
    lateinit var home: Path

    private val text = """
        | mean radius, units of length | 0.5 | [20,20,20] |
        |------------------------------|----:|-----------:|
        | filling factor               |   1 |          – |
        | temperature of the spheres at the end | 2 |    |

        n = 2 runs that differ in their seed
    """.trimIndent()

    @Test
    fun `a table that is too wide becomes a list, and a paragraph goes on below`() {
        val narrow = """
            filling factor
              0.5         1
              [20,20,20]  –
            temperature of the
            spheres at the end
              0.5         2

            n = 2 runs that
            differ in their seed
        """.trimIndent()
        assertEquals(narrow, fitted(text, 20))
        assertEquals(text, fitted(text, 60))
        assertTrue(fitted(text, 12).startsWith("filling\nfactor\n  0.5\n    1\n"))
    }

    @Test
    fun `a number of columns is a positive one`() {
        assertEquals(40, columnsOf(" 40"))
        for (none in listOf(null, "", "0", "-3", "wide", "1e3")) assertNull(columnsOf(none))
    }

    @Test
    fun `what is written elsewhere than to a terminal is as wide as the variable COLUMNS says`() {
        assertTrue(widest("describe", "cooling-gas") in 30..40)
    }

    @Tag("thorough")
    @Test
    fun `so is what every other command writes`() {
        assertTrue(widest("scenarios") in 30..40)
        assertTrue(widest("run", "--help") in 30..40)
        val sweep = arrayOf("sweep", "cooling-gas", "--set", "particles.count=30", "--set", "until=1", "--quiet")
        assertTrue(widest(*sweep, "--seeds", "1,2", "--out", "a") in 30..40)
        val bench = arrayOf("bench", "cooling-gas", "--engines", "serial", "--steps", "1", "--rounds", "1", "--quiet")
        assertTrue(widest(*bench, "--out", "b") in 30..40)
    }

    private fun widest(vararg words: String): Int = said(*words).lines().maxOf { it.length }

    /** In a process of its own, since the environment of this one is what it is. */
    private fun said(vararg words: String): String {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val log = Files.createTempFile(home, "says", "")
        val builder = ProcessBuilder(listOf(java, "-XX:TieredStopAtLevel=1", "daphnis.app.MainKt") + words)
            .directory(home.toFile()).redirectOutput(log.toFile())
        builder.environment()["CLASSPATH"] = System.getProperty("java.class.path").split(File.pathSeparator)
            .joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        builder.environment()["COLUMNS"] = "40"
        val process = builder.redirectErrorStream(false).redirectError(home.resolve("error").toFile()).start()
        assertTrue(process.waitFor(2, TimeUnit.MINUTES))
        assertEquals(0, process.exitValue()) { Files.readString(home.resolve("error")) }
        return Files.readString(log)
    }
}
