package daphnis.core

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.parallel.FixedPool

/** The engines of this module. `Engines` alone is their factory; in Java [factory]. */
public class Engines private constructor() {
    public companion object : EngineFactory {
        private val makers = linkedMapOf<String, (threads: Int) -> CollisionEngine>(
            "horizon" to ::horizon,
            "islands" to { IslandsEngine(it) },
            "thread-pool" to { ThreadPoolEngine(it) },
            SERIAL to { SerialEngine() },
        )

        @JvmStatic
        override val names: List<String> = makers.keys.toList()

        @JvmStatic
        override fun create(name: String, threads: Int): CollisionEngine? =
            makers[name]?.invoke(EngineFactory.threadsOrAll(threads))

        @JvmStatic
        override fun isSpecification(name: String): Boolean = name == SERIAL

        @JvmStatic
        override fun successor(name: String): String? =
            if (name == "bricks") "it is gone; take horizon, which gives the same bits and is quicker" else null

        /** The fastest on [threads] threads: what it does not look ahead in goes by islands where there are several. */
        @JvmStatic
        public fun horizon(threads: Int): HorizonEngine {
            val pool = FixedPool(threads)
            return HorizonEngine(pool, other = if (threads == 1) null else IslandsEngine(pool))
        }

        /** The factory itself, for Java. */
        @JvmStatic
        public fun factory(): EngineFactory = this

        private const val SERIAL = "serial"
    }
}
