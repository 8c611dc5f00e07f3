package daphnis.actors.pekko

import daphnis.actors.region.Answers
import daphnis.actors.region.Region
import daphnis.actors.region.RegionCommand
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.PostStop
import org.apache.pekko.actor.typed.javadsl.Behaviors

/**
 * An actor that owns a region: it handles a command and answers, also when it fails. Its end, however it comes, is told
 * to the coordinator.
 *
 * Pekko guarantees that what was done before a send is seen by the receiver, and what an actor did for one message when
 * it handles the next.
 */
internal object RegionBehavior {
    /** What a region's actor understands. */
    sealed interface Message

    /** Do [command] and answer it. */
    class Handle(val command: RegionCommand) : Message

    /** End. */
    object Stop : Message

    fun create(region: Region, answers: Answers): Behavior<Message> = Behaviors.receive(Message::class.java)
        .onMessage(Handle::class.java) {
            region.serve(it.command, answers)
            Behaviors.same()
        }
        .onMessage(Stop::class.java) { Behaviors.stopped() }
        .onSignal(PostStop::class.java) {
            answers.leave(region.number)
            Behaviors.same()
        }
        .build()
}
