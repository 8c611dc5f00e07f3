package daphnis.cluster.downing

import daphnis.cluster.downing.Parting.Decision
import daphnis.cluster.system.DeskBehavior
import org.apache.pekko.actor.AbstractActorWithTimers
import org.apache.pekko.actor.ActorSystem
import org.apache.pekko.actor.Props
import org.apache.pekko.cluster.Cluster
import org.apache.pekko.cluster.ClusterEvent
import org.apache.pekko.cluster.DowningProvider
import org.apache.pekko.cluster.Member
import org.apache.pekko.cluster.MemberStatus
import org.apache.pekko.remote.artery.ThisActorSystemQuarantinedEvent
import scala.Option
import scala.concurrent.duration.FiniteDuration
import java.time.Duration
import java.util.concurrent.TimeUnit

/** Pekko's door for [Parting]. Made by Pekko, from the setting `downing-provider-class`. */
internal class RunGoesOn(private val system: ActorSystem) : DowningProvider() {
    override fun downRemovalMargin(): FiniteDuration = FiniteDuration(0, TimeUnit.SECONDS)

    override fun downingActorProps(): Option<Props> {
        val stable = system.settings().config().getDuration(STABLE_AFTER)
        return Option.apply(Props.create(Watch::class.java) { Watch(stable, System::nanoTime) })
    }

    private companion object {
        const val STABLE_AFTER = "daphnis.cluster.stable-after"
    }
}

/**
 * Decides when the same members have been unreachable for as long as [stable]. When others have given up this process,
 * which was silent for too long, it ends.
 */
internal class Watch(private val stable: Duration, private val now: () -> Long) : AbstractActorWithTimers() {
    private val cluster = Cluster.get(context.system)
    private var unreachable: Set<Member> = emptySet()
    private var since = now()

    override fun preStart() {
        val period = stable.dividedBy(CHECKS).coerceIn(SHORTEST, LONGEST)
        timers.startTimerWithFixedDelay(Check, Check, period)
        context.system.eventStream().subscribe(self, ThisActorSystemQuarantinedEvent::class.java)
    }

    override fun createReceive(): Receive = receiveBuilder()
        .matchEquals(Check) { check(cluster.state()) }
        .match(ThisActorSystemQuarantinedEvent::class.java) { cluster.down(cluster.selfAddress()) }
        .build()

    private fun check(state: ClusterEvent.CurrentClusterState) {
        val seen = HashSet(state.getUnreachable())
        if (seen != unreachable) {
            unreachable = seen
            since = now()
        }
        if (seen.isEmpty() || now() - since < stable.toNanos()) return
        val members = state.members.filter { it.status() !in GONE }
        val decision = Parting.decide(
            members.map { Parting.Seen(DeskBehavior.RUN in it.roles, it.upNumber(), it !in seen) },
        )
        if (decision ==
            Decision.SELF_GOES
        ) {
            cluster.down(cluster.selfAddress())
        } else {
            seen.forEach { cluster.down(it.address()) }
        }
    }

    private object Check

    private companion object {
        const val CHECKS = 10L
        val SHORTEST: Duration = Duration.ofMillis(50)
        val LONGEST: Duration = Duration.ofMillis(500)
        val GONE = setOf(MemberStatus.down(), MemberStatus.removed(), MemberStatus.exiting())
    }
}
