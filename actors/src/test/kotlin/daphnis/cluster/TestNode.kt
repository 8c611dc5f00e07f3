package daphnis.cluster

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import daphnis.core.cluster.FleetException
import java.nio.file.Path
import kotlin.concurrent.thread
import kotlin.system.exitProcess

/** A node that sends messages around, in a process of its own: joins the address and reads the settings it is given. */
internal object TestNode {
    @JvmStatic
    fun main(args: Array<String>) {
        val settings = ClusterSettings(
            join = listOf(HostPort.parse(args[0], "join")),
            secret = Secret.ofEnvironment(),
            config = Path.of(args[1]),
            threads = 1,
        )
        try {
            val node = ClusterNode.start(settings, Echo) { println(it) }
            thread(isDaemon = true) {
                while (System.`in`.read() >= 0) continue
                node.close()
            }
            node.await()
        } catch (e: FleetException) {
            println("daphnis: ${e.message}")
            exitProcess(1)
        }
    }
}
