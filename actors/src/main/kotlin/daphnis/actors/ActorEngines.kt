package daphnis.actors

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory

/** The engines of this module. */
public object ActorEngines : EngineFactory {
    private val makers = linkedMapOf<String, (threads: Int) -> CollisionEngine>(
        "actors" to { RegionActorEngine(it) },
        "pekko" to { PekkoEngine(it) },
    )

    override val names: List<String> = makers.keys.toList()

    override fun create(name: String, threads: Int): CollisionEngine? =
        makers[name]?.invoke(EngineFactory.threadsOrAll(threads))
}
