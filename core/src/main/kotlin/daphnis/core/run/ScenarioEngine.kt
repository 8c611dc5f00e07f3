@file:JvmName("ScenarioEngine")

package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import daphnis.core.scenario.ScenarioParts

/** What to write in place of [name], which is that of no engine of [engines]. */
@JvmName("adviceOn")
public fun adviceOn(name: String, engines: EngineFactory): String =
    engines.successor(name) ?: "${Nearest.question(name, engines.names)}known: ${engines.names.joinToString()}"

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
            "is \"${spec.name}\"; ${adviceOn(spec.name, engines)}",
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
