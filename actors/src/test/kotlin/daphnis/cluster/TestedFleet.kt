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

/** Nodes and leaders in this JVM that notice the loss of one another soon. */
internal class TestedFleet(private val folder: Path, private val secret: Secret = SECRET) : AutoCloseable {
    /** What all processes have told the user. */
    val lines = ConcurrentLinkedQueue<String>()
    private val parts = ArrayList<AutoCloseable>()
    private val joined = ArrayList<HostPort>()

    fun settings(join: List<HostPort> = joined.take(1)) = ClusterSettings(
        join = join,
        threads = 2,
        secret = secret,
        config = quick(folder),
        joinWithin = Duration.ofSeconds(20),
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

        /** Waits until [fleet] has [count] nodes. */
        fun await(fleet: Fleet, count: Int): List<FleetNode> {
            awaitThat("$count nodes") { fleet.nodes().size == count }
            return fleet.nodes()
        }

        fun awaitThat(what: String, seconds: Int = 20, condition: () -> Boolean) {
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
                daphnis.cluster { heartbeat = 200 ms, acceptable-pause = 2 s, stable-after = 1 s }
                """.trimIndent(),
            )
        }
    }
}
