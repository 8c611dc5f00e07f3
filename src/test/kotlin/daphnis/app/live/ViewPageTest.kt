package daphnis.app.live

import daphnis.app.assertDone
import daphnis.app.assertRefused
import daphnis.app.daphnis
import daphnis.core.run.Run
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.net.ServerSocket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse.BodyHandlers
import java.nio.file.Files
import java.nio.file.Path
import kotlin.concurrent.thread

@Timeout(120)
class ViewPageTest {
    @TempDir
    lateinit var folder: Path

    private val client = HttpClient.newHttpClient()

    private fun get(address: String) =
        client.send(HttpRequest.newBuilder(URI.create(address)).build(), BodyHandlers.ofByteArray())

    private fun run(vararg words: String): Path {
        val path = folder.resolve("run")
        assertDone(daphnis("run", "--set", "output.snapshotEvery=2", *words, "--out", "$path", "--quiet"))
        return path
    }

    /** The first events of each kind at [address], while [enough] does not hold. */
    private fun events(address: String, enough: (Map<String, String>) -> Boolean): Map<String, String> {
        val seen = LinkedHashMap<String, String>()
        var kind = ""
        val request = HttpRequest.newBuilder(URI.create("${address}changes")).build()
        client.send(request, BodyHandlers.ofLines()).body().use { lines ->
            for (line in lines) {
                if (line.startsWith("event: ")) kind = line.removePrefix("event: ")
                if (line.startsWith("data: ")) seen[kind] = line.removePrefix("data: ")
                if (enough(seen)) break
            }
        }
        return seen
    }

    @Test
    fun `all states of a run are there with its series, and new ones as they come`() {
        val path = run("cooling-gas", "--steps", "4")
        ViewPage(Run.open(path), 0).use { page ->
            val server = thread {
                try {
                    page.serve()
                } catch (e: InterruptedException) {
                    return@thread
                }
            }
            val told = events(page.address) { "series" in it && "states" in it }
            assertTrue("cooling-gas" in told.getValue("run") && "\"isRecorded\": true" in told.getValue("run"))
            assertTrue("[0, 2, 4]" in told.getValue("states") && "complete" in told.getValue("states")) { "$told" }
            assertTrue(told.getValue("series").startsWith("data:image/svg+xml;base64,"))
            for (state in Run.open(path).states()) {
                val seen = DecodedState(get("${page.address}state/${state.step}").body())
                assertEquals(2000, seen.count)
                for (axis in 0..2) {
                    for (k in 0 until 2000) {
                        assertEquals(
                            state.position[axis][k],
                            seen.columns[axis][k].toDouble(),
                            1e-6,
                        )
                    }
                }
                assertEquals(
                    "t = ${String.format(java.util.Locale.ROOT, "%.4g", state.time)} units of time",
                    seen.text("time"),
                )
            }
            assertEquals(204, get("${page.address}state/3").statusCode())
            val snapshots = path.resolve("snapshots")
            Files.copy(snapshots.resolve("0000000002.h5"), snapshots.resolve("0000000003.h5"))
            val later = events(page.address) { "[0, 2, 3, 4]" in it["states"].orEmpty() }
            assertTrue("states" in later)
            // It says that it is another state than its name tells.
            val damaged = get("${page.address}state/3")
            assertEquals(500, damaged.statusCode())
            assertTrue("holds the state after step 2" in damaged.body().decodeToString())
            server.interrupt()
            server.join()
        }
    }

    @Test
    fun `the command prints where the page is, and serves it until it is stopped`() {
        val path = run("hard-discs", "--set", "until=1", "--set", "output.snapshotEvery=2")
        val before = Files.readAllBytes(path.resolve("summary.json"))
        val port = ServerSocket(0).use { it.localPort }
        var out = ""
        val viewer = thread { out = assertDone(daphnis("view", "$path", "--port", "$port")) }
        val told = (1..400).firstNotNullOf {
            Thread.sleep(25)
            runCatching { DecodedState(get("http://127.0.0.1:$port/state/2").body()) }.getOrNull()
        }
        assertEquals("2", told.text("dimensions"))
        assertTrue("3600 discs" in told.text("about"))
        viewer.interrupt()
        viewer.join()
        assertTrue("view: http://127.0.0.1:$port/" in out) { out }
        assertArrayEquals(before, Files.readAllBytes(path.resolve("summary.json")))
    }

    @Test
    fun `only a page for a notebook may be framed, by pages of this machine, and ends when it is closed`() {
        fun policy(page: ViewPage) = get(page.address).headers().firstValue("Content-Security-Policy").get()
        val recorded = Run.open(run("cooling-gas", "--steps", "2"))
        ViewPage(recorded, 0).use { assertTrue("frame-ancestors 'none';" in policy(it)) { policy(it) } }
        val page = ViewPage.inNotebook(recorded)
        page.use {
            assertTrue("frame-ancestors http://localhost:* http://127.0.0.1:* vscode-webview:;" in policy(it)) {
                policy(it)
            }
            assertEquals(200, get("${it.address}state/2").statusCode())
        }
        assertThrows(java.io.IOException::class.java) { get(page.address) }
    }

    @Test
    fun `what is no run, has no states or cannot be served is refused in a line`() {
        assertRefused(daphnis("view", "$folder"), "$folder", "no run directory")
        assertRefused(daphnis("view", "${folder.resolve("nothing")}"), "nothing", "no such file")
        val path = run("cooling-gas", "--steps", "2")
        assertRefused(daphnis("view", "$path", "--port", "70000"), "--port", "70000", "65535")
        ServerSocket(0).use { taken ->
            assertRefused(daphnis("view", "$path", "--port", "${taken.localPort}"), "--port", "${taken.localPort}")
        }
        path.resolve("snapshots").toFile().deleteRecursively()
        Files.list(path).use { files ->
            files.filter { it.fileName.toString().startsWith("checkpoint") }.toList().forEach(Files::delete)
        }
        assertRefused(daphnis("view", "$path"), "$path", "no state")
    }
}
