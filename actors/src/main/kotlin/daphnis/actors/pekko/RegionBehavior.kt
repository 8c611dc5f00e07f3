package daphnis.actors.pekko

import daphnis.actors.region.Answers
import daphnis.actors.region.Region
import daphnis.actors.region.Share
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.PostStop
import org.apache.pekko.actor.typed.javadsl.Behaviors

/**
 * An actor that owns a region: it works on a share and answers, even when it fails. The coordinator is told of its
 * end, whatever the cause.
 *
 * Pekko guarantees that the receiver sees what was done before a send, and that an actor sees, when it handles a
 * message, what it did for the one before.
 */
internal object RegionBehavior {
    /** The messages that a region's actor understands. */
    sealed interface Message

    /** Work on [share] and answer. */
    class Handle(val share: Share) : Message

    /** End. */
    object Stop : Message

    fun create(region: Region, answers: Answers): Behavior<Message> = Behaviors.receive(Message::class.java)
        .onMessage(Handle::class.java) {
            region.serve(it.share, answers)
            Behaviors.same()
        }
        .onMessage(Stop::class.java) { Behaviors.stopped() }
        .onSignal(PostStop::class.java) {
            answers.leave(region.number)
            Behaviors.same()
        }
        .build()
}
