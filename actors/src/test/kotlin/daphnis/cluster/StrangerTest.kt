package daphnis.cluster

import daphnis.cluster.TestedFleet.Companion.await
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.Effective
import daphnis.cluster.wire.Note
import daphnis.cluster.wire.Peer
import daphnis.cluster.wire.SealedMembership
import org.apache.pekko.actor.ActorRef
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.Address
import org.apache.pekko.actor.BootstrapSetup
import org.apache.pekko.actor.ExtendedActorSystem
import org.apache.pekko.actor.Kill
import org.apache.pekko.actor.PoisonPill
import org.apache.pekko.actor.setup.ActorSystemSetup
import org.apache.pekko.cluster.Cluster
import org.apache.pekko.cluster.ClusterUserAction
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** What a program without the secret, which reaches the port, can do to a node: nothing. On this machine only. */
@Timeout(300)
class StrangerTest {
    @TempDir
    lateinit var folder: Path

    private val tested by lazy { TestedFleet(folder) }
    private val strangers = ArrayList<ActorSystem>()

    @AfterEach
    fun close() {
        for (stranger in strangers) stranger.terminate()
        for (stranger in strangers) stranger.getWhenTerminated().toCompletableFuture().get()
        tested.close()
    }

    /** A system of the same program with another [secret]; null for Pekko's own ways. */
    private fun stranger(secret: Secret?): ActorSystem {
        val config = Effective(tested.settings().copy(secret = Secret.NONE)).config(listOf("node"))
        val setups = listOfNotNull(BootstrapSetup.create(config), secret?.let(SealedMembership::setup))
        return ActorSystem.create("daphnis", ActorSystemSetup.create(*setups.toTypedArray())).also { strangers += it }
    }

    private fun paths(node: ClusterNode) = listOf(
        "/system/daphnis-desk",
        "/system/daphnis-post",
        "/system/daphnis-receipts",
        "/system/cluster/core/daemon",
        "/system",
        "/user",
    ).map { "pekko://daphnis@${node.address}$it" }

    private fun assertWorks(node: ClusterNode) {
        tested.leader().use { fleet ->
            assertEquals(listOf("${node.address}"), await(fleet, 1).map { it.name })
            Echo.around(fleet.form(await(fleet, 1)), ByteArray(100))
        }
    }

    @Test
    fun `messages that end an actor have no effect from elsewhere, by its path or by its reference`() {
        val node = tested.node()
        for (secret in listOf(null, Secret.NONE)) {
            val system = stranger(secret)
            for (path in paths(node)) {
                for (message in listOf(PoisonPill.getInstance(), Kill.getInstance())) {
                    system.actorSelection(path).tell(message, ActorRef.noSender())
                    (system as ExtendedActorSystem).provider().resolveActorRef(path).tell(message, ActorRef.noSender())
                }
            }
            pass(system, node)
        }
        assertWorks(node)
    }

    @Tag("thorough")
    @Test
    fun `who has not the secret neither joins nor declares a node lost`() {
        val node = tested.node()
        for (secret in listOf(null, Secret.NONE, Secret.random())) {
            val system = stranger(secret)
            val address = Address("pekko", "daphnis", node.address.host, node.address.port)
            Cluster.get(system).join(address)
            val down = ClusterUserAction.Down(address)
            val daemon = "pekko://daphnis@${node.address}/system/cluster/core/daemon"
            system.actorSelection(daemon).tell(down, ActorRef.noSender())
            (system as ExtendedActorSystem).provider().resolveActorRef(daemon).tell(down, ActorRef.noSender())
            pass(system, node)
            Thread.sleep(1500)
            assertTrue(Cluster.get(system).state().members.none { true })
        }
        assertWorks(node)
    }

    /** All that [system] has sent to [node] before is taken: it refuses what comes behind. */
    private fun pass(system: ActorSystem, node: ClusterNode) {
        val self = Cluster.get(system).selfUniqueAddress()
        val peer = Peer(daphnis.cluster.hosts.HostPort("127.0.0.1", self.address().port.get() as Int), 7)
        val hello = Note.Hello(peer, 999, "9.9", ByteArray(32))
        val desk = system.actorSelection("pekko://daphnis@${node.address}/system/daphnis-desk")
        TestedFleet.awaitThat("refusal of ${peer.address}") {
            desk.tell(hello, ActorRef.noSender())
            Thread.sleep(50)
            tested.lines.any { it.startsWith("refused ${peer.address}") }
        }
    }
}
