package daphnis.actors.pekko

import daphnis.actors.region.Answers
import daphnis.actors.region.Region
import daphnis.actors.region.RegionHost
import daphnis.actors.region.Share
import daphnis.actors.region.onFreshThread
import daphnis.actors.region.uninterrupted
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.MailboxSelector
import java.util.concurrent.atomic.AtomicInteger

/**
 * The regions of an engine as system actors of [system], on its default dispatcher. They need no parent of their own to
 * supervise them, since whatever a region throws becomes its answer.
 */
internal class PekkoRegions(private val system: ActorSystem<*>, regions: List<Region>, answers: Answers) : RegionHost {
    private val actors = ArrayList<ActorRef<RegionBehavior.Message>>(regions.size)

    init {
        check(!hasEnded) { "$name has ended" }
        val number = ENGINES.incrementAndGet()
        try {
            onFreshThread { for (region in regions) actors += spawn(region, answers, number) }
        } catch (e: Throwable) {
            stop()
            throw e
        }
    }

    /**
     * The protocol bounds the mailbox: the present share, and the request to stop. A mailbox with a capacity of its
     * own would lock, and when the sender is interrupted while it waits for the lock, Pekko drops the message silently.
     */
    private fun spawn(region: Region, answers: Answers, number: Int): ActorRef<RegionBehavior.Message> {
        val name = "daphnis-$number-region-${region.number}"
        return system.systemActorOf(RegionBehavior.create(region, answers), name, MailboxSelector.defaultMailbox())
    }

    override val name: String get() = "the actor system \"${system.name()}\""

    override val hasEnded: Boolean get() = system.whenTerminated().isCompleted

    /** While an actor is starting, an interrupt can abort a send before anything has been sent. */
    override fun send(region: Int, share: Share) {
        uninterrupted { actors[region].tell(RegionBehavior.Handle(share)) }
    }

    override fun stop() {
        for (actor in actors) uninterrupted { actor.tell(RegionBehavior.Stop) }
    }

    private companion object {
        val ENGINES = AtomicInteger()
    }
}
