package daphnis.core

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine

/** The engines of this module. */
public object Engines : EngineFactory {
    override val names: List<String> = listOf("islands", "thread-pool", "serial")

    override fun create(name: String, threads: Int): CollisionEngine? = when (name) {
        "serial" -> SerialEngine()
        "thread-pool" -> ThreadPoolEngine(EngineFactory.threadsOrAll(threads))
        "islands" -> IslandsEngine(EngineFactory.threadsOrAll(threads))
        else -> null
    }
}
