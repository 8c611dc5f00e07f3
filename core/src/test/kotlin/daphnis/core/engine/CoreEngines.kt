package daphnis.core.engine

import daphnis.core.Engines
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ThreadHandler
import daphnis.core.parallel.ThreadPerTask
import daphnis.core.search.GridSort

/** The engines of this module, with every way to spread loops and to sort into cells. */
internal object CoreEngines : TestedEngines(Engines) {
    override fun make(name: String, settings: EngineSettings): CollisionEngine = when (name) {
        "thread-pool" -> {
            val random = settings.random
            val handler: ThreadHandler = if (random.nextInt(4) == 0) {
                ThreadPerTask(1 + random.nextInt(3))
            } else {
                FixedPool(settings.threads())
            }
            ThreadPoolEngine(handler, LoopStrategy.entries[random.nextInt(3)], GridSort.entries[random.nextInt(2)])
        }
        else -> super.make(name, settings)
    }
}
