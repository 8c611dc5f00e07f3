package daphnis.bench

import daphnis.actors.ActorEngines
import daphnis.core.Engines
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.parallel.ExecutorHandler
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ThreadPerTask
import daphnis.core.queue.ReferenceEventQueue
import daphnis.core.search.GridSort
import java.util.concurrent.Executor
import java.util.concurrent.Executors
import java.util.concurrent.ForkJoinPool

/** All competitors, one parameter. Those that work on one thread only ignore the number of threads. */
enum class EngineName(private val make: (Int) -> CollisionEngine) {
    SERIAL({ SerialEngine() }),
    HORIZON({ Engines.horizon(it) }),
    ISLANDS({ IslandsEngine(it) }),

    /** The reference: the paper's engine on a fixed pool, consecutive chunks, row-locked grid. */
    THREAD_POOL({ ThreadPoolEngine(it) }),
    ACTORS({ ActorEngines.create("actors", it)!! }),
    PEKKO({ ActorEngines.create("pekko", it)!! }),

    /** The serial engine with a sorted set as queue: shows the gain of the bucketed queue. */
    SERIAL_SORTED_SET({ SerialEngine(ReferenceEventQueue()) }),

    /** The paper's remarks: a new thread for every task. */
    THREAD_POOL_NEW_THREADS({ ThreadPoolEngine(ThreadPerTask(it)) }),

    /** Tasks of the JDK's work-stealing pool. */
    THREAD_POOL_FORK_JOIN({ ThreadPoolEngine(ExecutorHandler(ForkJoinPool.commonPool(), it)) }),

    /** A new virtual thread for every task; needs JDK 21. */
    THREAD_POOL_VIRTUAL({ ThreadPoolEngine(ExecutorHandler(virtualThreads(), it)) }),

    /** The paper's remarks: loops dealt round robin. */
    THREAD_POOL_ROUND_ROBIN({ ThreadPoolEngine(FixedPool(it), LoopStrategy.ROUND_ROBIN) }),

    /** The paper's remarks: loops dealt as workers become free. */
    THREAD_POOL_DYNAMIC({ ThreadPoolEngine(FixedPool(it), LoopStrategy.DYNAMIC) }),

    /** The paper's remarks: the grid built without locks. */
    THREAD_POOL_COUNTING_SORT({ ThreadPoolEngine(FixedPool(it), gridSort = GridSort.COUNTING) }),
    ;

    fun create(threads: Int): CollisionEngine = make(threads)
}

/** By reflection, since the library is compiled for JDK 17. */
private fun virtualThreads(): Executor = try {
    Executors::class.java.getMethod("newVirtualThreadPerTaskExecutor").invoke(null) as Executor
} catch (e: NoSuchMethodException) {
    throw UnsupportedOperationException("virtual threads need JDK 21 or newer", e)
}
