package daphnis.core.source

/** Where spheres come or leave, at the end of each step; one of those that [Sources] has. */
public sealed class Source {
    /** The greatest radius of what may come; 0 where nothing does. */
    public open val largest: Double get() = 0.0

    /** Acts at the end of a step. On nodes each calls this, and all come to the same. */
    internal abstract fun act(step: SourceStep)
}
