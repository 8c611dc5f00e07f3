package daphnis.core.collision

/**
 * What an engine has counted since the start of the run. The first eight numbers belong to the trajectory and are the
 * same for every engine. The rest tell how the engine worked.
 */
public class CollisionCounters {
    private val counts = LongArray(Counter.entries.size)

    /** Collisions between two spheres. */
    public var collisions: Long
        get() = counts[0]
        set(value) {
            counts[0] = value
        }

    /** Reflections at walls. */
    public var wallCollisions: Long
        get() = counts[1]
        set(value) {
            counts[1] = value
        }

    /** Collisions that the collapse guard made elastic. */
    public var guardActivations: Long
        get() = counts[2]
        set(value) {
            counts[2] = value
        }

    /** Passages and reflections of two spheres at an edge of their interaction. */
    public var edgeEvents: Long
        get() = counts[3]
        set(value) {
            counts[3] = value
        }

    /** Collisions in which two spheres merged, so that there is one less. */
    public var mergers: Long
        get() = counts[4]
        set(value) {
            counts[4] = value
        }

    /** Spheres that broke into pieces. */
    public var broken: Long
        get() = counts[5]
        set(value) {
            counts[5] = value
        }

    /** Pairs of unlike spheres that were drawn to swap their places. */
    public var swapAttempts: Long
        get() = counts[6]
        set(value) {
            counts[6] = value
        }

    /** Those that had room to. */
    public var swaps: Long
        get() = counts[7]
        set(value) {
            counts[7] = value
        }

    /** Steps restored and redone because a sphere went farther than the bound on its reach. */
    public var redoneSteps: Long
        get() = counts[8]
        set(value) {
            counts[8] = value
        }

    /**
     * Steps decided by the serial engine, because a parallel one could not finish its own attempt. Either it noticed a
     * violation of the time order, or its guess led to a collapse, to a step that would be refused, to too much work or
     * memory, or to an exception from the laws of the collision. A step that the serial engine cannot finish either
     * throws, and is not counted.
     */
    public var causalityReplays: Long
        get() = counts[9]
        set(value) {
            counts[9] = value
        }

    internal operator fun get(counter: Counter): Long = counts[counter.ordinal]

    internal operator fun set(counter: Counter, count: Long) {
        counts[counter.ordinal] = count
    }

    /** Adds what [other] counts. */
    internal fun add(other: CollisionCounters) {
        for (k in counts.indices) counts[k] += other.counts[k]
    }

    /** Adds what [parts] of a population, each computed by itself, have counted in a step. */
    internal fun addParts(parts: List<CollisionCounters>) {
        for (counter in Counter.entries) {
            this[counter] += if (counter.isOfTrajectory) parts.sumOf { it[counter] } else parts.maxOf { it[counter] }
        }
    }

    /** What was counted since these were [before]. */
    internal fun since(before: CollisionCounters): CollisionCounters = CollisionCounters().also {
        for (k in counts.indices) it.counts[k] = counts[k] - before.counts[k]
    }

    internal fun clear(): Unit = counts.fill(0)

    /** Takes over all that [other] counts. */
    internal fun set(other: CollisionCounters) {
        other.counts.copyInto(counts)
    }
}

/**
 * The numbers of [CollisionCounters] in their order.
 *
 * @property key in checkpoints
 * @property isNew whether checkpoints of older versions lack it
 * @property isOfTrajectory whether every engine counts the same; of parts of a population, the counts add up. What all
 *   parts do together is counted by each
 */
internal enum class Counter(val key: String, val isOfTrajectory: Boolean, val isNew: Boolean = false) {
    COLLISIONS("collisions", true),
    WALL_COLLISIONS("wallCollisions", true),
    GUARD_ACTIVATIONS("guardActivations", true),
    EDGE_EVENTS("edgeEvents", true, isNew = true),
    MERGERS("mergers", true, isNew = true),
    BROKEN("broken", true, isNew = true),
    SWAP_ATTEMPTS("swapAttempts", true, isNew = true),
    SWAPS("swaps", true, isNew = true),
    REDONE_STEPS("redoneSteps", false),
    CAUSALITY_REPLAYS("causalityReplays", false),
}
