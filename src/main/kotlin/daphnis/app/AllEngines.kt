package daphnis.app

import daphnis.actors.ActorEngines
import daphnis.core.Engines
import daphnis.core.engine.CombinedEngines
import daphnis.core.engine.EngineFactory

/** All engines there are, by name. */
internal val allEngines: EngineFactory = CombinedEngines(Engines, ActorEngines)
