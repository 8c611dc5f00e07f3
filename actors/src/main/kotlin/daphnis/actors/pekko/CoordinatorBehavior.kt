package daphnis.actors.pekko

import daphnis.actors.region.Phase
import daphnis.actors.region.Region
import daphnis.actors.region.RegionCommand
import daphnis.actors.region.RegionFailedException
import daphnis.actors.region.RegionMap
import daphnis.actors.region.RegionReply
import daphnis.actors.region.StepCoordinator
import daphnis.core.engine.CollapseException
import daphnis.core.engine.CollisionStep
import daphnis.core.parallel.RangeLoop
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.ChildFailed
import org.apache.pekko.actor.typed.MailboxSelector
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior
import org.apache.pekko.actor.typed.javadsl.ActorContext
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.apache.pekko.actor.typed.javadsl.Receive
import java.util.concurrent.CancellationException
import java.util.concurrent.CompletableFuture

/**
 * The coordinator and parent of the region actors. A region that throws is stopped; its parent hears of it ([ChildFailed]), puts a new actor in its
 * place and counts the step as failed, which is tried again once.
 *
 * Pekko guarantees that what an actor did before a send is seen by the receiver, and what it did for one message when it handles the next.
 */
internal class CoordinatorBehavior private constructor(
    context: ActorContext<Message>,
    map: RegionMap,
    loop: RangeLoop,
    probe: ((RegionCommand) -> Unit)?,
    private val published: (StepCoordinator) -> Unit,
) : AbstractBehavior<CoordinatorBehavior.Message>(context) {
    /** What a coordinator understands. */
    sealed interface Message

    /** Do [step] and complete [done]: normally, or with what went wrong. */
    class Begin(val step: CollisionStep, val done: CompletableFuture<Void?>) : Message

    /** A region has answered. */
    class Replied(val reply: RegionReply) : Message

    /** End, with all regions. */
    object Stop : Message

    private val coordinator = StepCoordinator(map, loop)
    private val actors = arrayOfNulls<ActorRef<RegionCommand>>(map.count)

    /** What each region is busy with, null when it has answered. */
    private val busyWith = arrayOfNulls<Phase>(map.count)
    private var spawned = 0
    private var begun: Begin? = null
    private var isSecond = false

    init {
        for (region in coordinator.regions) {
            probe?.let { region.probe = it }
            spawn(region)
        }
        published(coordinator)
    }

    private fun spawn(region: Region) {
        // A mailbox for two: the command at hand and none more, with room for what the system itself sends.
        val actor = context.spawn(RegionBehavior.create(region, context.self), "region-${region.number}-${spawned++}", MailboxSelector.bounded(2))
        context.watch(actor)
        actors[region.number] = actor
    }

    override fun createReceive(): Receive<Message> = newReceiveBuilder()
        .onMessage(Begin::class.java, ::onBegin)
        .onMessage(Replied::class.java, ::onReplied)
        .onMessage(Stop::class.java) { Behaviors.stopped() }
        .onSignal(ChildFailed::class.java, ::onChildFailed)
        .build()

    private fun onBegin(message: Begin): Behavior<Message> {
        begun = message
        isSecond = false
        guarded { attempt() }
        return this
    }

    private fun onReplied(message: Replied): Behavior<Message> {
        busyWith[message.reply.region] = null
        guarded { coordinator.accept(message.reply) }
        goOn()
        return this
    }

    private fun onChildFailed(signal: ChildFailed): Behavior<Message> {
        val region = actors.indexOfFirst { it == signal.ref }
        spawn(coordinator.regions[region])
        val phase = busyWith[region] ?: return this
        busyWith[region] = null
        guarded { coordinator.accept(RegionReply(region, phase, failure = signal.cause)) }
        goOn()
        return this
    }

    private fun attempt() {
        coordinator.begin(begun!!.step)
        goOn()
    }

    private fun goOn() {
        if (begun == null) return
        var command = coordinator.poll()
        while (command != null) {
            busyWith[command.region] = command.phase
            actors[command.region]!!.tell(command)
            command = coordinator.poll()
        }
        if (coordinator.isFinished) finish()
    }

    private fun finish() {
        val failure = coordinator.failure
        val start = begun!!.step.start
        when {
            coordinator.isCancelled -> complete(CancellationException("the engine is closed"))
            failure == null -> complete(null)
            failure is CollapseException || failure is Error -> complete(failure)
            isSecond -> complete(RegionFailedException("a region failed twice at the step from time $start: $failure", failure))
            else -> {
                isSecond = true
                guarded { attempt() }
            }
        }
    }

    private fun complete(failure: Throwable?) {
        val done = begun!!.done
        begun = null
        if (failure == null) done.complete(null) else done.completeExceptionally(failure)
    }

    /** What the coordinator's own work throws ends the step, not the actor. */
    private inline fun guarded(work: () -> Unit) {
        try {
            work()
        } catch (e: Exception) {
            if (begun == null) throw e
            complete(e)
        }
    }

    companion object {
        /** @param published is told the coordinator's logic, whose `cancel` may be called from any thread */
        fun create(map: RegionMap, loop: RangeLoop, probe: ((RegionCommand) -> Unit)?, published: (StepCoordinator) -> Unit): Behavior<Message> =
            Behaviors.setup { CoordinatorBehavior(it, map, loop, probe, published) }
    }
}
