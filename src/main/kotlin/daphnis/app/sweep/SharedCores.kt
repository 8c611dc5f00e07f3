package daphnis.app.sweep

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineFactory

/** The engines of [all], of which one that is asked for all threads of the machine gets its share of [threads]. */
internal class SharedCores(private val all: EngineFactory, private val threads: Int) : EngineFactory {
    override val names: List<String> get() = all.names

    override fun create(name: String, threads: Int): CollisionEngine? =
        all.create(name, if (threads == 0) this.threads else threads)

    override fun isSpecification(name: String): Boolean = all.isSpecification(name)
}
