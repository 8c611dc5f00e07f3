package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import daphnis.app.printing.printLine
import daphnis.cluster.ClusterNode
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.hosts.SlurmList
import daphnis.cluster.settings.ClusterSettings
import daphnis.core.cluster.nodeWork
import daphnis.core.input.InputException
import sun.misc.Signal
import sun.misc.SignalHandler
import java.io.IOException
import java.time.Duration
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

/** `daphnis node`. */
class NodeCommand : CliktCommand(name = "node") {
    private val port by option(
        "--port",
        help = "port to listen on, 0 for any (default: ${ClusterSettings.PORT}; with --join any)",
    ).int()
    private val join by option(
        "--join",
        metavar = "host:port,…",
        help = "processes of the cluster, of which the first begins it (default: the job's nodes under Slurm, or none)",
    )
    private val threads by threadsOption("threads to work with (default: one per core)")
    private val joinWithin by option(
        "--join-within",
        metavar = "seconds",
        help = "end when nobody has answered for so long (default: 60)",
    ).double()
    private val untilInputEnds by option(
        "--until-input-ends",
        help = "for a node that another process has started: print no news, leave Ctrl-C to it, end with the input",
    ).flag()

    private val process by ProcessOptions(null, null)

    override fun help(context: Context) = "Wait for runs over several nodes, and compute a part of each."

    override fun run() {
        val started = AtomicReference<ClusterNode>()
        if (untilInputEnds) {
            leaveKeysToParent()
            thread(isDaemon = true) { endWithInput(started) }
        }
        ClusterNode.start(settings(), nodeWork()) { if (!untilInputEnds) printLine(it) }.use { node ->
            Runtime.getRuntime().addShutdownHook(thread(start = false) { leave(node) })
            started.set(node)
            node.await()
        }
    }

    private fun leave(node: ClusterNode) {
        if (!untilInputEnds) printLine("leaving the cluster")
        node.close()
    }

    private fun settings(): ClusterSettings {
        val slurm = System.getenv(SlurmList.VARIABLE)?.takeIf { join == null }
        val others = join?.let { HostPort.parseList(it, "--join") }
            ?: slurm?.let { list -> SlurmList.hosts(list).map { HostPort(it, port ?: ClusterSettings.PORT) } }
            ?: emptyList()
        return process.settings(
            others,
            hostElse = slurm?.let { System.getenv(SLURM_NAME) },
            port = port ?: if (join == null) ClusterSettings.PORT else null,
            threads = threads,
            joinWithin = joinWithin?.let(::seconds),
        )
    }

    private fun seconds(value: Double): Duration {
        if (value !in 0.0..MOST_SECONDS) {
            throw InputException("--join-within", null, "is $value s; it must be in 0..$MOST_SECONDS s")
        }
        return Duration.ofMillis((value * 1000).toLong())
    }

    /**
     * Ctrl-C, the end of a terminal and that of a job reach all processes of a command. The parent ends its run then,
     * for which it needs its nodes; the end of the input ends them.
     */
    private fun leaveKeysToParent() {
        for (name in listOf("INT", "HUP", "TERM")) {
            try {
                Signal.handle(Signal(name), SignalHandler.SIG_IGN)
            } catch (_: IllegalArgumentException) {
                // There is none with this name here, or the JVM keeps it for itself.
            }
        }
    }

    private fun endWithInput(started: AtomicReference<ClusterNode>) {
        awaitInputEnd()
        endSoon()
        started.get()?.close()
    }

    /** The parent may have been killed, and then nobody answers a node that takes its leave. */
    private fun endSoon() {
        thread(isDaemon = true) {
            Thread.sleep(LEAVE_MILLIS)
            Runtime.getRuntime().halt(0)
        }
    }

    private fun awaitInputEnd() {
        try {
            while (System.`in`.read() >= 0) continue
        } catch (_: IOException) {
            // Nothing can be read any more: the end.
        }
    }

    private companion object {
        const val SLURM_NAME = "SLURMD_NODENAME"
        const val MOST_SECONDS = 1e6
        const val LEAVE_MILLIS = 3000L
    }
}
