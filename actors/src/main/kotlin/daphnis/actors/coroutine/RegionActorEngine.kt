package daphnis.actors.coroutine

import daphnis.actors.region.RegionCommand
import daphnis.actors.region.RegionFailedException
import daphnis.actors.region.RegionLayout
import daphnis.actors.region.RegionMap
import daphnis.actors.region.RegionReply
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
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.asCoroutineDispatcher
import kotlinx.coroutines.cancel
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.currentCoroutineContext
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.util.concurrent.CancellationException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.Semaphore
import java.util.concurrent.atomic.AtomicInteger

/**
 * Regions of the grid owned by coroutines. Each region is a loop over a channel of commands, the coordinator a loop over a channel of answers; the step's
 * logic and the reason why nothing deadlocks are in [StepCoordinator].
 *
 * **Hand-over.** A region's state is touched by its coroutine alone while it handles a command, and by the coordinator only when all regions have
 * answered: *written by the region → answer sent → received → read by the coordinator*, and back with the next command. The code relies on what a
 * channel of kotlinx-coroutines gives: what happens before a send is seen after the receive that gets it.
 *
 * **Failure.** A region that throws fails the step, which is tried again once from the population, not written before the end; then [advance] throws
 * [RegionFailedException]. A [CollapseException] would come again and is thrown at once.
 *
 * **Interrupts and cancelling.** [advance] finishes its step though its thread is interrupted, and leaves the flag set. [advanceSuspending] ends soon after
 * its coroutine is cancelled, with the population as before. [close] from another thread ends a step under way in the same way, and waits for it.
 *
 * @param threads of the engine's own pool; only the number of workers to plan for when [dispatcher] is given
 * @param layout regions; chosen from the number of spheres and threads at the first step when null
 * @param dispatcher where regions run; not closed with the engine
 */
public class RegionActorEngine(override val threads: Int, private val layout: RegionLayout? = null, dispatcher: CoroutineDispatcher? = null) : CollisionEngine {
    override val name: String get() = "actors"

    init {
        require(threads in 1..ThreadHandler.MOST) { "threads is $threads; it must be in 1..${ThreadHandler.MOST}" }
    }

    private val pool: ExecutorService? = if (dispatcher == null) newPool(threads) else null
    private val dispatcher = dispatcher ?: pool!!.asCoroutineDispatcher()
    private val scope = CoroutineScope(SupervisorJob() + this.dispatcher)
    override val loop: RangeLoop = if (pool != null && threads > 1) ParallelLoop(ExecutorHandler(pool, threads), LoopStrategy.DYNAMIC) else InlineLoop

    /** Held while a step is under way. */
    private val stepping = Semaphore(1)
    private var actors: Actors? = null

    @Volatile
    private var current: StepCoordinator? = null

    @Volatile
    private var closed = false

    private class Actors(val coordinator: StepCoordinator) {
        /** One command at most: a region has answered the last before it gets the next. */
        val mailboxes = List(coordinator.map.count) { Channel<RegionCommand>(1) }

        /** One answer at most of each region. */
        val replies = Channel<RegionReply>(coordinator.map.count)
    }

    override fun advance(step: CollisionStep) {
        val done = CountDownLatch(1)
        var failure: Throwable? = null
        stepping.acquireUninterruptibly()
        try {
            val actors = actorsFor(step)
            scope.launch {
                try {
                    coordinate(actors, step)
                } catch (e: Throwable) {
                    failure = e
                } finally {
                    done.countDown()
                }
            }
            awaitUninterruptibly(done)
        } finally {
            stepping.release()
        }
        failure?.let { throw it }
    }

    /** [advance] for a coroutine that may be cancelled: then the population is as it was before the step. One caller at a time. */
    public suspend fun advanceSuspending(step: CollisionStep) {
        check(stepping.tryAcquire()) { "a step is under way" }
        try {
            val actors = actorsFor(step)
            withContext(dispatcher) { coordinate(actors, step) }
        } finally {
            stepping.release()
        }
    }

    private fun actorsFor(step: CollisionStep): Actors {
        check(!closed) { CLOSED }
        return actors ?: start(RegionMap(layout ?: RegionLayout.of(step.population.size, threads))).also { actors = it }
    }

    private fun start(map: RegionMap): Actors {
        val actors = Actors(StepCoordinator(map, loop))
        for (region in actors.coordinator.regions) {
            probe?.let { region.probe = it }
            scope.launch {
                for (command in actors.mailboxes[region.number]) {
                    val reply = try {
                        region.handle(command)
                    } catch (e: Throwable) {
                        RegionReply(region.number, command.phase, failure = e)
                    }
                    // There is room for one of each region, so this never fails, nor waits; a cancelled region still answers.
                    check(actors.replies.trySend(reply).isSuccess)
                }
            }
        }
        return actors
    }

    private suspend fun coordinate(actors: Actors, step: CollisionStep) {
        val first = attempt(actors, step) ?: return
        if (first is CollapseException || first is Error) throw first
        val second = attempt(actors, step) ?: return
        throw RegionFailedException("a region failed twice at the step from time ${step.start}: $second", second)
    }

    /** @return what a region threw, null when the step is done */
    private suspend fun attempt(actors: Actors, step: CollisionStep): Throwable? {
        val coordinator = actors.coordinator
        current = coordinator
        coordinator.begin(step)
        if (closed) coordinator.cancel()
        val job = currentCoroutineContext()[Job]
        // Not cancellable, since a receive that is cancelled may lose what it has received; the job is asked after every answer instead.
        try {
            withContext(NonCancellable) { exchange(actors) { job?.isActive != false } }
        } finally {
            current = null
        }
        currentCoroutineContext().ensureActive()
        if (coordinator.isCancelled) throw CancellationException(CLOSED)
        return coordinator.failure
    }

    private suspend fun exchange(actors: Actors, isWanted: () -> Boolean) {
        val coordinator = actors.coordinator
        while (true) {
            var command = coordinator.poll()
            while (command != null) {
                check(actors.mailboxes[command.region].trySend(command).isSuccess)
                command = coordinator.poll()
            }
            if (coordinator.isFinished) return
            val reply = actors.replies.receive()
            if (!isWanted()) coordinator.cancel()
            coordinator.accept(reply)
        }
    }

    /** Called by every region before each command; for tests. Set before the first step. */
    internal var probe: ((RegionCommand) -> Unit)? = null

    override fun close() {
        closed = true
        current?.cancel()
        stepping.acquireUninterruptibly()
        try {
            actors?.mailboxes?.forEach { it.close() }
            scope.cancel()
            pool?.shutdown()
        } finally {
            stepping.release()
        }
    }

    private companion object {
        const val CLOSED = "the engine is closed"

        fun newPool(threads: Int): ExecutorService {
            val number = AtomicInteger()
            return Executors.newFixedThreadPool(threads) { Thread(it, "daphnis-actors-${number.incrementAndGet()}").apply { isDaemon = true } }
        }

        fun awaitUninterruptibly(latch: CountDownLatch) {
            var interrupted = false
            while (latch.count > 0) {
                try {
                    latch.await()
                } catch (e: InterruptedException) {
                    interrupted = true
                }
            }
            if (interrupted) Thread.currentThread().interrupt()
        }
    }
}
