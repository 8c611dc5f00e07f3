package daphnis.app.live

import daphnis.core.run.RecordedRun

/**
 * A page with the states of a recorded run, on a server of its own.
 *
 * @param port to listen on, or 0 for any free one
 */
internal class ViewPage(run: RecordedRun, port: Int) : AutoCloseable {
    private val view = RunView(run)
    private val feed = Feed()
    private val server = LiveServer(port, feed, view, "--port")

    val address: String get() = server.address

    init {
        view.introduce(feed)
        view.renew(feed)
    }

    /** Looks for what is new, while somebody watches, until the thread is interrupted. */
    fun serve() {
        while (true) {
            Thread.sleep(INTERVAL_MILLISECONDS)
            if (feed.isWatched) view.renew(feed)
        }
    }

    override fun close() {
        feed.end("the viewer has ended")
        server.close()
    }

    private companion object {
        const val INTERVAL_MILLISECONDS = 1000L
    }
}
