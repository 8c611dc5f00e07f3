package daphnis.core.engine.horizon

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import java.util.concurrent.atomic.AtomicLong

/**
 * The searches of an epoch that belong to no collision, shared by its threads: for all spheres when a window begins,
 * and for those that have left their lines.
 *
 * @param workers one for each worker of [loop], which files what its searches find
 */
internal class EpochSearches(
    private val space: EpochSpace,
    private val workers: List<CollisionGroup>,
    private val loop: RangeLoop,
) {
    private val frame = space.frame
    private val cells = space.cells
    private val lines = space.lines
    private val searches = workers.map { it.search }

    /** Which of the spheres off their lines are still in their cells. */
    private var hasCell = BooleanArray(0)

    /** Lines tested, and entries of roamers looked at, since the window began. */
    val tested: Long get() = searches.sumOf { it.tested }
    val listed: Long get() = searches.sumOf { it.listed }

    /** The work since the epoch began, in the nanoseconds of [EpochCost], and how much there may be now. */
    private val spent = AtomicLong()
    private var most = 0.0

    /** Begins an epoch. */
    fun begin() {
        spent.set(0)
    }

    /**
     * Has [worker] do [piece] of the searches, which is told how much its work may be in all, unless there has been
     * more of it than [EpochLimits] allow.
     */
    private inline fun search(worker: Int, piece: (search: LineSearch, most: Double) -> Unit) {
        if (space.limits.isExceeded) return
        val search = searches[worker]
        val before = search.work
        piece(search, before + most - spent.get())
        if (spent.addAndGet((search.work - before).toLong()) > most) space.limits.isExceeded = true
    }

    /** Searches for all, along their lines from the start of the window on. */
    fun all() {
        most = space.limits.ofSearches(frame.step)
        loop.run(searches[0].rows, ROWS_A_PIECE) { worker, from, to ->
            search(worker) { search, most -> search.aheadOfRows(from, to, most) }
        }
        for (slot in cells.members until space.spheres) space.addRoamer(slot, isFinal = true)
        loop.run(space.spheres - cells.members, SEARCHES_A_PIECE) { worker, from, to ->
            search(worker) { search, most ->
                for (k in from until to) if (search.work <= most) search.aheadOfRoamer(cells.members + k)
            }
        }
        if (!frame.hasWalls) return
        loop.run(space.spheres) { worker, from, to ->
            for (slot in from until to) workers[worker].lookAtWalls(slot, frame.start)
        }
    }

    /** Gives the spheres that [passage] found off their lines new ones, and searches along these. */
    fun changed(spheres: SphereColumns, passage: Passage, whole: CollisionGroup) {
        val t = frame.stepStart
        val count = passage.changed.size
        if (hasCell.size < count) hasCell = BooleanArray(2 * count)
        val version = whole.newLines.takeVersions(count)
        loop.run(count, LINES_A_PIECE) { _, from, to ->
            for (k in from until to) {
                val slot = passage.changed[k]
                val p = spheres
                lines.put(slot, p.x[slot], p.y[slot], p.z[slot], p.vx[slot], p.vy[slot], p.vz[slot], t)
                hasCell[k] = whole.newLines.settleInCell(slot, t, version + k)
                if (hasCell[k]) space.settleLine(slot)
            }
        }
        if (lines.isLost) return
        for (k in 0 until count) {
            if (hasCell[k]) continue
            whole.roam(passage.changed[k])
            space.settleLine(passage.changed[k])
        }
        most = space.limits.ofSearches(frame.step)
        loop.run(passage.changed.size, SEARCHES_A_PIECE) { worker, from, to ->
            search(worker) { search, most ->
                for (k in from until to) {
                    if (search.work > most) break
                    search.around(passage.changed[k], t, NOBODY)
                    if (frame.hasWalls) workers[worker].lookAtWalls(passage.changed[k], t)
                }
            }
        }
    }

    private companion object {
        const val NOBODY = -1

        /** Rows of cells that a worker takes at a time. */
        const val ROWS_A_PIECE = 16

        /** Spheres to which a worker gives new lines at a time. */
        const val LINES_A_PIECE = 256

        /** Spheres that a worker searches for at a time. */
        const val SEARCHES_A_PIECE = 64
    }
}
