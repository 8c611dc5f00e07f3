package daphnis.actors.pekko

import com.typesafe.config.ConfigFactory
import daphnis.actors.region.RegionCommand
import daphnis.actors.region.RegionFailedException
import daphnis.actors.region.RegionLayout
import daphnis.actors.region.RegionMap
import daphnis.actors.region.StepCoordinator
import daphnis.core.engine.CollapseException
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionStep
import daphnis.core.parallel.ExecutorHandler
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import org.apache.pekko.actor.typed.ActorRef
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.DispatcherSelector
import org.apache.pekko.actor.typed.Props
import org.apache.pekko.actor.typed.javadsl.Behaviors
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.Semaphore
import java.util.concurrent.atomic.AtomicInteger

/**
 * The region protocol of [StepCoordinator] on Apache Pekko typed actors: a coordinator and its children, the regions. A failing region is stopped and
 * replaced by its parent, and the step tried again once; then [advance] throws [RegionFailedException].
 *
 * [advance] blocks its caller, so call it from a thread that no actor of the system needs. It finishes its step though its thread is
 * interrupted. [close] ends a step under way, with the population as before, stops the actors and, if it is the engine's own, the actor system.
 *
 * @param threads of the engine's own actor system; only the number of workers to plan for when [host] is given
 * @param layout regions; chosen from the number of spheres and threads at the first step when null
 * @param host an actor system to live in; the engine's actors are system actors there and run on its default dispatcher. When null, the engine
 *   makes one of its own at the first step
 */
public class PekkoEngine(override val threads: Int, private val layout: RegionLayout? = null, private val host: ActorSystem<*>? = null) : CollisionEngine {
    override val name: String get() = "pekko"

    init {
        require(threads in 1..ThreadHandler.MOST) { "threads is $threads; it must be in 1..${ThreadHandler.MOST}" }
    }

    private val stepping = Semaphore(1)
    private var own: ActorSystem<Void>? = null
    private var actor: ActorRef<CoordinatorBehavior.Message>? = null

    @Volatile
    private var logic: StepCoordinator? = null

    @Volatile
    private var closed = false

    /** Called by every region before each command; for tests. Set before the first step. */
    internal var probe: ((RegionCommand) -> Unit)? = null

    override val loop: RangeLoop = if (host == null && threads > 1) {
        ParallelLoop(ExecutorHandler({ ownSystem().dispatchers().lookup(DispatcherSelector.defaultDispatcher()).execute(it) }, threads), LoopStrategy.DYNAMIC)
    } else {
        InlineLoop
    }

    override fun advance(step: CollisionStep) {
        stepping.acquireUninterruptibly()
        try {
            check(!closed) { "the engine is closed" }
            val actor = actor ?: start(RegionMap(layout ?: RegionLayout.of(step.population.size, threads))).also { actor = it }
            val done = CompletableFuture<Void?>()
            uninterruptibly { actor.tell(CoordinatorBehavior.Begin(step, done)) }
            try {
                uninterruptibly { done.get() }
            } catch (e: ExecutionException) {
                throw e.cause ?: e
            }
        } finally {
            stepping.release()
        }
    }

    private fun start(map: RegionMap): ActorRef<CoordinatorBehavior.Message> {
        // The coordinator itself holds one thread of the dispatcher while its loops run, and the regions are idle then.
        val behavior = CoordinatorBehavior.create(map, loop, probe) { logic = it }
        return (host ?: ownSystem()).systemActorOf(behavior, "daphnis-${ENGINES.incrementAndGet()}", Props.empty())
    }

    private fun ownSystem(): ActorSystem<Void> {
        // It does not start on an interrupted thread.
        if (own == null) uninterruptibly { own = newSystem() }
        return own!!
    }

    private fun newSystem(): ActorSystem<Void> = ActorSystem.create(
        Behaviors.empty<Void>(),
        "daphnis",
        ConfigFactory.parseMap(
            mapOf(
                "pekko.loglevel" to "WARNING",
                "pekko.stdout-loglevel" to "WARNING",
                "pekko.daemonic" to "on",
                "pekko.jvm-exit-on-fatal-error" to "off",
                "pekko.coordinated-shutdown.run-by-jvm-shutdown-hook" to "off",
                "pekko.actor.default-dispatcher.executor" to "thread-pool-executor",
                "pekko.actor.default-dispatcher.thread-pool-executor.fixed-pool-size" to threads,
                "pekko.actor.default-dispatcher.throughput" to 1,
            ),
        ).withFallback(ConfigFactory.load(PekkoEngine::class.java.classLoader)),
    )

    /** Does [work], again when an interrupt broke it off, and leaves the interrupt set. Also a message to an actor that is just starting can break off. */
    private inline fun uninterruptibly(work: () -> Unit) {
        var interrupted = Thread.interrupted()
        try {
            while (true) {
                try {
                    work()
                    return
                } catch (e: InterruptedException) {
                    interrupted = true
                }
            }
        } finally {
            if (interrupted) Thread.currentThread().interrupt()
        }
    }

    /** Throws nothing; see the class. A [CollapseException] or another failure of the last step was thrown there. */
    override fun close() {
        closed = true
        logic?.cancel()
        stepping.acquireUninterruptibly()
        try {
            uninterruptibly { actor?.tell(CoordinatorBehavior.Stop) }
            actor = null
            own?.terminate()
            own = null
        } finally {
            stepping.release()
        }
    }

    private companion object {
        val ENGINES = AtomicInteger()
    }
}
