package daphnis.core.engine.threadpool

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.search.GridSort
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact.End
import daphnis.core.step.PreparedStep
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference

/**
 * Section 4 of Lewis & Massingill: a thread handler runs the loops of a step in parallel, and then one loop per worker.
 * A worker takes the next safe collision from the synchronised queue, processes it and queues what follows from it. It
 * waits while none is safe, and ends when the queue is empty and no worker works.
 *
 * **Why that alone is not enough for the same bits, and what is done.** Collisions are processed at the same time only
 * when they are too far apart to see one another ([BusyCells]). Three points remain.
 * 1. *Overtaking*: collision F is unsafe and passed over, and a later one E near F is taken. Therefore a collision that
 *    has been passed over is busy as well ([SafeQueue]).
 * 2. *Chains*: E was far from all busy collisions when it was taken, but an earlier collision, by way of others that it
 *    led to, reaches E's spheres at a time before E. Nothing can rule that out, since in a dense row an impulse travels
 *    arbitrarily fast; so it is detected. The last link of such a chain, G, is found by searching from a sphere c that
 *    collided at some t_c ≤ t_G. When c searches, E has been processed already: otherwise G would be queued before E
 *    and be taken first. E's sphere is in the cells that c searches, since it can really be hit, and its local time is
 *    t_E > t_G ≥ t_c. So: **a search which meets a sphere with the same or a later local time checks whether it would
 *    have hit the path that this sphere has left**. If so, the search has come too late and the step is void. The
 *    serial engine redoes it from the population, which has not been written, and it is counted in `causalityReplays`.
 *    If not, the later collision was right, and later collisions of the two are found from their paths as they are.
 * 3. *Cost*: that test would slow down every search. But when a sphere in sight has a later local time, its collision
 *    was taken before this one, since two collisions that are busy together are out of each other's sight. It was also
 *    taken early: while an earlier one was being processed, or after one was passed over. Otherwise it was the first of
 *    all there were. So only a collision that comes after an early one (`isLate`) needs the test. One worker alone
 *    never does.
 *
 * Simultaneous collisions are never busy together: they are done one after the other in the order of the queue.
 *
 * Hence in a step that is not void every collision saw the predecessors that it has in the serial order. In a void step
 * anything that happens may be false. So a collapse or a refusal in it is not passed on; the step is left to the serial
 * engine as well.
 *
 * @param handler the threads; closed with the engine
 * @param strategy of the loops over spheres; the first search is always dynamic, as in the paper
 * @param gridSort how the grid is built
 */
public class ThreadPoolEngine @JvmOverloads constructor(
    private val handler: ThreadHandler,
    strategy: LoopStrategy = LoopStrategy.CHUNKS,
    gridSort: GridSort = GridSort.ROW_LOCKS,
) : CollisionEngine {
    public constructor(threads: Int) : this(FixedPool(threads))

    override val name: String get() = "thread-pool"
    override val threads: Int get() = handler.threads
    private val gate = ClosableLoop(ParallelLoop(handler, strategy), CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate
    private val dynamic = ParallelLoop(handler, LoopStrategy.DYNAMIC)

    private val prepared = PreparedStep(gridSort)
    private val busy = BusyCells(prepared.rows, prepared.grid)
    private val queue = SafeQueue(busy, prepared.limits)
    private val last = LastCollisions()
    private val workers = Array(threads) { PoolWorker(prepared, last) }
    private val replay = SerialEngine(prepared = prepared)

    private val failedWith = AtomicReference(End.DONE)
    private val failedWorker = AtomicInteger()

    private var redone = 0

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        redone = 0
        val isDone = try {
            advanceTogether(step)
        } catch (e: Exception) {
            if (gate.isClosed) throw e
            false
        }
        if (isDone) {
            finish(step)
        } else {
            replay.advance(step)
            step.counters.causalityReplays++
        }
        step.counters.redoneSteps += redone
    }

    /** @return false when the step is void; the population has not been written */
    private fun advanceTogether(step: CollisionStep): Boolean {
        prepared.measure(step, loop)
        while (true) {
            when (attempt(step)) {
                End.DONE -> return true
                End.VOID -> return false
                End.OUTRUN -> {
                    if (++redone > MOST_REDONE) return false
                    val outran = workers[failedWorker.get()].taken
                    prepared.enlarge(prepared.rows, outran.first, outran.second)
                }
            }
        }
    }

    private fun finish(step: CollisionStep) {
        writeRecord(step)
        prepared.store(loop)
        for (worker in workers) step.counters.add(worker.counted)
    }

    private fun writeRecord(step: CollisionStep) {
        val record = step.record ?: return
        record.clear()
        for (worker in workers) record.addAll(worker.record, 0, worker.record.size)
        record.sort()
    }

    private fun attempt(step: CollisionStep): End {
        failedWith.set(End.DONE)
        prepared.prepare(loop)
        val rows = prepared.rows
        busy.prepare(step.population)
        queue.reset(step.duration, rows.id, rows.size)
        last.reset(rows.size)
        for (worker in workers) worker.beginStep(step)
        dynamic.run(rows.size, SPHERES_A_PIECE) { worker, from, to -> workers[worker].searchStart(from, to) }
        for (worker in workers) queue.addAll(worker.found.events)
        handler.run { worker -> processSafe(worker) }
        return failedWith.get()
    }

    /** The loop of one worker. */
    private fun processSafe(number: Int) {
        val worker = workers[number]
        try {
            while (queue.take(worker.taken)) {
                val end = worker.processTaken()
                if (end == End.DONE) {
                    queue.finish(worker.taken, worker.found.events)
                } else {
                    if (failedWith.compareAndSet(End.DONE, end)) failedWorker.set(number)
                    queue.stop()
                }
            }
        } catch (e: Throwable) {
            // The other workers wait for this one's collision, which will never be returned.
            queue.stop()
            throw e
        }
    }

    override fun close() {
        gate.close()
        handler.close()
    }

    private companion object {
        const val SPHERES_A_PIECE = 512
        const val MOST_REDONE = 30
    }
}
