package daphnis.core.engine

/** Makes engines by name. */
public fun interface EngineFactory {
    /** @return null when the name is not known here */
    public fun create(name: String, threads: Int): CollisionEngine?
}

/** The engines of this module. */
public object Engines : EngineFactory {
    public val names: List<String> = listOf("serial")

    override fun create(name: String, threads: Int): CollisionEngine? = if (name == "serial") SerialEngine() else null
}
