package daphnis.core.engine.horizon

/** What a group of an epoch has looked at, in the nanoseconds of [EpochCost], and whether that is too much. */
internal class GroupWork(private val search: LineSearch, private val limits: EpochLimits) {
    /** Pairs that were asked, and pieces of paths that were compared, since the start. */
    var asked = 0L
    var compared = 0L

    /** Collisions, and reflections at walls, since [start]. */
    var impacts = 0L
    private var before = 0.0
    private var most = 0.0

    /** In this epoch, or window, for what its searches have looked at. */
    val total: Double get() = search.work + EpochCost.COMPARISON * compared + EpochCost.PAIR * asked

    /**
     * What collisions look at is weighed from now on against how many there are: of all that is allowed beside these,
     * this group has one of so many [parts].
     */
    fun start(parts: Int) {
        impacts = 0
        before = total
        most = limits.ofStep / parts
    }

    /** Whether this has been more work than [limits] allow; then the step is to be taken in another way. */
    fun isTooMuch(): Boolean {
        if (total - before <= most + impacts * limits.ofCollision) return false
        limits.isExceeded = true
        return true
    }
}
