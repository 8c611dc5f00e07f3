package daphnis.app.live

import daphnis.core.input.InputException
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.io.IOException
import java.net.InetAddress
import java.net.Socket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.net.http.HttpResponse.BodyHandlers
import java.util.stream.Stream
import kotlin.time.Duration.Companion.hours

@Timeout(30)
class LiveServerTest {
    private val feed = Feed()
    private val newest = NewestState()
    private val server = LiveServer(0, feed, newest)
    private val client = HttpClient.newHttpClient()

    @AfterEach
    fun stop(): Unit = server.close()

    private fun request(path: String, of: LiveServer = server) = HttpRequest.newBuilder(URI.create(of.address + path))

    private fun get(path: String, of: LiveServer = server) =
        client.send(request(path, of).build(), BodyHandlers.ofString())

    private fun events(): HttpResponse<Stream<String>> = client.send(request("events").build(), BodyHandlers.ofLines())

    /** The status of an answer to [head], word by word as a client may send it. */
    private fun statusOf(vararg head: String): Int = Socket(InetAddress.getLoopbackAddress(), server.port).use {
        it.soTimeout = 10_000
        it.getOutputStream().write((head.joinToString("\r\n") + "\r\n\r\n").toByteArray())
        (it.getInputStream().bufferedReader().readLine() ?: throw IOException("no answer")).split(' ')[1].toInt()
    }

    private val host get() = "Host: 127.0.0.1:${server.port}"

    @Test
    fun `the page and its parts are served, and nothing from elsewhere is in them`() {
        for ((path, type) in listOf("" to "text/html", "page.css" to "text/css") + scripts) {
            val answer = get(path)
            assertEquals(200, answer.statusCode())
            assertTrue(answer.headers().firstValue("Content-Type").get().startsWith(type))
            assertTrue("default-src 'none'" in answer.headers().firstValue("Content-Security-Policy").get())
            assertTrue("http" !in answer.body()) { path }
            // What a part takes from others is served too.
            for (other in Regex("(?:from|src=|href=) ?\"(?:\\./)?(\\w+\\.\\w+)\"").findAll(answer.body())) {
                assertEquals(200, get(other.groupValues[1]).statusCode()) { other.value }
            }
        }
    }

    private val scripts = listOf(
        "page", "player", "states", "stage", "camera", "gestures", "colours", "density", "drawing", "shaders",
    ).map { "$it.js" to "text/javascript" }

    @Test
    fun `a state is had by its number, and only the newest of a run that goes on`() {
        assertEquals(204, get("state/0").statusCode())
        newest.put(7, byteArrayOf(1, 2, 3))
        val request = request("state/7").build()
        val answer = client.send(request, BodyHandlers.ofByteArray())
        assertEquals(listOf<Byte>(1, 2, 3), answer.body().asList())
        assertEquals("application/octet-stream", answer.headers().firstValue("Content-Type").get())
        newest.put(8, byteArrayOf(4))
        // No error, which browsers would show: it has been told of, and another one has taken its place.
        assertEquals(204, get("state/7").statusCode())
        val wrongs =
            listOf("", "08", "+8", "-8", "8/", "8.0", "1e1", "x", "8%00", "9999999999999999999", "../page.js", "٨")
        for (wrong in wrongs) {
            val path = "/state/" + java.net.URLEncoder.encode(wrong, Charsets.UTF_8).replace("%25", "%")
            assertEquals(404, statusOf("GET $path HTTP/1.1", host)) { wrong }
        }
        assertEquals(405, statusOf("POST /state/8 HTTP/1.1", host, "Content-Length: 0"))
        assertEquals(403, statusOf("GET /state/8 HTTP/1.1", "Host: evil.example:${server.port}"))
        assertEquals(403, statusOf("GET /state/8 HTTP/1.1", host, "Sec-Fetch-Site: cross-site"))
        assertEquals(200, statusOf("GET /state/8 HTTP/1.1", host, "Sec-Fetch-Site: same-origin"))
    }

