package daphnis.app.live

import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.run.Run
import kotlinx.serialization.json.JsonPrimitive

/** The live page of a run: from before it starts, so that a port that is taken is told at once, until it has ended. */
internal class LivePage(port: Int) : AutoCloseable {
    private val feed = Feed()
    private val newest = NewestState()
    private val server = LiveServer(port, feed, newest)
    private var output: LiveOutput? = null
    private var ending = Ending(Ending.Kind.FAILED, "ended before the run had begun")

    val address: String get() = server.address

    /** [usual], and what the page needs of [run]. */
    fun watching(run: Run, usual: Output): Output {
        val name = run.scenario?.name ?: "${run.directory.path.fileName}"
        feed.put(
            Feed.RUN,
            "{\"name\": ${JsonPrimitive(name)}, \"directory\": ${JsonPrimitive("${run.directory.path}")}}",
        )
        val live = LiveOutput(run, feed, newest)
        output = live
        return Both(usual, live)
    }

    /** What the page says at the end, of [kind]. */
    fun endsWith(kind: Ending.Kind, words: String) {
        ending = Ending(kind, words)
    }

    /** Shows the state at which the run stands, with all that is in its files: when it has ended, and before it closes. */
    fun showLast() {
        output?.showLast()
    }

    override fun close() {
        feed.awaitArrival()
        // Who has been told of the end is no longer counted.
        val watching = feed.watching(Feed.STATE)
        feed.end(ending.json())
        // The last state is looked at longest: each page gets it.
        newest.awaitAsked(watching, PATIENCE_MILLISECONDS)
        server.close()
    }

    private companion object {
        const val PATIENCE_MILLISECONDS = 2000L
    }

    /** Calls [first] and then [second], each opened by itself. */
    private class Both(private val first: Output, private val second: Output) : Output {
        override fun open(simulation: Simulation, opening: Opening) {
            first.open(simulation, opening)
            second.open(simulation, opening)
        }

        override fun write(simulation: Simulation) {
            first.write(simulation)
            second.write(simulation)
        }

        override fun finish(simulation: Simulation) {
            first.finish(simulation)
            second.finish(simulation)
        }

        override fun close() {
            first.close()
            second.close()
        }
    }
}
