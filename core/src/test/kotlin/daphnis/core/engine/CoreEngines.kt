package daphnis.core.engine

import daphnis.core.Engines
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.LineFilter
import daphnis.core.engine.lists.ListTuning
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

    override fun others(settings: EngineSettings): List<CollisionEngine> = super.others(settings) + lists()

    /** `horizon` as it takes dense steps of few spheres, wherever that is possible. */
    fun lists(): HorizonEngine =
        HorizonEngine(FixedPool(1), HorizonSteps.WORTH_SPHERES, null, LineFilter.BEST, ListTuning.ALWAYS, null, null)
}
