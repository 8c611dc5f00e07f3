package daphnis.core.engine.islands

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.QuickerWay
import daphnis.core.engine.SerialEngine
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * The fast engine: islands of spheres that meet no other sphere within a window of time, each processed alone by one
 * worker without locks. See [IslandField] for why its bits are those of the serial engine, and [IslandWorkers] for the
 * phases of a step.
 *
 * In dense gases and long steps islands would grow into one another; then windows get shorter, which changes no bit.
 * Islands are handed out as workers become free, so it does not matter where in space they lie. On one thread and with
 * few spheres, where it is quicker, the engine takes steps in the serial engine's way.
 *
 * Islands are guesses until they are checked. A guess may end with a collapse, a step that would be refused, too much
 * memory, or an exception from the laws of the collision. The step is then left to the serial engine, whose result is
 * the result, and is counted in `causalityReplays`.
 *
 * @param handler the threads; closed with the engine
 * @param fewest the least number of spheres with which islands are grown; 0 always grows them, also on one thread
 */
public class IslandsEngine @JvmOverloads constructor(
    private val handler: ThreadHandler,
    private val fewest: Int = WORTH_SPHERES,
) : CollisionEngine {
    public constructor(threads: Int) : this(FixedPool(threads))

    override val name: String get() = "islands"
    override val threads: Int get() = handler.threads
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate

    private val prepared = PreparedStep()
    private val field = IslandField(threads, prepared)

    /** For statistics of windows and islands. */
    public val workers: IslandWorkers = IslandWorkers(field, threads)

    private val alone = SerialEngine(prepared = prepared)
    private val quicker = QuickerWay(longArrayOf(QuickerWay.MEASURED, QuickerWay.MEASURED))
    private var failed = false

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        if (isQuickerAlone(step)) {
            alone.advance(step)
        } else if (fewest == 0) {
            if (!grow(step)) goAlone(step)
        } else if (quicker.choose(WAYS) == SERIAL) {
            alone.advance(step)
            quicker.finish(begins = true, ends = true)
        } else if (grow(step)) {
            quicker.finish(begins = true, ends = true)
        } else {
            goAlone(step)
            quicker.giveUp()
        }
    }

    /** The step after islands were given up. */
    private fun goAlone(step: CollisionStep) {
        alone.advance(step)
        if (failed) step.counters.causalityReplays++
    }

    /** @return false when it was given up, because it takes too long or has failed; then nothing has changed */
    private fun grow(step: CollisionStep): Boolean {
        failed = false
        val redone = try {
            growUntilNobodyOutruns(step)
        } catch (e: Exception) {
            if (gate.isClosed) throw e
            failed = true
            LATE
        }
        if (redone == LATE) return false
        workers.writeTo(step.record)
        field.store(loop)
        step.counters.redoneSteps += redone
        workers.addTo(step.counters)
        return true
    }

    /** @return how often the step had to be begun again, or [LATE] */
    private fun growUntilNobodyOutruns(step: CollisionStep): Int {
        var redone = 0
        field.measure(step, loop)
        while (!attempt()) {
            if (quicker.isLate) return LATE
            redone++
            field.enlarge()
        }
        return redone
    }

    /** Few spheres are not worth the barriers. On one thread islands only add work. */
    private fun isQuickerAlone(step: CollisionStep): Boolean =
        fewest != 0 && (threads == 1 || step.population.size < fewest)

    /** @return false when a sphere went beyond the bound, or when it is late */
    private fun attempt(): Boolean {
        field.prepare(loop)
        workers.prepare()
        loop.run(field.size, SPHERES_A_PIECE) { worker, from, to -> workers[worker].searchStart(from, to) }
        while (!workers.isLastWindow) {
            val seeds = workers.openWindow()
            if (seeds == 0) continue
            // Too few to be worth waking another thread.
            val alone = threads == 1 || seeds < LEAST_IN_PARALLEL
            if (!window(alone) || quicker.isLate) return false
        }
        return true
    }

    private fun window(alone: Boolean): Boolean {
        each(alone) { workers.propose(it) }
        each(alone) { workers[it].group() }
        workers.collectRoots()
        do {
            if (!process(alone)) return false
            each(alone) { workers[it].check() }
            if (quicker.isLate) return false
        } while (workers.mergeConflicts())
        each(alone) { workers[it].commit() }
        if (!workers.isLastWindow) each(alone) { workers[it].hintSuspects() }
        workers.closeWindow()
        return true
    }

    private fun process(alone: Boolean): Boolean {
        val count = workers.rootCount
        val grain = if (alone) count else (count / (threads * PIECES_A_THREAD)).coerceIn(1, MOST_A_PIECE)
        loop.run(count, maxOf(grain, 1)) { worker, from, to -> processSome(workers[worker], from, to) }
        return !field.isOutrun
    }

    private fun processSome(worker: IslandWorker, from: Int, to: Int) {
        try {
            for (k in from until to) if (!worker.process(workers.root(k))) return
        } catch (e: Throwable) {
            // The step has failed; the work of the other workers is not needed.
            field.stop()
            throw e
        }
    }

    private inline fun each(alone: Boolean, crossinline phase: (Int) -> Unit) {
        if (alone) {
            for (worker in 0 until threads) phase(worker)
        } else {
            handler.run { phase(it) }
        }
    }

    override fun close() {
        gate.close()
        handler.close()
    }

    internal companion object {
        private const val LATE = -1

        // Ways of taking a step.
        private const val SERIAL = 0
        private const val GROWN = 1
        private val WAYS = intArrayOf(GROWN, SERIAL)

        /** Spheres from which on islands can pay. */
        const val WORTH_SPHERES = 10_000
        private const val SPHERES_A_PIECE = 512
        private const val LEAST_IN_PARALLEL = 64
        private const val PIECES_A_THREAD = 8
        private const val MOST_A_PIECE = 64
    }
}
