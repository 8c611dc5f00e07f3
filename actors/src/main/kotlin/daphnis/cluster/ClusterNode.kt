package daphnis.cluster

import daphnis.cluster.desk.Greeter
import daphnis.cluster.desk.NodeParty
import daphnis.cluster.hosts.HostPort
import daphnis.cluster.security.Secret
import daphnis.cluster.settings.ClusterSettings
import daphnis.cluster.system.ClusterProcess
import daphnis.cluster.system.CrewWorker
import daphnis.cluster.system.DeskBehavior
import daphnis.cluster.system.Ground
import daphnis.cluster.system.HostGround
import daphnis.cluster.system.OwnGround
import daphnis.cluster.system.Protocol
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.NodeWork
import daphnis.core.input.oneLine
import org.apache.pekko.actor.ActorSystem
import java.time.Duration
import java.util.function.Consumer

/**
 * A node: a process of a cluster that works for one run after the other, from [start] to [close]. Any thread may call.
 */
public class ClusterNode private constructor(private val process: ClusterProcess, private val worker: CrewWorker) :
    AutoCloseable {
    /** Where the node listens; other processes join by it. */
    public val address: HostPort get() = process.self.address

    /**
     * Waits until the node is no part of the cluster any more.
     *
     * @throws FleetException when it was not [close] that ended it: the message says what
     * @throws InterruptedException when the thread is interrupted; the node goes on
     */
    public fun await() {
        val why = process.ended.get()
        if (why.isNotEmpty()) throw FleetException(why)
    }

    /** Leaves the cluster, which ends the crew that the node is in, and waits some seconds for that. */
    override fun close() {
        process.close()
        worker.end()
    }

    public companion object {
        private val HOST_PATIENCE: Duration = Duration.ofSeconds(60)

        /**
         * Listens and joins the cluster, and begins one if [ClusterSettings.join] is empty.
         *
         * @param work is called on a thread of the node's own for each crew, for one at a time
         * @param lines takes lines for the user, from any thread: what the node joined, works in, and was refused
         * @throws FleetException when it cannot listen, nobody answers, or the node is refused
         * @throws daphnis.core.input.InputException when the settings cannot be right
         */
        @JvmStatic
        public fun start(settings: ClusterSettings, work: NodeWork, lines: Consumer<String>): ClusterNode =
            start(settings, work, Protocol.build, lines)

        /**
         * Lets a node live in [system], a host's actor system with the settings of
         * [HostConfig.node][daphnis.cluster.settings.HostConfig.node]. It lives until [close], which ends neither the
         * system nor its place in the cluster. One node or run lives in a system at a time.
         *
         * @param secret that all nodes and runs of the cluster were given
         * @param threads the node works with
         * @throws FleetException when the system is in no cluster within a minute
         * @throws IllegalArgumentException when the system lacks what is needed; the message says what
         * @throws IllegalStateException when a node or a run lives there already
         */
        @JvmStatic
        public fun on(
            system: ActorSystem,
            secret: Secret,
            threads: Int,
            work: NodeWork,
            lines: Consumer<String>,
        ): ClusterNode = start(HostGround(system, secret, threads, HOST_PATIENCE), work, Protocol.build, lines)

        internal fun start(
            settings: ClusterSettings,
            work: NodeWork,
            build: Greeter.Build,
            lines: Consumer<String>,
        ): ClusterNode = start(OwnGround(settings), work, build, lines)

        private fun start(ground: Ground, work: NodeWork, build: Greeter.Build, lines: Consumer<String>): ClusterNode {
            val say = { line: String -> lines.accept(oneLine(line)) }
            val process = ClusterProcess(ground, DeskBehavior.NODE, build, say)
            lateinit var worker: CrewWorker
            process.start {
                lateinit var party: NodeParty
                worker = CrewWorker(work, ground.threads) { mail, words -> it.later { party.failed(mail, words) } }
                val begin = worker::begin
                party = NodeParty(
                    it.self,
                    it.greeter,
                    it.mails,
                    it.courier,
                    it.silence,
                    begin,
                    it::later,
                    say,
                )
                party
            }
            ground.openness?.let(say)
            say("node ${process.self.address} is waiting for a run; threads: ${ground.threads}")
            return ClusterNode(process, worker)
        }
    }
}
