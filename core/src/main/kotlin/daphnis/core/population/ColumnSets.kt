package daphnis.core.population

/**
 * The two sets of columns of a population, which take turns: a step is written to the one that is not [now]. Within a
 * step that can be taken back, neither are those from before it written.
 */
internal class ColumnSets(now: PopulationColumns) {
    var now: PopulationColumns = now
        private set

    /** The second set, for the next step to be written to. */
    private var spare: PopulationColumns? = null

    /** Bodies of [spare] for a step that changes the order, while it has those of [now]. */
    private var spareFixed: FixedColumns? = null

    /** The columns at the start of the step under way, while it can be taken back. */
    private var before: PopulationColumns? = null

    /** Whether a step is under way that can be taken back. */
    val isInStep: Boolean get() = before != null

    /** See [Population.columnsToWrite]. */
    fun toWrite(count: Int, keepsOrder: Boolean, tracksLastCollision: Boolean): PopulationColumns {
        val columns = spare?.takeIf { it.size == count } ?: PopulationColumns(count, now)
        spare = null
        if (keepsOrder) {
            // Those of before may still be in a set that was written earlier in the step.
            if (columns.fixed !== now.fixed && columns.fixed !== before?.fixed) spareFixed = columns.fixed
            columns.fixed = now.fixed
        } else if (columns.fixed === now.fixed || columns.fixed === before?.fixed) {
            columns.fixed = spareFixed?.takeIf { it.size == count } ?: now.fixed.empty(count)
            spareFixed = null
        }
        if (count != now.size) {
            columns.ownNotes()
        } else if (tracksLastCollision) {
            columns.separateNotes(now)
            before?.let { columns.separateNotes(it) }
        } else {
            columns.shareNotes(now)
        }
        return columns
    }

    /** Takes back columns [toWrite] that are not written to any more and not taken. */
    fun giveBack(columns: PopulationColumns) {
        spare = columns
    }

    /** Makes [columns] the present ones. */
    fun take(columns: PopulationColumns) {
        if (now !== before) spare = now
        now = columns
    }

    /** Puts [columns] in place of the present ones, which are not used again but for taking a step back. */
    fun replace(columns: PopulationColumns) {
        now = columns
    }

    /** Ensures that [now] has columns of its own of what engines do not change, so that a step can and be taken back. */
    fun separateFixed() {
        if (now.fixed === before?.fixed) now.fixed = now.fixed.withOwnNumbers()
    }

    /** The present columns, and those before a step under way, are such with these [bonds] from now on. */
    fun bind(bonds: Array<IntArray>) {
        val bound = now.with(bonds)
        if (before === now) before = bound
        now = bound
        spare = null
    }

    /** Begins a step that can be taken back until [commit]. */
    fun begin() {
        before = now
    }

    fun commit() {
        val old = before
        if (old !== now) spare = old
        before = null
    }

    /** Goes back to the columns of [begin]. @return false when no step is under way */
    fun takeBack(): Boolean {
        now = before ?: return false
        // Not to be reused, since a late thread may still write to them.
        spare = null
        before = null
        return true
    }
}
