package daphnis.cluster

import com.typesafe.config.Config
import com.typesafe.config.ConfigFactory
import daphnis.cluster.TestedFleet.Companion.await
import daphnis.cluster.TestedFleet.Companion.awaitThat
import daphnis.cluster.settings.HostConfig
import daphnis.cluster.system.HostGround
import daphnis.core.cluster.FleetEngines
import daphnis.core.cluster.MailClosedException
import daphnis.core.cluster.NodesAwaited
import daphnis.core.cluster.nodeWork
import daphnis.core.run.Run
import daphnis.core.run.Summary
import daphnis.core.scenario.BuiltIn
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.apache.pekko.cluster.Cluster
import org.apache.pekko.cluster.MemberStatus
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.io.Closeable
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ConcurrentLinkedQueue

/** Nodes and runs in actor systems of a host, which has its own name, settings and guardian. */
@Timeout(300)
class HostSystemTest {
    private val systems = ArrayList<ActorSystem>()
    private val lines = ConcurrentLinkedQueue<String>()

    @AfterEach
    fun end() {
        for (system in systems) system.terminate()
        for (system in systems) system.getWhenTerminated().toCompletableFuture().get()
    }

    private fun config(own: String, ours: Config = ConfigFactory.empty()): Config =
        ConfigFactory.load(ConfigFactory.parseString("$HOST\n$own").withFallback(ours))

    private fun system(own: String = "", ours: Config = ConfigFactory.empty()): ActorSystem =
        ActorSystem.create("host", config(own, ours)).also { systems += it }

    /** A typed system with a guardian of its own, by its classic door. */
    private fun typed(ours: Config): ActorSystem = org.apache.pekko.actor.typed.ActorSystem
        .create(Behaviors.empty<Void>(), "host", config("", ours)).classicSystem().also { systems += it }

    /** Makes one cluster of [systems], as their host does. */
    private fun join() {
        for (system in systems) Cluster.get(system).join(Cluster.get(systems[0]).selfAddress())
    }

    private fun node(system: ActorSystem) = ClusterNode.on(system, TestedFleet.SECRET, 1, Echo) { lines += it }

    private fun leader(system: ActorSystem, run: String) =
        ClusterFleet.on(system, TestedFleet.SECRET, run) { lines += it }

    @Tag("thorough")
    @Test
    fun `runs follow one another on nodes of a host, whose systems and cluster stay`() {
        val nodes = listOf(system(ours = HostConfig.node()), typed(HostConfig.node()))
        val run = system(ours = HostConfig.run())
        join()
        val started = nodes.map(::node)
        repeat(3) {
            leader(run, "run $it").use { fleet ->
                Echo.around(fleet.form(await(fleet, 2)), ByteArray(1_000_000))
                assertThrows(IllegalStateException::class.java) { leader(run, "another") }
            }
            awaitThat("free nodes") { lines.count { line -> line == "run run $it has ended; waiting for a run" } == 2 }
        }
        leader(run, "last").use { fleet ->
            val mail = fleet.form(await(fleet, 2))
            Echo.around(mail, ByteArray(5))
            started[0].close()
            val e = assertThrows(MailClosedException::class.java) { mail.receive(0) }
            assertTrue("has left the cluster" in e.message!!) { e.message }
            Echo.around(fleet.form(await(fleet, 1)), ByteArray(5))
            node(nodes[0]).use { Echo.around(fleet.form(await(fleet, 2)), ByteArray(5)) }
        }
        started[1].close()
        for (system in systems) {
            assertFalse(system.getWhenTerminated().toCompletableFuture().isDone)
            assertEquals(MemberStatus.up(), Cluster.get(system).selfMember().status())
        }
    }

    @Tag("thorough")
    @Test
    fun `the programs of the guide`(@TempDir path: Path) {
        val own = ConfigFactory.parseString(HOST)
        val runs = system(ours = HostConfig.run())
        join()
        val address = Cluster.get(runs).selfAddress()
        val secret = TestedFleet.SECRET
        val threads = 1
        // example: hostNode
        val needed = own.withFallback(HostConfig.node()) // own settings; HostConfig.run() for runs
        val system = ActorSystem.create("host", ConfigFactory.load(needed))
        Cluster.get(system).join(address) // the host's own business, like leaving
        val node = ClusterNode.on(system, secret, threads, nodeWork()) { println(it) }
        // end
        systems += system
        runOn(runs, path)
        assertEquals("cluster", Summary.read(path.resolve("summary.json")).engine)
        node.close()
    }

    private fun runOn(system: ActorSystem, path: Path) {
        val scenario = BuiltIn.scenario("cooling-gas", listOf("until=0.1", "particles.count=50"))
        val secret = TestedFleet.SECRET
        // example: hostFleet
        val fleet = ClusterFleet.on(system, secret, "ring") { println(it) }
        NodesAwaited(fleet, Duration.ofMinutes(5)) { println(it) }.await(1)
        Run.start(scenario, "ring.json", path, engines = FleetEngines(fleet)).use { it.execute() }
        // end
    }

    @Test
    fun `the end of a host's system ends what lives in it with a reason`() {
        val system = system(ours = HostConfig.node())
        join()
        val node = node(system)
        system.terminate()
        val e = assertThrows(daphnis.core.cluster.FleetException::class.java) { node.await() }
        assertTrue("actors have ended" in e.message!! || "cut off" in e.message!!) { e.message }
        node.close()
    }

    @Test
    fun `what lives in a host's system ends without an exception when the system has no timers any more`() {
        val quiet = "pekko { loglevel = OFF, stdout-loglevel = OFF, loggers = [], daemonic = on }"
        val own = "pekko.coordinated-shutdown.run-by-actor-system-terminate = off"
        val system = ActorSystem.create("ending", ConfigFactory.parseString("$quiet\n$own").withFallback(DEFAULTS))
        val ground = HostGround(system, TestedFleet.SECRET, 1, Duration.ofSeconds(1))
        val actor = ground.spawn(system, Behaviors.empty(), "tenant")
        (system.scheduler() as Closeable).close()
        ground.end(system, listOf(actor))
        system.terminate()
        system.getWhenTerminated().toCompletableFuture().get()
    }

    @Test
    fun `a system that lacks something is refused with what it lacks`() {
        fun refusal(system: ActorSystem) =
            assertThrows(IllegalArgumentException::class.java) { leader(system, "x") }.message!!

        fun assertRefused(part: String, own: String, ours: Config = HostConfig.run()) {
            val message = refusal(system(own, ours))
            assertTrue(part in message && "'host'" in message && "HostConfig" in message) { message }
        }
        assertRefused("has the provider 'local'", "pekko.actor.provider = local")
        assertRefused("lacks the role 'run'", "", HostConfig.node())
        assertRefused("lacks the serializer", "", ConfigFactory.parseString(BARE))
        assertRefused("too small for daphnis.cluster.chunk", "daphnis.cluster.chunk = 1 MiB")
        assertRefused("lacks /system/daphnis-post", "pekko.remote.artery.large-message-destinations = []")
    }

    private companion object {
        val DEFAULTS: Config = ConfigFactory.load()
        const val BARE = "pekko { actor { provider = cluster, typed.library-extensions = [] } }"
        const val HOST = """
            pekko { loglevel = OFF, stdout-loglevel = OFF, loggers = [], daemonic = on }
            pekko.coordinated-shutdown.run-by-jvm-shutdown-hook = off
            pekko.remote.artery.canonical { hostname = "127.0.0.1", port = 0 }
            pekko.cluster.jmx.enabled = off
        """
    }
}
