package daphnis.cluster.local

import daphnis.cluster.security.Secret
import java.io.IOException
import java.util.concurrent.TimeUnit

/**
 * A node in a JVM of its own on this machine. Its standard input stays open as long as this process lives: its end
 * tells the child to end too, also when this process was killed.
 *
 * @param lines takes what the child prints, line by line, from a thread of the child's own
 * @throws IOException when the process cannot be started
 */
internal class ChildProcess(command: List<String>, secret: Secret, private val lines: (String) -> Unit) {
    private val process = ProcessBuilder(command).redirectErrorStream(true)
        .apply { environment()[Secret.VARIABLE] = secret.text }
        .start()

    // Before the thread that writes it, which begins at once.
    @Volatile
    private var latest = ""
    private val reader = Thread(::read, "daphnis-child-${process.pid()}").apply {
        isDaemon = true
        start()
    }

    val pid: Long get() = process.pid()

    val isAlive: Boolean get() = process.isAlive

    /** How it ended, in words. */
    val ending: String
        get() {
            reader.join(MILLIS)
            val said = if (latest.isEmpty()) "" else ": $latest"
            return "the node of process $pid has ended with code ${process.exitValue()}$said"
        }

    /** Tells the child to end. */
    fun release() {
        try {
            process.outputStream.close()
        } catch (_: IOException) {
            // It has ended already.
        }
    }

    /** Waits for its end, and then makes it end; its last lines are told before this returns. */
    fun end() {
        if (!process.waitFor(SECONDS, TimeUnit.SECONDS)) process.destroyForcibly().waitFor(SECONDS, TimeUnit.SECONDS)
        reader.join(MILLIS)
    }

    private fun read() {
        try {
            process.inputStream.bufferedReader().forEachLine {
                latest = it
                lines("process $pid: $it")
            }
        } catch (_: IOException) {
            // The process has ended.
        }
    }

    private companion object {
        const val SECONDS = 10L
        const val MILLIS = 5000L
    }
}
