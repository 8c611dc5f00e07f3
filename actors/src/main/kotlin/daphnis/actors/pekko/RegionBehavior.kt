package daphnis.actors.pekko

import daphnis.actors.region.Region
import daphnis.actors.region.RegionCommand
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.javadsl.Behaviors

/** An actor that owns a region. It handles a command and answers; what goes wrong it throws, which stops it and is its parent's to mend. */
internal object RegionBehavior {
    fun create(region: Region, coordinator: ActorRef<CoordinatorBehavior.Message>): Behavior<RegionCommand> = Behaviors.receiveMessage { command ->
        coordinator.tell(CoordinatorBehavior.Replied(region.handle(command)))
        Behaviors.same()
    }
}
