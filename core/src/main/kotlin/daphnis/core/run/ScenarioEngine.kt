@file:JvmName("ScenarioEngine")

package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Nearest
import daphnis.core.scenario.ScenarioParts

/**
 * The engine that [scenario] asks for.
 *
 * @throws InputException when [engines] has none of that name and number of threads
 */
@JvmOverloads
@JvmName("of")
public fun engineOf(scenario: ScenarioParts, source: String, engines: EngineFactory = Engines): CollisionEngine {
    val spec = scenario.engine
    val engine = engines.create(spec.name, spec.threads)
        ?: throw InputException(
            source,
            "engine.name",
            "is \"${spec.name}\"; ${Nearest.question(spec.name, engines.names.toList())}" +
                "known: ${engines.names.joinToString()}",
        )
    if (spec.threads != 0 && engine.threads != spec.threads) {
        engine.close()
        throw InputException(
            source,
            "engine.threads",
            "is ${spec.threads}; the ${spec.name} engine works on ${engine.threads}",
        )
    }
    return engine
}
