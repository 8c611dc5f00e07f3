package daphnis.core.engine

import daphnis.core.parallel.Cores

/** Makes engines by name. */
public interface EngineFactory {
    /** The names known here, the one to recommend first. */
    public val names: List<String>

    /**
     * @param threads 0 for one per core, see [Cores]
     * @return null when the name is not known here
     */
    public fun create(name: String, threads: Int): CollisionEngine?

    /**
     * Whether [name] is that of the engine which is the specification of all others. It works on one thread, whatever
     * is asked of [create].
     */
    public fun isSpecification(name: String): Boolean = false

    /** What to take for the engine that earlier versions called [name], in words; null when there was none. */
    public fun successor(name: String): String? = null

    public companion object {
        /** [threads], or one per core when that is 0, see [Cores]. */
        @JvmStatic
        public fun threadsOrAll(threads: Int): Int = if (threads == 0) {
            Cores.ofJob
        } else {
            threads
        }
    }
}

/** Looks a name up in one factory after the other. */
public class CombinedEngines(private vararg val factories: EngineFactory) : EngineFactory {
    override val names: List<String> = factories.flatMap { it.names }

    override fun create(name: String, threads: Int): CollisionEngine? = factories.firstNotNullOfOrNull {
        it.create(name, threads)
    }

    override fun isSpecification(name: String): Boolean = factories.any { it.isSpecification(name) }

    override fun successor(name: String): String? = factories.firstNotNullOfOrNull { it.successor(name) }
}
