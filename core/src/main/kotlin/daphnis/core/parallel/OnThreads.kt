package daphnis.core.parallel

/**
 * Does [work] over [spheres] once, on [threads] that are started for it where it is worth that. They are told to end
 * before this returns, and not waited for.
 */
internal inline fun <T> onThreads(threads: Int, spheres: Int, work: (RangeLoop) -> T): T =
    if (threads == 1 || spheres < LEAST_FOR_THREADS) {
        work(InlineLoop)
    } else {
        FixedPool(threads).use { work(ParallelLoop(it, LoopStrategy.DYNAMIC)) }
    }

/** With less than some milliseconds of work, threads are not worth starting. */
private const val LEAST_FOR_THREADS = 20_000
