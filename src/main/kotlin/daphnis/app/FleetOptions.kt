package daphnis.app

import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import daphnis.app.printing.warn
import daphnis.cluster.ClusterFleet
import daphnis.cluster.LocalNodes
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.settings.ClusterSettings
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetEngines
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.NodesAwaited
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import daphnis.core.parallel.Cores
import java.time.Duration

/** The options of a command that can let nodes compute. */
internal class FleetOptions : ProcessOptions(GroupedHelp.SEVERAL_MACHINES, "See docs/cluster.md.") {
    private val nodes by option(
        "--nodes",
        metavar = "number",
        help = "compute with so many processes on this machine; with --cluster, wait for so many (1 if not given)",
    ).int()
    private val cluster by option(
        "--cluster",
        metavar = "host:port,…",
        help = "compute with the nodes of the cluster to which these belong",
    )

    @Volatile
    private var fleet: LateFleet? = null

    /** Whether nodes compute. */
    val isGiven: Boolean get() = nodes != null || cluster != null

    /**
     * Does [act] with engines for the run of [name]: those of this process, or nodes. Nodes are started, or joined,
     * when the run asks for its first step, so that whatever is wrong with it is told before.
     *
     * @param threads of each node on this machine; null to share the cores out
     */
    fun <T> withEngines(name: String, threads: Int?, act: (EngineFactory) -> T): T {
        requireConsistent(threads)
        if (!isGiven) return act(allEngines)
        val settings = settings(cluster?.let { HostPort.parseList(it, "--cluster") }.orEmpty())
        settings.requireUsable()
        return LateFleet { if (cluster == null) onThisMachine(name, threads) else onCluster(name, settings) }.use {
            fleet = it
            act(FleetEngines(it, log = ::warn))
        }
    }

    /** Nanoseconds for which nodes have computed; 0 while they are waited for. */
    val able: Long get() = if (isGiven) fleet?.able ?: 0 else Long.MAX_VALUE

    /** Ends a wait for nodes. Any thread may call. */
    fun giveUp() {
        fleet?.giveUp()
    }

    private fun requireConsistent(threads: Int?) {
        val count = nodes
        if (threads != null && cluster != null) throw wrong("--threads", "is a matter of each node of the cluster")
        if (count != null && count !in 1..MOST) throw wrong("--nodes", "is $count; it must be in 1..$MOST")
        if (cluster != null) return
        for ((option, isThere) in listOf(
            "--host" to (host != null),
            "--secret-file" to (secretFile != null),
            "--bind" to (bind != null),
            "--insecure" to insecure,
        )) {
            if (isThere) throw wrong(option, "needs --cluster")
        }
        if (config != null && nodes == null) throw wrong("--config", "needs --cluster or --nodes")
    }

    private fun onThisMachine(name: String, threads: Int?): Fleet {
        val count = nodes!!
        val each = threads ?: maxOf(1, Cores.ofJob / count)
        val command = { leader: HostPort ->
            val words = listOf("node", "--join", "$leader", "--threads", "$each", "--until-input-ends")
            LocalNodes.java(MAIN) + words + listOfNotNull(config?.let { "--config=$it" })
        }
        val local = LocalNodes.start(count, name, command, ::warn, config?.let { pathOf(it, "--config") })
        return object : Fleet by local.fleet {
            override fun close() = local.close()
        }.also { tell(it.nodes()) }
    }

    private fun onCluster(name: String, settings: ClusterSettings): Fleet {
        val fleet = ClusterFleet.join(settings, name, ::warn)
        try {
            tell(NodesAwaited(fleet, Duration.ofSeconds(WAIT_SECONDS), ::warn).await(nodes ?: 1))
        } catch (e: Throwable) {
            fleet.use { throw e }
        }
        return fleet
    }

    private fun tell(nodes: List<FleetNode>) {
        val together = "${count(nodes.size, "node")} with ${count(nodes.sumOf { it.threads }, "thread")}"
        warn("$together; the loss of nodes costs some seconds each time, and no bit")
    }

    private fun count(number: Int, what: String) = if (number == 1) "1 $what" else "$number ${what}s"

    private fun wrong(option: String, problem: String) = InputException(option, null, problem)

    private companion object {
        const val MAIN = "daphnis.app.MainKt"
        const val MOST = 1000
        const val WAIT_SECONDS = 300L
    }
}
