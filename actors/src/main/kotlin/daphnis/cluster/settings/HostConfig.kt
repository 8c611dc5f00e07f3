package daphnis.cluster.settings

import com.typesafe.config.Config
import com.typesafe.config.ConfigFactory
import daphnis.cluster.link.LinkLimits
import java.time.Duration

/**
 * What the actor system of a host needs so that nodes or runs of daphnis can live in it: its cluster provider, the
 * serializer, a role, and a way to give up processes that are lost. It goes between the host's own settings and those
 * of Pekko's libraries, of which `ConfigFactory.load()` has some already:
 *
 * ```
 * ConfigFactory.load(ConfigFactory.defaultApplication().withFallback(HostConfig.node()))
 * ```
 */
public object HostConfig {
    /** For a system in which a node is to live. */
    @JvmStatic
    public fun node(): Config = of(NODE)

    /** For a system in which a run is to live. */
    @JvmStatic
    public fun run(): Config = of(RUN)

    /** The roles of nodes and of runs. */
    internal const val NODE = "node"
    internal const val RUN = "run"

    private fun of(role: String): Config {
        val values = mapOf(
            ROLES to listOf(role),
            FRAME to Effective.frameOf(limits(shipped.resolve())),
        )
        val needed = KEYS.map { shipped.withOnlyPath(it) }.reduce { all, one -> all.withFallback(one) }
        return ConfigFactory.parseMap(values).withFallback(needed)
    }

    /** [config] with what is shipped behind it. */
    internal fun behind(config: Config): Config = config.withFallback(shipped.withOnlyPath(ROOT)).resolve()

    internal fun limits(config: Config): LinkLimits = Effective.limitsOf(config)

    internal fun silence(config: Config): Duration = Effective.silenceOf(config)

    /** What is missing in the [config] of a system for a process with the [role], in words behind its name. */
    internal fun problem(config: Config, role: String): String? {
        val provider = config.getString("pekko.actor.provider")
        val frame = config.getBytes(FRAME)
        return when {
            provider !in PROVIDERS -> "has the provider '$provider', and pekko.actor.provider must be cluster"
            config.getString(TRANSPORT) !in TRANSPORTS -> "has the transport '${config.getString(TRANSPORT)}', not tcp"
            SERIALIZER !in config.getConfig(SERIALIZERS).root().unwrapped().values -> "lacks the serializer $SERIALIZER"
            role !in config.getStringList(ROLES) -> "lacks the role '$role' in $ROLES"
            POST !in config.getStringList(LARGE) -> "lacks $POST in $LARGE"
            frame < Effective.frameOf(limits(config)) -> "has $FRAME = $frame, too small for $ROOT.chunk"
            else -> null
        }
    }

    private val shipped: Config get() = Effective.shipped

    private const val ROOT = "daphnis.cluster"
    private const val ROLES = "pekko.cluster.roles"
    private const val TRANSPORT = "pekko.remote.artery.transport"
    private const val FRAME = "pekko.remote.artery.advanced.maximum-large-frame-size"
    private const val LARGE = "pekko.remote.artery.large-message-destinations"
    private const val SERIALIZERS = "pekko.actor.serializers"
    private const val SERIALIZER = "daphnis.cluster.wire.FrameSerializer"
    private const val POST = "/system/daphnis-post"
    private val PROVIDERS = setOf("cluster", "org.apache.pekko.cluster.ClusterActorRefProvider")
    private val TRANSPORTS = setOf("tcp", "tls-tcp")

    /** Of what is shipped, what a host does not decide for itself. */
    private val KEYS = listOf(
        ROOT,
        "pekko.actor.provider",
        "pekko.actor.serializers",
        "pekko.actor.serialization-bindings",
        "pekko.actor.typed.library-extensions",
        TRANSPORT,
        LARGE,
        "pekko.remote.artery.advanced.large-buffer-pool-size",
        "pekko.remote.artery.advanced.outbound-large-message-queue-size",
        "pekko.cluster.downing-provider-class",
    )
}
