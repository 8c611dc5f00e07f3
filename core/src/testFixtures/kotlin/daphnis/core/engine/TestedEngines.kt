package daphnis.core.engine

import daphnis.core.engine.bricks.BrickDivision
import daphnis.core.engine.bricks.BricksEngine
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
        "bricks" -> BricksEngine(FixedPool(settings.threads()), fewest = 0, division = division(settings))
        else -> checkNotNull(registry.create(name, settings.threads())) { "$name is registered, but cannot be made" }
    }

    private fun division(settings: EngineSettings): BrickDivision {
        fun parts() = 1 + settings.random.nextInt(MOST_PARTS)
        return BrickDivision(parts(), parts(), parts())
    }

    /** One of each but the serial one, which the others are compared with. */
    fun others(settings: EngineSettings): List<CollisionEngine> =
        registry.names.filter { it != "serial" }.map { make(it, settings) }

    private companion object {
        /** Into which an engine of bricks cuts space along an axis. */
        const val MOST_PARTS = 3
    }
}
