package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME

/**
 * A walk back along the path of a sphere within a window, piece by piece, from the newest to the oldest. Each piece is
 * straight, from [start] to [end]; its row, at [row] of [state], holds the place at its start.
 */
internal class PathWalk {
    var state = DoubleArray(0)
        private set
    var row = 0
        private set

    /** Time at which the piece ends. */
    var end = 0.0
        private set
    private var older = PathLog.NONE
    private var paths: PathLog? = null

    /** Time at which the piece begins. */
    val start: Double get() = state[row + TIME]

    /** Whether the sphere was on this piece when it came into its island, or when the window began. */
    val isOldest: Boolean get() = older == PathLog.NONE

    /** Begins with the piece on which the sphere at [place] of [members] is at [end], the end of the window. */
    fun begin(members: Members, place: Int, end: Double) {
        begin(members.rows, place, end)
        older = members.older(place)
        paths = members.paths
    }

    /** Begins with the only piece of the sphere in [slot] of [rows], which belongs to no island. */
    fun begin(rows: StepRows, slot: Int, end: Double) {
        state = rows.state
        row = slot * STRIDE
        this.end = end
        older = PathLog.NONE
        paths = null
    }

    /** Begins where [other] is. */
    fun begin(other: PathWalk) {
        state = other.state
        row = other.row
        end = other.end
        older = other.older
        paths = other.paths
    }

    /** Goes to the piece before this one, which must not be the oldest. */
    fun goBack() {
        end = start
        val log = paths!!
        state = log.rows()
        row = PathLog.offset(older)
        older = log.older(older)
    }
}
