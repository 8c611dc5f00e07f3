package daphnis.app.live

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.util.concurrent.Executors
import java.util.concurrent.Semaphore
import java.util.concurrent.SynchronousQueue
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * Serves a page that shows what is in [feed] as it comes, by server-sent events, and [states] when they are asked for,
 * to programs of this machine.
 *
 * It listens on the loopback address only. A page of somebody else's in the same browser reaches that too, so requests
 * must name this server as their `Host` (a name which is made to resolve to 127.0.0.1 does not), and events and states
 * are not for other sites. What can be asked for is a fixed list, by GET, and states by number; no file is looked up by
 * the name that is asked for. A request that does not come to its end within seconds is dropped, and who does not read
 * a megabyte of a state within [sendMilliseconds] gets no more of it, so that nobody keeps a thread or a state's memory
 * for long.
 *
 * @param port to listen on, or 0 for any free one
 * @param option of the command line that gave it
 * @param framedBy what may show the page in a frame of its own, in the words of a Content-Security-Policy
 * @throws InputException when the port cannot be had
 */
internal class LiveServer(
    port: Int,
    private val feed: Feed,
    private val states: StateSource = StateSource.NONE,
    option: String = "--live",
    private val sendMilliseconds: Long = 60_000,
    private val framedBy: String = "'none'",
) : AutoCloseable {
    private val server = try {
        if (System.getProperty(REQUEST_LIMIT) == null) System.setProperty(REQUEST_LIMIT, "$REQUEST_SECONDS")
        HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0)
    } catch (e: IOException) {
        val mend = "without a number a free port is chosen"
        throw InputException(option, null, "port $port cannot be had: ${reasonOf(e)}; $mend")
    }

    /** Above the most watchers there is room for what is answered at once, and for who is slow to ask. */
    private val threads = ThreadPoolExecutor(0, MOST_THREADS, 1, TimeUnit.SECONDS, SynchronousQueue()) { work ->
        Thread(work, "daphnis-live").apply { isDaemon = true }
    }

    /** Who is sent a state has one. */
    private val senders = Semaphore(MOST_SENDERS)
    private val clock = Executors.newSingleThreadScheduledExecutor { work ->
        Thread(work, "daphnis-live-clock").apply { isDaemon = true }
    }

    val port: Int get() = server.address.port

    /** Where the page is. */
    val address: String = "http://${InetAddress.getLoopbackAddress().hostAddress.bracketed()}:${server.address.port}/"
    private val hosts = listOf("localhost", "127.0.0.1", "[::1]").map { "$it:${server.address.port}" }

    init {
        server.createContext("/") { exchange -> exchange.use(::answer) }
        server.executor = threads
        // Its own thread takes after the one that starts it. A program of another language that ends with an open page,
        // as Python does in which nobody closed it, waits for all threads but daemons.
        thread(isDaemon = true) { server.start() }.join()
    }

    private fun answer(exchange: HttpExchange) {
        val path = exchange.requestURI.path
        val page = PAGES[path]
        when {
            exchange.requestHeaders["Host"]?.singleOrNull()?.lowercase() !in hosts -> refuse(exchange, 403)
            exchange.requestMethod != "GET" -> {
                exchange.responseHeaders["Allow"] = "GET"
                refuse(exchange, 405)
            }
            page != null -> {
                feed.expect()
                send(exchange, page)
            }
            path != EVENTS && path != CHANGES && stateOf(path) == null -> refuse(exchange, 404)
            exchange.requestHeaders.getFirst("Sec-Fetch-Site") !in OWN_SITE -> refuse(exchange, 403)
            path == EVENTS -> watch(exchange, Feed.STATE)
            path == CHANGES -> watch(exchange, Feed.PICTURE)
            else -> sendState(exchange, stateOf(path)!!)
        }
    }

    /** The number of the state at [path]: digits and nothing else, without zeros before them. */
    private fun stateOf(path: String): Long? {
        val word = path.removePrefix(STATE).takeIf { it != path } ?: return null
        return word.toLongOrNull()?.takeIf { it >= 0 && "$it" == word }
    }

    private fun watch(exchange: HttpExchange, without: String): Unit =
        feed.watch(MOST_WATCHERS, without)?.use { stream(exchange, it) } ?: refuse(exchange, 503)

    private fun sendState(exchange: HttpExchange, number: Long) {
        if (!senders.tryAcquire()) return refuse(exchange, 503)
        try {
            send(exchange, number)
        } finally {
            senders.release()
        }
    }

    private fun send(exchange: HttpExchange, number: Long) {
        val bytes = try {
            // Another one has taken its place since it was told of: no error of who asks.
            states.bytes(number) ?: return refuse(exchange, 204)
        } catch (e: Exception) {
            return sendProblem(exchange, e)
        } catch (e: OutOfMemoryError) {
            return sendProblem(exchange, e)
        }
        head(exchange, "application/octet-stream")
        exchange.sendResponseHeaders(200, bytes.size.toLong())
        for (from in bytes.indices step PIECE) {
            inTime { exchange.responseBody.write(bytes, from, minOf(PIECE, bytes.size - from)) }
        }
    }

    /** [write], whose connection is closed when it takes too long. */
    private fun inTime(write: () -> Unit) {
        val deadline = Deadline(Thread.currentThread())
        val late = clock.schedule(deadline, sendMilliseconds, TimeUnit.MILLISECONDS)
        try {
            write()
        } finally {
            late.cancel(false)
            deadline.end()
        }
    }

    private fun sendProblem(exchange: HttpExchange, e: Throwable) {
        val words = inWords(e).toByteArray()
        head(exchange, "text/plain; charset=utf-8")
        exchange.sendResponseHeaders(500, words.size.toLong())
        exchange.responseBody.write(words)
    }

    /** Interrupts a [writer], whose connection that closes, unless it has come to its end before. */
    private class Deadline(private val writer: Thread) : Runnable {
        private var isOver = false

        @Synchronized
        override fun run() {
            if (!isOver) writer.interrupt()
        }

        /** On the writer's thread, which works on for others. */
        @Synchronized
        fun end() {
            isOver = true
            Thread.interrupted()
        }
    }

    private fun refuse(exchange: HttpExchange, code: Int): Unit = exchange.sendResponseHeaders(code, NO_BODY)

    private fun send(exchange: HttpExchange, page: Page) {
        head(exchange, page.type)
        exchange.sendResponseHeaders(200, page.bytes.size.toLong())
        exchange.responseBody.write(page.bytes)
    }

    private fun head(exchange: HttpExchange, type: String) {
        exchange.responseHeaders["Content-Type"] = type
        exchange.responseHeaders["Cache-Control"] = "no-store"
        exchange.responseHeaders["X-Content-Type-Options"] = "nosniff"
        exchange.responseHeaders["Cross-Origin-Resource-Policy"] = "same-origin"
        exchange.responseHeaders["Content-Security-Policy"] =
            "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; " +
            "frame-ancestors $framedBy; base-uri 'none'; form-action 'none'"
    }

    /** Until the run ends, or nobody reads any more: then a write fails. */
    private fun stream(exchange: HttpExchange, watcher: Feed.Watcher) {
        head(exchange, "text/event-stream; charset=utf-8")
        exchange.sendResponseHeaders(200, 0)
        val out = exchange.responseBody
        // In newer Javas, 25 among them, the head waits for what comes behind it.
        out.flush()
        while (true) {
            val entries = watcher.next(HEARTBEAT_MILLISECONDS)
            // A comment, which shows whether somebody is still there.
            if (entries.isEmpty()) out.write(":\n\n".toByteArray())
            for (entry in entries) {
                val data = entry.text.lines().joinToString("") { "data: $it\n" }
                out.write("event: ${entry.kind}\n$data\n".toByteArray())
            }
            out.flush()
            if (entries.any { it.kind == Feed.END }) {
                // While it still counts as watching: the server stops when nobody does, and the end has to be written.
                out.close()
                return
            }
        }
    }

    /**
     * Ends when those who look have been told how the run ended and have the state they asked for, or soon if they do
     * not listen.
     */
    override fun close() {
        feed.awaitNobody(PATIENCE_MILLISECONDS)
        val isIdle = senders.tryAcquire(MOST_SENDERS, SENDING_MILLISECONDS, TimeUnit.MILLISECONDS)
        if (isIdle) senders.release(MOST_SENDERS)
        server.stop(0)
        threads.shutdownNow()
        clock.shutdownNow()
    }

    private class Page(val type: String, name: String) {
        val bytes: ByteArray = LiveServer::class.java.getResourceAsStream(name)!!.use { it.readBytes() }
    }

    private companion object {
        const val EVENTS = "/events"

        /** The same for pages that draw states themselves, which come in place of pictures. */
        const val CHANGES = "/changes"
        const val STATE = "/state/"
        const val NO_BODY = -1L
        const val MOST_WATCHERS = 8
        const val MOST_THREADS = 64
        const val MOST_SENDERS = 4
        const val PIECE = 1_000_000
        const val SENDING_MILLISECONDS = 10_000L

        /** How long Java's server, which has no other way to be told, waits for the whole of a request. */
        const val REQUEST_LIMIT = "sun.net.httpserver.maxReqTime"
        const val REQUEST_SECONDS = 2
        const val HEARTBEAT_MILLISECONDS = 3000L
        const val PATIENCE_MILLISECONDS = 2000L

        /** Programs that are no browsers do not say. */
        val OWN_SITE = setOf(null, "same-origin")
        val MODULES = listOf(
            "page", "player", "states", "stage", "camera", "gestures", "colours", "density", "drawing", "shaders",
        )
        val PAGES = mapOf(
            "/" to Page("text/html; charset=utf-8", "page.html"),
            "/page.css" to Page("text/css; charset=utf-8", "page.css"),
        ) + MODULES.associate { "/$it.js" to Page("text/javascript; charset=utf-8", "$it.js") }

        fun String.bracketed() = if (':' in this) "[$this]" else this
    }
}

/** Closes what is answered, whatever happens; who went away in between is nobody's fault. */
private fun HttpExchange.use(answer: (HttpExchange) -> Unit) {
    try {
        answer(this)
    } catch (e: IOException) {
        return
    } catch (e: InterruptedException) {
        return
    } finally {
        close()
    }
}
