package daphnis.core.engine.horizon

import daphnis.core.collision.NEVER
import daphnis.core.growth.GrowingTable

/**
 * The lines along which the spheres of a group have flown in the present step: for each sphere that has collided the
 * line before and those after, one **piece** each, which follow one another. They lie in a coarse grid, so that another
 * group's spheres find those which come near.
 *
 * @param group the number of the group
 */
internal class Trails(private val frame: EpochFrame, private val cells: EpochCells, val group: Int) :
    GrowingTable() {
    /** Lines by piece. They are in the box at the middle of the epoch. */
    val lines = Lines(frame)
    private val grid = Roamers(frame, lines)
    private val looks = ArrayList<RoamerLook?>()

    /** By piece: the sphere, and the times of the epoch from which and until which the piece counts. */
    var slots = IntArray(0)
        private set
    var from = DoubleArray(0)
        private set
    var until = DoubleArray(0)
        private set

    /** By piece: whether it follows a collision, and whether spheres of other groups may come near it. */
    private var isNew = BooleanArray(0)
    private var isOpen = BooleanArray(0)

    override fun resize(room: Int) {
        lines.grow(room)
        slots = slots.copyOf(room)
        from = from.copyOf(room)
        until = until.copyOf(room)
        isNew = isNew.copyOf(room)
        isOpen = isOpen.copyOf(room)
    }

    /**
     * The sphere in [slot] follows its line in [now] from time [start] on.
     *
     * @param isNew whether it has collided then
     * @return the piece
     */
    fun add(slot: Int, now: Lines, start: Double, isNew: Boolean): Int {
        val k = append()
        lines.copy(k, now, slot)
        lines.moveBack(k, cells.imageInBox(lines, k))
        slots[k] = slot
        from[k] = start
        until[k] = NEVER
        this.isNew[k] = isNew
        isOpen[k] = false
        return k
    }

    /** [piece] ends at [time]. */
    fun end(piece: Int, time: Double) {
        until[piece] = time
    }

    /** Others may come near [piece]. */
    fun open(piece: Int) {
        isOpen[piece] = true
    }

    fun isOpen(piece: Int): Boolean = isOpen[piece]

    /** Whether [piece] is the line along which its sphere goes on after the step. */
    fun isLast(piece: Int): Boolean = until[piece] == NEVER

    /** Whether [piece] follows a collision. */
    fun isNew(piece: Int): Boolean = isNew[piece]

    /** Puts all pieces into the grid, after which others may look for them; they fill one of [groups] parts of it. */
    fun sort(groups: Int) {
        grid.begin(minOf(size.toLong() * groups * ROOM, MOST_SPHERES).toInt(), cells.speeds.fastest, frame.memberRadius)
        for (piece in 0 until size) grid.add(piece)
    }

    /** Calls [use] for the pieces of [others], and their images, that may come near [piece]. */
    inline fun forEachNear(piece: Int, others: Trails, use: (other: Int, image: Int) -> Unit) {
        val look = lookAt(others)
        look.forEachNear(lines, piece, from[piece]) { e, image -> use(others.pieceAt(e), image) }
    }

    fun lookAt(others: Trails): RoamerLook {
        while (looks.size <= others.group) looks.add(null)
        return looks[others.group] ?: RoamerLook(frame, others.grid).also { looks[others.group] = it }
    }

    fun pieceAt(entry: Int): Int = grid.slotOf(entry)

    private companion object {
        /** Pieces for which the grid has room, for each that there is: cells with few are looked through quickly. */
        const val ROOM = 4
        const val MOST_SPHERES = 1L shl 24
    }
}
