package daphnis.actors

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory

/** The engines of this module. */
public object ActorEngines : EngineFactory {
    override val names: List<String> = listOf("actors", "pekko")

    override fun create(name: String, threads: Int): CollisionEngine? = when (name) {
        "actors" -> RegionActorEngine(EngineFactory.threadsOrAll(threads))
        "pekko" -> PekkoEngine(EngineFactory.threadsOrAll(threads))
        else -> null
    }
}
