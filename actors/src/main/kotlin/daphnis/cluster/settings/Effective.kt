package daphnis.cluster.settings

import com.typesafe.config.Config
import com.typesafe.config.ConfigException
import com.typesafe.config.ConfigFactory
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.link.LinkLimits
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import java.net.InetAddress
import java.net.UnknownHostException
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration

/**
 * [ClusterSettings] with all files: what Pekko is given. Checks that nothing is open to other machines by mistake.
 *
 * Where a key is set in several places, the first counts: the arguments, system properties, the user's file,
 * daphnis/cluster/cluster.conf, Pekko's own.
 */
internal class Effective(private val settings: ClusterSettings) {
    private val files: Config = ConfigFactory.systemProperties()
        .withFallback(settings.config?.let(::read) ?: ConfigFactory.empty())
        .withFallback(shipped)
        .withFallback(ConfigFactory.defaultReference(javaClass.classLoader))
    private val own = asInput { files.resolve() }
    private val pem = listOf("key", "certificate", "authority").associateWith { own.getString("$ROOT.tls.$it") }

    /** Whether everything between processes is encrypted. */
    val isTls: Boolean = pem.values.any { it.isNotEmpty() } || own.getString(TRANSPORT) == TLS

    /** Bounds of the links. */
    val limits: LinkLimits = asInput { limitsOf(own) }

    /** How long the desk of another process may say nothing. */
    val silence: Duration = asInput { silenceOf(own) }

    init {
        asInput { own.getDuration("$ROOT.heartbeat") }
        if (pem.values.any { it.isNotEmpty() }) {
            for ((key, file) in pem) {
                if (file.isEmpty()) throw wrong("$ROOT.tls.$key", "is missing; TLS needs all three files")
                if (!Files.isReadable(Path.of(file))) throw wrong("$ROOT.tls.$key", "'$file' cannot be read")
            }
        }
        requireSafe()
    }

    /** For Pekko, with the [roles] of the process. */
    fun config(roles: List<String>): Config {
        val bind = settings.bind ?: settings.host
        val values = linkedMapOf<String, Any>(
            "pekko.cluster.roles" to roles,
            "pekko.remote.artery.canonical.hostname" to HostPort(HostPort.canonical(settings.host), 0).uriHost,
            "pekko.remote.artery.canonical.port" to settings.port,
            "pekko.remote.artery.bind.hostname" to HostPort(bind, 0).uriHost,
            "pekko.remote.artery.advanced.maximum-large-frame-size" to frameOf(limits),
            TRANSPORT to if (isTls) TLS else own.getString(TRANSPORT),
        )
        if (pem.values.all { it.isNotEmpty() }) {
            values["pekko.remote.artery.ssl.ssl-engine-provider"] = PEM_PROVIDER
            values["pekko.remote.artery.ssl.rotating-keys-engine.key-file"] = pem.getValue("key")
            values["pekko.remote.artery.ssl.rotating-keys-engine.cert-file"] = pem.getValue("certificate")
            values["pekko.remote.artery.ssl.rotating-keys-engine.ca-cert-file"] = pem.getValue("authority")
        }
        return asInput { ConfigFactory.parseMap(values).withFallback(files).resolve() }
    }

    private fun requireSafe() {
        val open = listOfNotNull("host" to settings.host, settings.bind?.let { "bind" to it })
            .firstOrNull { (argument, host) -> !isLoopback(argument, host) } ?: return
        if (isTls) return
        if (!settings.insecure) {
            throw ClusterSettings.wrong(
                open.first,
                "${open.second} is open to other machines, and there is no TLS",
                WayOut.TLS_OR_INSECURE,
            )
        }
        if (settings.secret.isNone) {
            throw ClusterSettings.wrong(
                open.first,
                "${open.second} is open to other machines; without TLS a secret is needed there",
            )
        }
    }

    private fun isLoopback(argument: String, host: String): Boolean = try {
        InetAddress.getByName(host).isLoopbackAddress
    } catch (_: UnknownHostException) {
        throw ClusterSettings.wrong(argument, "no host with the name '$host' is known")
    }

    private fun read(path: Path): Config {
        if (!Files.isReadable(path)) throw InputException("$path", null, "the settings cannot be read")
        return asInput { ConfigFactory.parseFile(path.toFile()) }
    }

    private fun <T> asInput(read: () -> T): T = try {
        read()
    } catch (e: ConfigException) {
        throw InputException(source, null, e.message.orEmpty())
    } catch (e: IllegalArgumentException) {
        throw InputException(source, null, e.message.orEmpty())
    }

    private fun wrong(key: String, problem: String) = InputException(source, key, problem)

    private val source: String get() = settings.config?.toString() ?: "system properties"

    companion object {
        /** What this library settles. Within a module only its own classes find the file. */
        val shipped: Config
            get() = ConfigFactory.parseURL(
                checkNotNull(Effective::class.java.getResource("/daphnis/cluster/cluster.conf")),
            )

        private const val ROOT = "daphnis.cluster"
        private const val TRANSPORT = "pekko.remote.artery.transport"
        private const val TLS = "tls-tcp"
        private const val PEM_PROVIDER = "org.apache.pekko.remote.artery.tcp.ssl.RotatingKeysSSLEngineProvider"

        /** A message as long as an array can be is still none. */
        private const val LARGEST = (1L shl 31) - 1024

        /** What Pekko writes around a chunk, amply. */
        private const val FRAME_ROOM = 64 shl 10

        /** Bounds of the links in [config]. */
        fun limitsOf(config: Config): LinkLimits = LinkLimits(
            chunk = config.bytes("$ROOT.chunk"),
            window = config.bytes("$ROOT.window"),
            waiting = config.getBytes("$ROOT.waiting"),
            message = config.bytes("$ROOT.longest-message"),
        )

        /** Bytes of a frame with a chunk. */
        fun frameOf(limits: LinkLimits): Int = limits.chunk + FRAME_ROOM

        /** Amply more than a process which is gone stays in the cluster. */
        fun silenceOf(config: Config): Duration {
            val gone = config.getDuration("$ROOT.acceptable-pause").plus(config.getDuration("$ROOT.stable-after"))
            return gone.multipliedBy(2).plusSeconds(SLACK_SECONDS)
        }

        private const val SLACK_SECONDS = 10L

        private fun Config.bytes(key: String): Int {
            val bytes = getBytes(key)
            require(bytes in 1..LARGEST) { "$key is $bytes bytes; it must be in 1..$LARGEST" }
            return bytes.toInt()
        }
    }
}
