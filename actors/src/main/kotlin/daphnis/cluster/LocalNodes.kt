package daphnis.cluster

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.local.ChildProcess
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetException
import java.io.File
import java.io.IOException
import java.lang.management.ManagementFactory
import java.nio.file.Path
import java.time.Duration
import java.util.function.Consumer
import java.util.function.Function

/**
 * Nodes in processes of their own on this machine, which nobody else can join: they listen on the loopback address and
 * have a secret of their own. They end with this process, whatever ends it.
 *
 * @property fleet the nodes
 */
public class LocalNodes private constructor(public val fleet: Fleet, private val children: List<ChildProcess>) :
    AutoCloseable {
    /** The numbers of the processes. */
    public val pids: List<Long> get() = children.map { it.pid }

    /** Ends the fleet and the processes, and waits for that. */
    override fun close() {
        for (child in children) child.release()
        fleet.close()
        for (child in children) child.end()
    }

    public companion object {
        private const val PAUSE_MILLIS = 20L
        private const val MOST = 1000

        // JDK 24 and newer print four lines at the first use of sun.misc.Unsafe, which is Pekko's; older ones ignore
        // this.
        private const val UNSAFE_ALLOWED = "-Dsun.misc.unsafe.memory.access=allow"
        private const val VECTOR_UNIT = "add-modules=jdk.incubator.vector"

        /**
         * Starts [count] nodes and waits until all are there.
         *
         * @param run name of the run
         * @param command words of the command for a node that joins the process with the given address; the command
         *   finds its secret in the variable [Secret.VARIABLE] of its environment, and ends with its standard input
         * @param config file of settings, null for none; for this process
         * @param within how long the nodes may take to come
         * @param lines takes lines for the user, also what the nodes print, from any thread
         * @throws FleetException when a process cannot be started, or ends before its node is there
         */
        @JvmStatic
        @JvmOverloads
        public fun start(
            count: Int,
            run: String,
            command: Function<HostPort, List<String>>,
            lines: Consumer<String>,
            config: Path? = null,
            within: Duration = Duration.ofSeconds(60),
        ): LocalNodes {
            require(count in 1..MOST) { "$count local nodes; there must be 1..$MOST" }
            val secret = Secret.random()
            val fleet = ClusterFleet.join(ClusterSettings(secret = secret, config = config), run, lines)
            val children = ArrayList<ChildProcess>()
            val nodes = LocalNodes(fleet, children)
            try {
                repeat(count) { children += ChildProcess(command.apply(fleet.address), secret, lines::accept) }
                await(fleet, children, System.nanoTime() + within.toNanos())
                return nodes
            } catch (e: IOException) {
                nodes.close()
                throw FleetException("a node cannot be started: ${e.message}", e)
            } catch (e: Throwable) {
                nodes.close()
                throw e
            }
        }

        /** The words that start [mainClass] on the Java and with the class path and the JVM's flags of this process. */
        @JvmStatic
        public fun java(mainClass: String): List<String> {
            val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
            // An agent or a port for a debugger serves one process. Nodes do not use the vector unit, and the JVM would
            // write a line about it for each.
            val flags = ManagementFactory.getRuntimeMXBean().inputArguments.filter {
                !it.startsWith("-javaagent") &&
                    !it.startsWith("-agentlib") &&
                    !it.startsWith("-Djava.class.path") &&
                    it.trimStart('-') != VECTOR_UNIT
            }
            val path = System.getProperty("java.class.path").split(File.pathSeparator)
                .joinToString(File.pathSeparator) { File(it).absolutePath }
            return listOf(java, UNSAFE_ALLOWED) + flags + listOf("-cp", path, mainClass)
        }

        private fun await(fleet: Fleet, children: List<ChildProcess>, end: Long) {
            while (fleet.nodes().size < children.size) {
                children.find { !it.isAlive }?.let { throw FleetException(it.ending) }
                if (System.nanoTime() > end) {
                    throw FleetException("only ${fleet.nodes().size} of ${children.size} local nodes have come")
                }
                Thread.sleep(PAUSE_MILLIS)
            }
        }
    }
}