    @Tag("thorough")
    @Test
    fun `who does not read a state is dropped, and until then keeps it from a few at most`() {
        val large = ByteArray(32_000_000)
        LiveServer(0, feed, { large }, sendMilliseconds = 1500).use { server ->
            val silent = List(4) {
                Socket(InetAddress.getLoopbackAddress(), server.port).apply {
                    soTimeout = 20_000
                    getOutputStream().write(
                        "GET /state/1 HTTP/1.1\r\nHost: localhost:${server.port}\r\n\r\n".toByteArray(),
                    )
                    assertEquals('H'.code, getInputStream().read())
                }
            }
            val address = URI.create("${server.address}state/1")
            fun status() = client.send(HttpRequest.newBuilder(address).build(), BodyHandlers.discarding()).statusCode()
            assertEquals(503, status())
            val page = URI.create(server.address)
            assertEquals(200, client.send(HttpRequest.newBuilder(page).build(), BodyHandlers.discarding()).statusCode())
            assertTrue((1..200).any { Thread.sleep(50).let { runCatching { status() }.getOrNull() == 200 } })
            for (socket in silent) {
                // What is under way comes, and then the end, before all of it.
                val read = try {
                    socket.getInputStream().readAllBytes().size
                } catch (e: IOException) {
                    0
                }
                assertTrue(read < large.size) { "$read" }
                socket.close()
            }
        }
    }

    @Test
    fun `pages that draw states get no pictures, and others no word of states`() {
        feed.put(Feed.PICTURE, "p")
        feed.put(Feed.STATE, "s")
        feed.put(Feed.PROGRESS, "w")
        assertTrue(!feed.wants(Feed.STATE) && !feed.wants(Feed.PICTURE))
        val drawn = client.send(request("changes").build(), BodyHandlers.ofLines()).body().iterator()
        assertEquals("event: state", drawn.next())
        assertTrue(feed.wants(Feed.STATE) && !feed.wants(Feed.PICTURE))
        val shown = events().body().iterator()
        assertEquals("event: picture", shown.next())
        assertTrue(feed.wants(Feed.STATE) && feed.wants(Feed.PICTURE))
        feed.end("done")
        assertEquals(listOf("event: progress", "event: end"), drawn.asSequence().filter { "event" in it }.toList())
        assertEquals(listOf("event: progress", "event: end"), shown.asSequence().filter { "event" in it }.toList())
    }

    @Test
    fun `a state that is asked for is sent whole before the server ends`() {
        val large = ByteArray(16_000_000) { it.toByte() }
        val server = LiveServer(0, Feed(), { large })
        val request = HttpRequest.newBuilder(URI.create("${server.address}state/1")).build()
        client.send(request, BodyHandlers.ofInputStream()).body().use { body ->
            val first = body.read()
            val closing = kotlin.concurrent.thread { server.close() }
            assertEquals(large.size - 1, body.readAllBytes().size)
            assertEquals(0, first)
            closing.join()
        }
    }

    @Test
    fun `the last state is waited for until all pages have it`() {
        newest.put(3, byteArrayOf(1))
        val begin = System.nanoTime()
        fun seconds() = (System.nanoTime() - begin) * 1e-9
        newest.awaitAsked(0, 20_000)
        get("state/3")
        newest.awaitAsked(1, 20_000)
        assertTrue(seconds() < 10)
        val second = kotlin.concurrent.thread {
            Thread.sleep(600)
            get("state/3")
        }
        newest.awaitAsked(2, 20_000)
        assertTrue(seconds() in 0.55..15.0) { "${seconds()}" }
        second.join()
    }

    @Tag("thorough")
    @Test
    fun `a page that has been sent is waited for until it looks`() {
        val patient = Feed(longestArrival = 1.hours)
        LiveServer(0, patient).use { server ->
            assertTrue(!patient.isWatched)
            assertEquals(200, get("", server).statusCode())
            assertTrue(patient.isWatched && patient.wants(Feed.STATE))
            val late = kotlin.concurrent.thread {
                Thread.sleep(100)
                client.send(request("changes", server).build(), BodyHandlers.ofLines())
            }
            patient.awaitArrival()
            assertEquals(1, patient.watching(Feed.STATE))
            late.join()
        }
    }

    @Tag("thorough")
    @Test
    fun `a page that has been sent and does not come is waited for no longer than two seconds`() {
        val begin = System.nanoTime()
        assertEquals(200, get("").statusCode())
        feed.awaitArrival()
        assertTrue((System.nanoTime() - begin) * 1e-9 >= 2)
        assertTrue(!feed.isWatched)
    }

    @Tag("thorough")
    @Test
    fun `who does not finish a request keeps nobody out for long`() {
        val silent = List(150) {
            Socket(InetAddress.getLoopbackAddress(), server.port).apply {
                getOutputStream().write("GET / HTTP/1.1\r\nHost:".toByteArray())
            }
        }
        try {
            fun isAnswered() = try {
                statusOf("GET / HTTP/1.1", host) == 200
            } catch (_: IOException) {
                Thread.sleep(100)
                false
            }
            assertTrue((1..100).any { isAnswered() })
            val first = silent.first()
            first.soTimeout = 20_000
            assertEquals(-1, first.getInputStream().read())
        } finally {
            for (socket in silent) socket.close()
        }
    }

