package daphnis.actors.region

import daphnis.core.parallel.RangeBody

/** What a region does for a command. */
public enum class Phase {
    /** Do its share of a loop of a step that is taken in an epoch. */
    SHARE,

    /** Find the potential collisions of the step that its own spheres can have. */
    SEARCH,

    /** Make seeds of those in the window; those that cross a border are left to the coordinator. */
    PROPOSE,

    /** Process the islands that lie wholly inside. */
    WORK,

    /** Process the islands of a batch that cross borders; the region and those around it are locked for that. */
    GRANT,

    /** Compare the paths of spheres that came near those of other islands. */
    CHECK,

    /** Take over the results. */
    COMMIT,

    /** Find what spheres of different islands may do to one another in later windows. */
    LOOK_AHEAD,
}

/**
 * From the coordinator to region [region]. A region gets a command only after it has answered the last one, so a
 * mailbox for one command suffices.
 *
 * @property islands roots of the islands of a [Phase.GRANT], the batch; not changed after sending
 * @property locked by region: whether its spheres may be touched in a [Phase.GRANT]; not changed after sending
 */
public class RegionCommand internal constructor(
    public val region: Int,
    public val phase: Phase,
    public val islands: IntArray,
    public val locked: BooleanArray,
    internal val share: Share?,
) {
    @JvmOverloads
    public constructor(region: Int, phase: Phase, islands: IntArray = NOTHING, locked: BooleanArray = NONE) :
        this(region, phase, islands, locked, null)

    internal constructor(region: Int, share: Share) : this(region, Phase.SHARE, NOTHING, NONE, share)

    private companion object {
        val NOTHING = IntArray(0)
        val NONE = BooleanArray(0)
    }
}

/** A region's share of a loop: the indices [from] until [to]. */
internal class Share(private val loop: SharedLoop, private val from: Int, private val to: Int) {
    /** Runs it as [worker], unless nobody waits for it any more. */
    fun run(worker: Int) {
        check(!loop.isAbandoned) { "a share of a loop that nobody waits for" }
        if (from < to) loop.body.run(worker, from, to)
    }
}

/** A loop whose indices are shared among regions. */
internal class SharedLoop(val body: RangeBody) {
    /** Nobody waits for it any more: a share that has not begun must not begin. */
    @Volatile
    var isAbandoned = false
}

/**
 * From region [region] to the coordinator, one per command.
 *
 * @property border islands that the region could not process since they need a sphere of a region that is neither its
 *   own nor locked for it: alternately root and slot of that sphere
 * @property failure what the region threw, null when all went well
 */
public class RegionReply @JvmOverloads constructor(
    public val region: Int,
    public val phase: Phase,
    public val border: IntArray = NOTHING,
    public val failure: Throwable? = null,
) {
    private companion object {
        val NOTHING = IntArray(0)
    }
}
