package daphnis.core.engine

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop

/** What computes the steps of a simulation: a [CollisionEngine], or nodes that hold its spheres. */
public interface Workforce : AutoCloseable {
    /** The name by which it is chosen. */
    public val name: String

    /** The number of threads that work. */
    public val threads: Int

    /**
     * Runs loops over the spheres that are in this process, for the rest of a step. Must not be used while a step is
     * computed. Throws after [close].
     */
    public val loop: RangeLoop get() = InlineLoop
}

/** An engine that may know more of the spheres that it has just moved than whoever looks at their numbers. */
internal interface EndsFinite {
    /** Whether all numbers of the population are known to be finite at the end of the last step. */
    val endedFinite: Boolean
}