    @Test
    fun `events come as they are put, the latest of a kind, until the end`() {
        feed.put("picture", "old")
        feed.put("picture", "new\nin two lines")
        val lines = events().body().iterator()
        assertEquals(listOf("event: picture", "data: new", "data: in two lines", ""), List(4) { lines.next() })
        assertTrue(feed.isWatched)
        feed.put("progress", "half")
        assertEquals(listOf("event: progress", "data: half", ""), List(3) { lines.next() })
        feed.end("done")
        feed.put("progress", "too late")
        assertEquals(listOf("event: end", "data: done", ""), List(3) { lines.next() })
        assertTrue(!lines.hasNext())
        feed.awaitNobody(5000)
        assertTrue(!feed.isWatched)
    }

    @Tag("thorough")
    @Test
    fun `a server that is closed at once has written the end of what is read`() {
        repeat(200) { k ->
            val feed = Feed()
            LiveServer(0, feed).use { server ->
                val request = HttpRequest.newBuilder(URI.create(server.address + "events")).build()
                val lines = client.send(request, BodyHandlers.ofLines()).body()
                feed.end("$k")
                server.close()
                assertEquals(listOf("event: end", "data: $k", ""), lines.toList())
            }
        }
    }

    @Test
    fun `who goes away is no longer counted`() {
        Socket(InetAddress.getLoopbackAddress(), server.port).use {
            it.getOutputStream().write("GET /events HTTP/1.1\r\n$host\r\n\r\n".toByteArray())
            assertTrue("200" in it.getInputStream().bufferedReader().readLine())
            assertTrue(feed.isWatched)
        }
        // Found out at a write: a heartbeat, or what is put.
        repeat(1000) {
            if (!feed.isWatched) return
            feed.put("progress", "$it")
            Thread.sleep(10)
        }
        throw AssertionError("still watched")
    }

    @Test
    fun `other names for this machine, other methods and other paths are refused`() {
        assertEquals(200, statusOf("GET / HTTP/1.1", host))
        assertEquals(200, statusOf("GET / HTTP/1.1", "Host: localhost:${server.port}"))
        assertEquals(403, statusOf("GET / HTTP/1.1", "Host: evil.example:${server.port}"))
        assertEquals(403, statusOf("GET / HTTP/1.1", "Host: 127.0.0.1"))
        assertEquals(403, statusOf("GET /events HTTP/1.0"))
        assertEquals(403, statusOf("GET / HTTP/1.1", host, "Host: evil.example"))
        for (method in listOf("POST", "PUT", "DELETE", "HEAD", "OPTIONS")) {
            assertEquals(405, statusOf("$method / HTTP/1.1", host, "Content-Length: 0")) { method }
        }
        for (path in listOf(
            "/../page.js",
            "/%2e%2e/page.js",
            "/page.html",
            "/etc/passwd",
            "/page.js/",
            "/events/",
        )) {
            assertEquals(404, statusOf("GET $path HTTP/1.1", host)) { path }
        }
        assertEquals(400, statusOf("GET // HTTP/1.1", host))
    }

    @Test
    fun `another site in the same browser gets no events`() {
        assertEquals(403, statusOf("GET /events HTTP/1.1", host, "Sec-Fetch-Site: cross-site"))
        assertTrue(!feed.isWatched)
    }

    @Test
    fun `only so many may look`() {
        val open = List(8) { events() }
        assertEquals(503, get("events").statusCode())
        assertEquals(200, get("").statusCode())
        feed.end("done")
        open.forEach { it.body().close() }
    }

    @Test
    fun `it listens on this machine alone, and a port that is taken is told in words`() {
        val elsewhere = java.net.NetworkInterface.networkInterfaces().flatMap { it.inetAddresses() }
            .filter { !it.isLoopbackAddress && it is java.net.Inet4Address }.findFirst()
        if (elsewhere.isPresent) {
            assertThrows(java.io.IOException::class.java) { Socket(elsewhere.get(), server.port).close() }
        }
        val refusal = assertThrows(InputException::class.java) { LiveServer(server.port, Feed()) }
        assertTrue("${server.port} cannot be had" in refusal.message!!) { refusal.message!! }
    }
}
