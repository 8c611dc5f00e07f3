package daphnis.app.live

import daphnis.core.run.RecordedRun
import kotlin.concurrent.thread

/**
 * A page with the states of a recorded run, on a server of its own.
 *
 * @param port to listen on, or 0 for any free one
 * @param framedBy as in [LiveServer]
 */
internal class ViewPage(run: RecordedRun, port: Int, framedBy: String = "'none'") : AutoCloseable {
    private val view = RunView(run)
    private val feed = Feed()
    private val server = LiveServer(port, feed, view, "--port", framedBy = framedBy)

    @Volatile
    private var isClosed = false

    val address: String get() = server.address

    init {
        view.introduce(feed)
        view.renew(feed)
    }

    /** Looks for what is new, while somebody watches, until it is closed or the thread is interrupted. */
    fun serve() {
        while (!isClosed) {
            Thread.sleep(INTERVAL_MILLISECONDS)
            if (feed.isWatched) view.renew(feed)
        }
    }

    override fun close() {
        isClosed = true
        feed.end(Ending(Ending.Kind.CLOSED, "the viewer has ended").json())
        server.close()
    }

    companion object {
        private const val INTERVAL_MILLISECONDS = 1000L

        /** Notebooks of this machine. */
        private const val NOTEBOOKS = "http://localhost:* http://127.0.0.1:* vscode-webview:"

        /** A page for a frame in a notebook, which a thread of its own serves until it is closed. Python calls it. */
        @JvmStatic
        fun inNotebook(run: RecordedRun): ViewPage = ViewPage(run, 0, NOTEBOOKS).apply {
            thread(isDaemon = true, name = "daphnis-view") { serve() }
        }
    }
}
