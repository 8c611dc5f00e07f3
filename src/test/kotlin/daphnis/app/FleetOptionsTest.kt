package daphnis.app

import daphnis.cluster.ClusterFleet
import daphnis.cluster.ClusterNode
import daphnis.cluster.settings.ClusterSettings
import daphnis.core.cluster.NodesAwaited
import daphnis.core.cluster.nodeWork
import daphnis.core.run.Summary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

@Tag("jdk-neutral")
@Timeout(300)
class FleetOptionsTest {
    @TempDir
    lateinit var folder: Path

    @Tag("thorough")
    @Test
    fun `two nodes on this machine give the files of one process, and resume goes on without them`() {
        val one = "${folder.resolve("one")}"
        val two = "${folder.resolve("two")}"
        assertDone(daphnis("run", "cooling-gas", "--until", "2", "--engine", "serial", "--out", one, "--quiet"))
        assertDone(daphnis("run", "cooling-gas", "--until", "1", "--nodes", "2", "--out", two, "--quiet"))
        val summary = Summary.read(folder.resolve("two/summary.json"))
        assertEquals("cluster", summary.engine)
        assertDone(daphnis("resume", two, "--until", "2", "--quiet"))
        assertDone(daphnis("compare", one, two))
        assertEquals(
            Files.readString(folder.resolve("one/series.csv")),
            Files.readString(folder.resolve("two/series.csv")),
        )
    }

    @Tag("thorough")
    @Test
    fun `what is wrong is told in one line before a node is started`() {
        val out = "${folder.resolve("out")}"
        assertRefused(daphnis("run", "shear-cell", "--nodes", "0"), "--nodes", "1..1000")
        assertRefused(daphnis("run", "shear-cell", "--nodes", "2", "--threads", "0"), "--threads", "is 0")
        assertRefused(daphnis("run", "shear-cell", "--nodes", "2", "--engine", "serial"), "--engine", "one process")
        assertRefused(daphnis("run", "shear-cell", "--host", "a"), "--host", "needs --cluster")
        assertRefused(daphnis("run", "shear-cell", "--config", "a"), "--config", "needs --cluster or --nodes")
        assertRefused(daphnis("run", "shear-cell", "--cluster", "a:1", "--threads", "2"), "--threads", "each node")
        assertRefused(daphnis("resume", "${folder.resolve("none")}", "--nodes", "3"), "none")
        assertRefused(daphnis("resume", out, "--threads", "2"), "--threads", "needs --nodes")
        fun refuse(vararg options: String, says: String) =
            assertRefused(daphnis("run", "shear-cell", "--out", out, *options), says)
        refuse("--cluster", "foo", says = "a port is needed")
        refuse("--cluster", "127.0.0.1:70000", says = "--cluster")
        refuse("--cluster", "127.0.0.1:1", "--secret-file", "$out/none", says = "none")
        refuse("--cluster", "127.0.0.1:1", "--config", "$out/none", says = "none")
        refuse("--nodes", "2", "--config", "$out/none", says = "none")
        refuse("--cluster", "127.0.0.1:1", "--host", "192.0.2.1", says = "open to other machines")
        assertFalse(Files.exists(Path.of(out)))
        assertTrue(Files.list(folder).use { it.count() } == 0L)
    }

    @Tag("thorough")
    @Test
    fun `a second run says which run it waits for, and computes when that has ended`() {
        val settings = ClusterSettings()
        ClusterNode.start(settings, nodeWork()) { }.use { node ->
            val first = ClusterFleet.join(settings.copy(join = listOf(node.address)), "first") { }
            first.form(NodesAwaited(first, Duration.ofSeconds(90)) { }.await(1))
            val seen = "1 node is busy with the run first of ${first.address}; waiting for it"
            val lines = Lines { if (seen in it) first.close() }
            val err = System.err
            System.setErr(PrintStream(lines, true))
            val code = try {
                val out = "${folder.resolve("second")}"
                runDaphnis(arrayOf("run", "cooling-gas", "--steps", "3", "--cluster", "${node.address}", "--out", out))
            } finally {
                System.setErr(err)
                first.close()
            }
            assertEquals(0, code) { lines.text }
            val told = lines.text.lines().filter { it.startsWith("daphnis: ") }.map { it.removePrefix("daphnis: ") }
                // A busy machine may hide the node for a moment, before it was asked or between its two runs.
                .filter { !it.startsWith("no node is there; waiting for") }
            assertEquals(seen, told[0]) { lines.text }
            assertTrue(told[1].startsWith("1 node with ")) { lines.text }
        }
    }

    /** Takes what is written, and tells [heard] of each line at its end. */
    private class Lines(private val heard: (String) -> Unit) : ByteArrayOutputStream() {
        val text: String get() = toString(Charsets.UTF_8)

        override fun write(bytes: ByteArray, from: Int, length: Int) {
            super.write(bytes, from, length)
            if (text.endsWith("\n")) heard(text.trimEnd().substringAfterLast('\n'))
        }
    }
}
