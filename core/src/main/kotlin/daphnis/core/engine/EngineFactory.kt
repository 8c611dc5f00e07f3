package daphnis.core.engine

/** Makes engines by name. */
public fun interface EngineFactory {
    /** @return null when the name is not known here */
    public fun create(name: String, threads: Int): CollisionEngine?
}
