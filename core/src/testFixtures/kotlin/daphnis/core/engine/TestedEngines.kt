package daphnis.core.engine

import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.parallel.FixedPool

/**
 * The engines that the contracts run: all that [registry] knows. A module which registers an engine has it tested; one
 * whose engines have settings overrides [make], so that settings are drawn.
 */
open class TestedEngines(val registry: EngineFactory) {
    /** One engine of [name]. Where an engine may give way to the serial one, it does not. */
    open fun make(name: String, settings: EngineSettings): CollisionEngine = when (name) {
        "islands" -> IslandsEngine(FixedPool(settings.threads()), fewest = 0)
        "horizon" -> FixedPool(settings.threads()).let { pool ->
            HorizonEngine(pool, 0, tuning(settings), if (pool.threads == 1) null else IslandsEngine(pool, fewest = 0))
        }
        else -> checkNotNull(registry.create(name, settings.threads())) { "$name is registered, but cannot be made" }
    }

    protected fun tuning(settings: EngineSettings): HorizonTuning {
        val random = settings.random
        fun between(least: Double, most: Double) = least * Math.pow(most / least, random.nextDouble(0.0, 1.0))
        return HorizonTuning(
            steps = 1 + random.nextInt(MOST_STEPS),
            classBound = between(0.1, 5.0),
            deviation = if (random.nextInt(2) == 0) 0.0 else between(1e-3, 0.3),
            cellsAlong = between(0.3, 8.0),
            cellsAcross = between(0.3, 4.0),
        )
    }

    /** One of each but the serial one, which the others are compared with. */
    open fun others(settings: EngineSettings): List<CollisionEngine> =
        registry.names.filterNot(registry::isSpecification).map { make(it, settings) }

    private companion object {
        /** Of an epoch. */
        const val MOST_STEPS = 6
    }
}
