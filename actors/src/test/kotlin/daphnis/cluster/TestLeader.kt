package daphnis.cluster

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.settings.ClusterSettings
import daphnis.core.cluster.MailClosedException
import daphnis.core.cluster.NodesAwaited
import java.nio.file.Path
import java.time.Duration

/** A leader in a process of its own: has its node send a message around until that fails, and again with a new crew. */
internal object TestLeader {
    @JvmStatic
    fun main(args: Array<String>) {
        val settings = ClusterSettings(
            join = HostPort.parseList(args[0], "join"),
            secret = TestedFleet.SECRET,
            config = Path.of(args[1]),
        )
        val fleet = ClusterFleet.join(settings, "stopped") { println(it) }
        val awaited = NodesAwaited(fleet, Duration.ofSeconds(90)) { println(it) }
        while (true) {
            try {
                val mail = fleet.form(awaited.await(1))
                Echo.around(mail, ByteArray(10))
                println("around")
                while (true) {
                    Thread.sleep(50)
                    Echo.around(mail, ByteArray(10))
                }
            } catch (e: MailClosedException) {
                println(e.message)
            }
        }
    }
}
