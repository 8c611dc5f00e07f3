package daphnis.app.progress

import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Path

@Timeout(60)
class ProgressTest {
    @TempDir
    lateinit var folder: Path
    private val text = ByteArrayOutputStream()
    private val heard = ArrayList<String>()

    /** Writes for long, and saves for long, and notes what was said meanwhile. */
    private inner class Slow : Output {
        private fun linger() {
            val before = text.size()
            Thread.sleep(300)
            heard += "$text".substring(before)
        }

        override fun open(simulation: Simulation, opening: Opening) = linger()

        override fun write(simulation: Simulation) = linger()

        override fun save(state: OutputState) = linger()
    }

    @Test
    fun `a step is told of while it is computed, and not while its output is written`() {
        val old = System.out
        System.setOut(PrintStream(text, true))
        try {
            val scenario = BuiltIn.scenario("cooling-gas", listOf("particles.count=20", "until=0.3"))
            val outputs = mapOf("slow" to Slow())
            Run.start(scenario, "gas", folder.resolve("run"), outputs = outputs).use { run ->
                val times = TimesInWords(null, null)
                val progress = Progress(quiet = false, run.until, times, "", { Long.MAX_VALUE }, patience = 100_000_000)
                run.execute(progress) {
                    progress.beginStep()
                    if (run.simulation.step == 1L) Thread.sleep(300)
                    false
                }
            }
        } finally {
            System.setOut(old)
        }
        assertEquals(listOf(""), heard.distinct())
        assertTrue(heard.size > 5) { "$heard" }
        assertTrue("step 2 has taken 0 s so far" in "$text") { "$text" }
    }
}
