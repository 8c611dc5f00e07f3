package daphnis.app

import daphnis.analysis.sweep.SweepRun
import daphnis.app.printing.reasonInWords
import daphnis.app.sweep.PlannedRun
import daphnis.app.sweep.SharedCores
import daphnis.app.sweep.SweepOrder
import daphnis.app.sweep.SweepWork
import daphnis.core.parallel.Cores
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors

/**
 * Carries out runs of a sweep, some at a time, until all are done or somebody interrupts them.
 *
 * @param jobs runs at a time; null for one per core
 * @param from averages begin at this time; null for three eighths of each run
 */
internal class SweepRuns(
    private val order: SweepOrder,
    private val jobs: Int?,
    private val from: Double?,
    private val quiet: Boolean,
) {
    /**
     * What has come of runs.
     *
     * @property done those that ended, well or not, in the order of the plan
     * @property busy how many of them other processes are at
     * @property isInterrupted whether somebody wants the program to end
     */
    class Outcome(val done: List<SweepRun>, val busy: Int, val isInterrupted: Boolean)

    /** Carries out [runs], or goes on with them, and then calls [conclude] before an interrupted program may end. */
    fun carryOut(runs: List<PlannedRun>, conclude: (Outcome) -> Unit) {
        val together = minOf(jobs ?: Cores.ofJob, maxOf(1, runs.size))
        val progress = SweepProgress(quiet, runs.size)
        val interruption = Interruption()
        preparePlot()
        try {
            val work = work(progress, maxOf(1, Cores.ofJob / together)) { interruption.requested }
            interruption.armed = true
            val results = inParallel(runs, together) { run ->
                progress.begun(run)
                work.carryOut(run).also { progress.ended(run, it) }
            }
            progress.clear()
            conclude(Outcome(results.filterNotNull(), progress.busy, interruption.requested))
        } finally {
            interruption.done()
        }
    }

    /** Those of [runs] that are finished, with their numbers, and those that are not this sweep's; begins none. */
    fun collect(runs: List<PlannedRun>): List<SweepRun> {
        val progress = SweepProgress(quiet = true, runs.size)
        val work = work(progress, threads = 1) { false }
        return inParallel(runs, minOf(jobs ?: Cores.ofJob, maxOf(1, runs.size)), work::collected).filterNotNull()
    }

    private fun work(progress: SweepProgress, threads: Int, cancelled: () -> Boolean) = SweepWork(
        order.place,
        SharedCores(allEngines, threads),
        order::scenarioOf,
        order.title,
        from,
        progress,
        ::reasonInWords,
        ::drawPlot,
        cancelled,
    )

    /** What [act] makes of each of [runs], in their order, [together] at a time. */
    private fun inParallel(runs: List<PlannedRun>, together: Int, act: (PlannedRun) -> SweepRun?): List<SweepRun?> {
        val pool = Executors.newFixedThreadPool(together) { Thread(it, "daphnis-sweep").apply { isDaemon = true } }
        try {
            return runs.map { pool.submit(Callable { act(it) }) }.map { it.get() }
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } finally {
            pool.shutdownNow()
        }
    }
}
