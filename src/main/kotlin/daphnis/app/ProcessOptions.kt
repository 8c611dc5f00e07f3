package daphnis.app

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import java.time.Duration

/** The options of every process that takes part in a cluster. */
internal open class ProcessOptions(name: String?, help: String?) : OptionGroup(name, help) {
    protected val host by option(
        "--host",
        help = "name or address by which others reach this process (default: 127.0.0.1; a node under Slurm: its own)",
    )
    protected val secretFile by option(
        "--secret-file",
        metavar = "file",
        help = "file with the cluster's secret (default: the variable ${Secret.VARIABLE})",
        completionCandidates = Candidates.files,
    )
    protected val config by option(
        "--config",
        metavar = "file",
        help = "file of settings, see docs/cluster.md",
        completionCandidates = Candidates.files,
    )
    protected val bind by option("--bind", metavar = "address", help = "address to listen on, if another than --host")
    protected val insecure by option("--insecure", help = "listen beyond this machine without TLS").flag()

    /** These options and what else makes up the settings; null for what is usual. */
    fun settings(
        join: List<HostPort>,
        hostElse: String? = null,
        port: Int? = null,
        threads: Int? = null,
        joinWithin: Duration? = null,
    ): ClusterSettings {
        val usual = ClusterSettings()
        return ClusterSettings(
            host = host ?: hostElse ?: usual.host,
            port = port ?: usual.port,
            join = join,
            threads = threads ?: usual.threads,
            secret = secretFile?.let { Secret.read(pathOf(it, "--secret-file")) } ?: Secret.ofEnvironment(),
            bind = bind,
            insecure = insecure,
            config = config?.let { pathOf(it, "--config") },
            joinWithin = joinWithin ?: usual.joinWithin,
        )
    }
}
