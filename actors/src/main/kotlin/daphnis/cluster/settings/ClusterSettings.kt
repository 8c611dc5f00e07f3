package daphnis.cluster.settings

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.parallel.Cores
import daphnis.core.parallel.ThreadHandler
import java.nio.file.Path
import java.time.Duration

/**
 * How a process takes part in a cluster. What is not here is in the file daphnis/cluster/cluster.conf of this
 * library, which [config] and system properties override; docs/cluster.md says what can be set.
 *
 * @property host name or address by which the other processes reach this one; they must write it in the same way
 * @property port to listen on; 0 for any that is free
 * @property join where other processes are; when this process is the first of them and no other answers, it begins a
 *   cluster, and also when there are none
 * @property threads a node works with
 * @property secret that all processes of the cluster were given
 * @property bind address to listen on, if another than [host]
 * @property insecure whether to listen beyond this machine without TLS
 * @property config file of settings, null for none
 * @property joinWithin how long to wait for an answer of [join]
 */
public data class ClusterSettings @JvmOverloads constructor(
    val host: String = LOOPBACK,
    val port: Int = 0,
    val join: List<HostPort> = emptyList(),
    val threads: Int = Cores.ofJob,
    val secret: Secret = Secret.NONE,
    val bind: String? = null,
    val insecure: Boolean = false,
    val config: Path? = null,
    val joinWithin: Duration = Duration.ofSeconds(60),
) {
    init {
        if (port !in 0..HostPort.LAST_PORT) throw wrong("port", "is $port; it must be in 0..${HostPort.LAST_PORT}")
        if (!HostPort.HOST.matches(host)) throw wrong("host", "'$host' is no name or address of a host")
        if (threads !in 1..ThreadHandler.MOST) {
            throw wrong("threads", "is $threads; it must be in 1..${ThreadHandler.MOST}")
        }
    }

    /**
     * Reads all files that these settings name, and checks what can be checked before anything listens, as every start
     * of a node or a run does.
     *
     * @throws InputException when they cannot be right
     */
    public fun requireUsable() {
        Effective(this)
    }

    public companion object {
        /** The address of this machine that no other reaches. */
        public const val LOOPBACK: String = "127.0.0.1"

        /** The port of a cluster's first process, if no other is named. */
        public const val PORT: Int = 25520

        internal fun wrong(argument: String, problem: String, wayOut: WayOut? = null) =
            InputException(argument, null, problem, wayOut, isArgument = true)
    }
}
