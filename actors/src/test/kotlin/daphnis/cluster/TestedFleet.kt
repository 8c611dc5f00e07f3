package daphnis.cluster

import daphnis.cluster.desk.Greeter
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import daphnis.cluster.system.Protocol
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.NodeWork
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CopyOnWriteArrayList

/** Nodes and leaders in this JVM that notice the loss of one another soon. */
internal class TestedFleet(private val folder: Path, private val secret: Secret = SECRET) : AutoCloseable {
    /** What all processes have told the user. */
    val lines = ConcurrentLinkedQueue<String>()
    private val parts = CopyOnWriteArrayList<AutoCloseable>()
    private val joined = CopyOnWriteArrayList<HostPort>()

    fun settings(join: List<HostPort> = joined.take(1)) = ClusterSettings(
        join = join,
        threads = 2,
        secret = secret,
        config = quick(folder),
        joinWithin = Duration.ofSeconds(60),
    )

    fun node(
        work: NodeWork = Echo,
        settings: ClusterSettings = settings(),
        build: Greeter.Build = Protocol.build,
    ): ClusterNode {
        val node = ClusterNode.start(settings, work, build) { lines += it }
        joined += node.address
        return node.also { parts += it }
    }

    fun leader(
        run: String = "test",
        settings: ClusterSettings = settings(),
        build: Greeter.Build = Protocol.build,
    ): ClusterFleet = ClusterFleet.join(settings, run, build) { lines += it }.also { parts += it }

    override fun close() {
        parts.reversed().map { part -> Thread(part::close).apply { start() } }.forEach(Thread::join)
    }

    companion object {
        val SECRET = Secret.of("a secret of the tests", "test")

        /** Waits until [fleet] has [count] nodes; those that it had then. A busy machine may hide one for a moment. */
        fun await(fleet: Fleet, count: Int): List<FleetNode> {
            lateinit var nodes: List<FleetNode>
            awaitThat("$count nodes") {
                nodes = fleet.nodes()
                nodes.size == count
            }
            return nodes
        }

        fun awaitThat(what: String, seconds: Int = 90, condition: () -> Boolean) {
            val end = System.nanoTime() + seconds * 1_000_000_000L
            while (!condition()) {
                check(System.nanoTime() < end) { "no $what after $seconds s" }
                Thread.sleep(5)
            }
        }

        fun quick(folder: Path): Path = folder.resolve("quick.conf").also {
            Files.writeString(
                it,
                """
                daphnis.cluster { heartbeat = 200 ms, acceptable-pause = 3 s, stable-after = 2 s }
                """.trimIndent(),
            )
        }
    }
}
