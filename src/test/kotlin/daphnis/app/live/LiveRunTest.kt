package daphnis.app.live

import daphnis.analysis.plot.PlotScale
import daphnis.analysis.plot.RunPlot
import daphnis.analysis.table.UnitNames
import daphnis.app.CommandResult
import daphnis.app.assertDone
import daphnis.app.assertRefused
import daphnis.app.daphnis
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayInputStream
import java.io.IOException
import java.net.ServerSocket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse.BodyHandlers
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import java.util.concurrent.CompletableFuture
import javax.imageio.ImageIO

@Timeout(120)
class LiveRunTest {
    @TempDir
    lateinit var folder: Path

    private val words = arrayOf("run", "cooling-gas", "--set", "until=100", "--quiet")

    private fun digest(result: CommandResult) = assertDone(result).lines().single { it.startsWith("state digest") }

    /** Events by kind, each with its last text, of the page at [port]; waits until it is there. */
    private fun watch(port: Int, path: String = "events"): Map<String, String> {
        val request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:$port/$path")).build()
        val client = HttpClient.newHttpClient()
        repeat(200) {
            try {
                val seen = LinkedHashMap<String, String>()
                var kind = ""
                client.send(request, BodyHandlers.ofLines()).body().forEach { line ->
                    if (line.startsWith("event: ")) kind = line.removePrefix("event: ")
                    if (line.startsWith("data: ")) seen[kind] = line.removePrefix("data: ")
                    if (line.startsWith("data: ") &&
                        kind == "state"
                    ) {
                        fetched += state(client, port, seen.getValue(kind))
                    }
                }
                return seen
            } catch (e: IOException) {
                Thread.sleep(20)
            }
        }
        throw AssertionError("nothing at port $port")
    }

    @Test
    fun `a run that is looked at shows itself to its end, and comes to the digest of one that is not`() {
        val port = ServerSocket(0).use { it.localPort }
        val seen = CompletableFuture.supplyAsync { watch(port) }
        val watched = daphnis(*words, "--live", "$port", "--out", "${folder.resolve("watched")}")
        assertTrue("live: http://127.0.0.1:$port/" in watched.out) { watched.out }
        val digest = digest(watched)
        val alone = daphnis(*words, "--out", "${folder.resolve("alone")}")
        assertEquals(digest(alone), digest)
        assertArrayEquals(
            Files.readAllBytes(folder.resolve("alone/series.csv")),
            Files.readAllBytes(folder.resolve("watched/series.csv")),
        )
        val events = seen.get()
        assertTrue("cooling-gas" in events.getValue("run"))
        assertTrue("left" in events.getValue("progress") && "of 100" in events.getValue("progress")) { "$events" }
        assertTrue(digest in events.getValue("end")) { events.getValue("end") }
        assertTrue("\"kind\":\"complete\"" in events.getValue("end")) { events.getValue("end") }
        assertTrue("\"part\": 1.0" in events.getValue("progress")) { events.getValue("progress") }
        val picture = events.getValue("picture").removePrefix("data:image/png;base64,")
        val image = ImageIO.read(ByteArrayInputStream(Base64.getDecoder().decode(picture)))
        assertEquals(900, image.width)
        val series =
            String(Base64.getDecoder().decode(events.getValue("series").removePrefix("data:image/svg+xml;base64,")))
        // That of the whole run, to its last row.
        val file = folder.resolve("watched/series.csv")
        assertEquals(RunPlot.svg(file, "cooling-gas", PlotScale(UnitNames(null), null, 1.0)), series)
        assertTrue("problem" !in events) { "$events" }
    }

    private val fetched = ArrayList<DecodedState>()

    /** The state that an event tells of, which the next one may have replaced; the last one has to be there. */
    private fun state(client: HttpClient, port: Int, event: String): List<DecodedState> {
        val number = event.filter { it.isDigit() }
        val request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:$port/state/$number")).build()
        val answer = client.send(request, BodyHandlers.ofByteArray())
        return if (answer.statusCode() == 200) listOf(DecodedState(answer.body())) else emptyList()
    }

    @Tag("thorough")
    @Test
    fun `a page that draws states gets them up to the last, which is that of the run, whose bits do not notice`() {
        val port = ServerSocket(0).use { it.localPort }
        val seen = CompletableFuture.supplyAsync { watch(port, "changes") }
        val watched = daphnis(*words, "--live", "$port", "--out", "${folder.resolve("watched")}")
        val digest = digest(watched)
        assertEquals(digest(daphnis(*words, "--out", "${folder.resolve("alone")}")), digest)
        val events = seen.get()
        assertTrue("picture" !in events && "problem" !in events) { "$events" }
        val end = fetched.last()
        val last = daphnis.core.run.Run.open(folder.resolve("alone")).last()
        assertEquals(last.step, end.text("number").toLong())
        assertEquals(last.size, end.count)
        // The page has them in the order of the run, which is not that of ids.
        for (axis in 0..2) {
            val there = end.columns[axis].sortedArray()
            val those = FloatArray(last.size) { last.position[axis][it].toFloat() }.sortedArray()
            for (k in there.indices) assertEquals(those[k], there[k], 1e-5f)
        }
    }

    @Test
    fun `a page that comes when a run has just ended is told how`() {
        val port = ServerSocket(0).use { it.localPort }
        val page = LivePage(port)
        page.endsWith(Ending.Kind.INTERRUPTED, "interrupted \"here\"")
        val client = HttpClient.newHttpClient()
        val html = HttpRequest.newBuilder(URI.create(page.address)).build()
        assertEquals(200, client.send(html, BodyHandlers.discarding()).statusCode())
        val events = HttpRequest.newBuilder(URI.create("${page.address}changes")).build()
        val late = CompletableFuture.supplyAsync {
            Thread.sleep(200)
            client.send(events, BodyHandlers.ofLines()).body().toList()
        }
        page.close()
        val end = "data: {\"kind\":\"interrupted\",\"text\":\"interrupted \\\"here\\\"\"}"
        assertEquals(listOf("event: end", end, ""), late.get())
    }

    @Test
    fun `without anybody who looks a run with a page is as any other`() {
        val watched = daphnis("run", "cooling-gas", "--steps", "5", "--live", "--out", "${folder.resolve("a")}")
        assertTrue(Regex("live: http://127\\.0\\.0\\.1:\\d+/") in watched.out) { watched.out }
        assertEquals(
            digest(daphnis("run", "cooling-gas", "--steps", "5", "--out", "${folder.resolve("b")}")),
            digest(watched),
        )
    }

    @Test
    fun `a number after the option is its port, and any other word the scenario`() {
        val out = arrayOf("--steps", "2", "--out", "${folder.resolve("a")}")
        assertTrue(
            "cooling-gas" in Files.readString(
                folder.resolve("a/scenario.json").also {
                    assertDone(daphnis("run", "--live", "cooling-gas", *out))
                },
            ),
        )
        ServerSocket(0).use { taken ->
            val there = folder.resolve("b")
            val refused = daphnis("run", "--live", "${taken.localPort}", "cooling-gas", "--out", "$there")
            // It is taken on all addresses, so the port cannot be had, and no run was begun.
            assertRefused(refused, "--live", "${taken.localPort}")
            assertTrue(!Files.exists(there))
        }
        assertRefused(daphnis("run", "cooling-gas", "--live", "70000", *out), "--live", "70000", "65535")
        assertRefused(daphnis("run", "cooling-gas", "--live=x", *out), "--live", "x")
    }
}
