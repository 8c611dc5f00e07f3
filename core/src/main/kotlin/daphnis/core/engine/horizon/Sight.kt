package daphnis.core.engine.horizon

/**
 * Which lines a search sees. While groups process their collisions side by side, a group sees its own spheres as they
 * are, and all others as they were when the step began, since only their own group may write what they do now.
 */
internal class Sight(val now: Lines, private val before: Lines, private val shares: Shares) {
    /** The group that looks; [ALL] for one thread that does everything. */
    var group = ALL
        private set
    private var first = 0
    private var end = Int.MAX_VALUE

    /** Whether a search has met spheres of other groups since this was last set. */
    var hasMetOthers = false

    /** Only [group] sees what it does from now on. */
    fun narrow(group: Int) {
        this.group = group
        first = shares.firstOf(group)
        end = shares.endOf(group)
    }

    /** All is seen. */
    fun widen() {
        group = ALL
        first = 0
        end = Int.MAX_VALUE
    }

    fun owns(slot: Int): Boolean = group == ALL || shares.ownerOf(slot) == group

    /** The lines among which that of [slot] is seen. */
    fun of(slot: Int): Lines = if (owns(slot)) now else before

    /** Calls [use] for the parts of the run of members from [from] until [to], each with the lines that are seen. */
    inline fun forEachPart(from: Int, to: Int, use: (lines: Lines, from: Int, to: Int) -> Unit) {
        if (hasAll(from, to)) {
            use(now, from, to)
        } else {
            hasMetOthers = true
            forEachForeignPart(from, to, use)
        }
    }

    fun hasAll(from: Int, to: Int): Boolean = from >= first && to <= end

    inline fun forEachForeignPart(from: Int, to: Int, use: (lines: Lines, from: Int, to: Int) -> Unit) {
        val a = lower(from, to)
        val b = upper(a, to)
        if (from < a) use(others(), from, a)
        if (a < b) use(now, a, b)
        if (b < to) use(others(), b, to)
    }

    fun lower(from: Int, to: Int): Int = minOf(maxOf(first, from), to)

    fun upper(from: Int, to: Int): Int = maxOf(minOf(end, to), from)

    fun others(): Lines = before

    companion object {
        const val ALL = -1
    }
}
