package daphnis.core.growth

/**
 * A table whose rows are appended one by one, in arrays that a subclass holds and that keep their length from step to
 * step. Nothing is allocated once they are long enough.
 *
 * **A failed allocation does no harm.** A step that runs out of memory is undone, and may be done again. So a table must
 * not think that it has room for what only some of its arrays have room for. [room] says how many rows all of them hold:
 * it is written in one place only, after [resize] has returned. Until then arrays may be longer than it, never shorter.
 */
public abstract class GrowingTable internal constructor() {
    /** Number of rows. */
    public var size: Int = 0
        protected set

    /** Rows for which every array has room. */
    internal var room = 0
        private set

    /** Gives every array room for so many rows, more than now, and keeps what it holds. */
    protected abstract fun resize(room: Int)

    /** Removes all rows. */
    public open fun clear() {
        size = 0
    }

    /** Appends a row, which is to be written, and returns its number. */
    protected fun append(): Int {
        if (size == room) ensure(size + 1)
        return size++
    }

    /** Makes room for so many [rows] in all, and for as many again as there are: for tables that grow row by row. */
    protected fun ensure(rows: Int) {
        if (rows > room) reserve(maxOf(rows, LEAST, room * 2))
    }

    /** Makes room for so many [rows] in all, and no more. */
    protected fun reserve(rows: Int) {
        if (rows <= room) return
        resize(rows)
        room = rows
    }

    private companion object {
        /** Rows for which there is room at first. */
        const val LEAST = 64
    }
}
