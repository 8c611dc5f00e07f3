package daphnis.app

import daphnis.actors.ActorEngines
import daphnis.core.engine.CombinedEngines
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.named.Engines

/** All engines there are, by name. */
internal val allEngines: EngineFactory = CombinedEngines(Engines, ActorEngines)
