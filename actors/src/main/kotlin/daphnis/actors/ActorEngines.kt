package daphnis.actors

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory

/** The engines of this module. `ActorEngines` alone is their factory; in Java [factory]. */
public class ActorEngines private constructor() {
    public companion object : EngineFactory {
        private val makers = linkedMapOf<String, (threads: Int) -> CollisionEngine>(
            "actors" to { RegionActorEngine(it) },
            "pekko" to { PekkoEngine(it) },
        )

        @JvmStatic
        override val names: List<String> = makers.keys.toList()

        @JvmStatic
        override fun create(name: String, threads: Int): CollisionEngine? =
            makers[name]?.invoke(EngineFactory.threadsOrAll(threads))

        /** The factory itself, for Java. */
        @JvmStatic
        public fun factory(): EngineFactory = this
    }
}
