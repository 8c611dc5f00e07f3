package daphnis.core.engine.lists

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.waitUntilRoot
import daphnis.core.engine.shares.GroupPaths
import daphnis.core.engine.shares.SlotPlaces
import daphnis.core.growth.GrowingTable
import daphnis.core.growth.IntList
import kotlin.math.max
import kotlin.math.min

/** Whether two spheres may touch, and if so, whether after the last collision of both. */
internal enum class Meeting { NONE, LAST, BEFORE }

/**
 * The paths of the spheres that have collided in the present window, as far as one region has followed them: who has
 * met whom ([GroupPaths]), and each sphere's pieces of path, one after each of its collisions.
 *
 * @param places the place of a sphere in [changed]; others of its kind that have other spheres can share it
 */
internal class ListPaths(private val field: ListField, private val places: SlotPlaces) {
    /** The spheres, by place. */
    val changed = IntList()
    val clusters = GroupPaths()

    /** Those of them that have spheres of other regions in their lists. */
    val atBorder = IntList()

    /** Rows after collisions, each with the number of the one before of the same sphere. */
    private class Pieces : GrowingTable() {
        var state = DoubleArray(0)
            private set
        var previous = IntArray(0)
            private set

        override fun resize(room: Int) {
            state = state.copyOf(room * STRIDE)
            previous = previous.copyOf(room)
        }

        fun add(from: DoubleArray, slot: Int, previous: Int): Int {
            val k = append()
            from.copyInto(state, k * STRIDE, slot * STRIDE, (slot + 1) * STRIDE)
            this.previous[k] = previous
            return k
        }
    }

    private val pieces = Pieces()

    /** Forgets all. */
    fun begin() {
        for (k in 0 until changed.size) places.forget(changed[k])
        changed.clear()
        atBorder.clear()
        clusters.begin()
        pieces.clear()
    }

    /** The spheres [first] and [second] have met; they are the same where one has met a wall. */
    fun met(first: Int, second: Int, counted: CollisionCounters) {
        val a = placeOf(first)
        val b = if (second == first) a else placeOf(second)
        clusters.met(a, b, counted)
        addPiece(first, a)
        if (b != a) addPiece(second, b)
    }

    /** Something has happened to the sphere in [slot], even if it has not met anybody. */
    fun note(slot: Int) {
        placeOf(slot)
    }

    private fun placeOf(slot: Int): Int {
        val place = places.of(slot)
        if (place != SlotPlaces.NONE) return place
        changed.add(slot)
        if (field.isAtBorder[slot]) atBorder.add(slot)
        places.put(slot, changed.size - 1)
        return changed.size - 1
    }

    private fun addPiece(slot: Int, place: Int) {
        clusters.setPiece(place, pieces.add(field.rows.state, slot, clusters.pieceOf(place)))
    }

    /** Whether the sphere in [slot] has collided here in this window, and that has not been dropped. */
    fun isLive(slot: Int): Boolean {
        val place = places.of(slot)
        return place != SlotPlaces.NONE && clusters.isLive(place)
    }

    /** Whether it has collided here in this window. */
    fun hasChanged(slot: Int): Boolean = places.of(slot) != SlotPlaces.NONE

    /**
     * Drops the cluster of the sphere in [slot], and calls [use] for each of its spheres, which may be followed anew.
     *
     * @param isFinal whether they are not known here any more
     */
    inline fun drop(slot: Int, isFinal: Boolean, use: (slot: Int) -> Unit) {
        clusters.drop(placeIn(slot)) {
            if (isFinal) forget(changed[it])
            use(changed[it])
        }
    }

    fun placeIn(slot: Int): Int = places.of(slot)

    fun forget(slot: Int) {
        places.forget(slot)
    }

    /** Adds what counts to [counters], and its entries of [from] to [record]. */
    fun addTo(counters: CollisionCounters, record: CollisionRecord?, from: CollisionRecord) {
        clusters.addTo(counters, record, from)
    }

    /**
     * How the sphere [i] and the sphere [j] of [others], at its image [code], may touch in the window from [start] to
     * [end], on the paths on which they were followed. The one to whom nothing has happened is where it was
     * [ListField.before].
     *
     * @param receding see [NextEvents.receding]
     */
    fun meet(i: Int, others: ListPaths, j: Int, code: Int, start: Double, end: Double, receding: Double): Meeting {
        val last = lastPiece(i)
        var result = Meeting.NONE
        var until = end
        var k = last
        while (true) {
            val from = if (k == NONE) start else max(start, pieces.state[k * STRIDE + TIME])
            val mine = if (k == NONE) field.before.state else pieces.state
            val p = (if (k == NONE) i else k) * STRIDE
            val met = others.meet(
                mine, p, field.before.state, j * STRIDE, code, from, until, start, receding, others.lastPiece(j),
                isLast = k == last,
            )
            if (met == Meeting.BEFORE) return met
            if (met == Meeting.LAST) result = met
            if (k == NONE) return result
            until = from
            k = pieces.previous[k]
        }
    }

    /** How many pieces there are. */
    val piecesSoFar: Int get() = pieces.size

    /** Whether the sphere in [slot] has pieces from number [mark] on. */
    fun hasPiecesFrom(mark: Int, slot: Int): Boolean = lastPiece(slot) >= mark

    /**
     * Whether the sphere [i], on its pieces from number [mark] on, may touch the sphere [j] of [others] before the last
     * of that one's collisions with numbers of pieces below [theirMark].
     *
     * @param first the path of [i] before these pieces, from time [from] on, at entry [p]; null where it is not asked for
     * @param theirs the path of [j] before its first piece, at entry [q]
     * @param start of the window
     */
    fun meetsBefore(
        i: Int,
        mark: Int,
        first: DoubleArray?,
        p: Int,
        from: Double,
        others: ListPaths,
        j: Int,
        theirMark: Int,
        theirs: DoubleArray,
        q: Int,
        code: Int,
        start: Double,
        receding: Double,
    ): Boolean {
        var last = others.lastPiece(j)
        while (last >= theirMark) last = others.pieces.previous[last]
        if (last == NONE) return false
        var until = others.pieces.state[last * STRIDE + TIME]
        var k = lastPiece(i)
        while (true) {
            val isNew = k >= mark && k != NONE
            val state = if (isNew) pieces.state else first ?: return false
            val at = if (isNew) k * STRIDE else p
            val begin = if (isNew) max(start, state[at + TIME]) else from
            if (begin <= until) {
                val met = others.meet(
                    state, at, theirs, q, code, begin, until, start, receding, last,
                    isLast = false,
                )
                if (met != Meeting.NONE) return true
                until = begin
            }
            if (!isNew) return false
            k = pieces.previous[k]
        }
    }

    private fun lastPiece(slot: Int): Int = if (hasChanged(slot)) clusters.pieceOf(places.of(slot)) else NONE

    /**
     * The same for one piece, at entry [p] of [theirs], that is followed from [from] until [until], and those until
     * [last], before which there is the path at entry [q] of [first].
     */
    private fun meet(
        theirs: DoubleArray,
        p: Int,
        first: DoubleArray,
        q: Int,
        code: Int,
        from: Double,
        until: Double,
        start: Double,
        receding: Double,
        last: Int,
        isLast: Boolean,
    ): Meeting {
        var end = Double.POSITIVE_INFINITY
        var result = Meeting.NONE
        var k = last
        while (true) {
            val mine = if (k == NONE) first else pieces.state
            val entry = if (k == NONE) q else k * STRIDE
            val begin = max(start, mine[entry + TIME])
            val a = max(begin, from)
            val b = min(end, until)
            if (a <= b && mayTouch(theirs, p, mine, entry, code, a, b, receding)) {
                if (!isLast || k != last) return Meeting.BEFORE
                result = Meeting.LAST
            }
            // What came before ended before the piece begins.
            if (k == NONE || begin < from) return result
            end = begin
            k = pieces.previous[k]
        }
    }

    private fun mayTouch(
        theirs: DoubleArray,
        p: Int,
        mine: DoubleArray,
        q: Int,
        code: Int,
        from: Double,
        until: Double,
        receding: Double,
    ): Boolean {
        val images = field.images
        val ux = mine[q + VX] - theirs[p + VX]
        val uy = mine[q + VX + 1] - theirs[p + VX + 1]
        val uz = mine[q + VX + 2] - theirs[p + VX + 2]
        val past = from - mine[q + TIME]
        val gone = from - theirs[p + TIME]
        val dx = (mine[q] + mine[q + VX] * past) - (theirs[p] + theirs[p + VX] * gone) + images.shift(code, 0)
        val dy =
            (mine[q + 1] + mine[q + VX + 1] * past) - (theirs[p + 1] + theirs[p + VX + 1] * gone) +
                images.shift(code, 1)
        val dz =
            (mine[q + 2] + mine[q + VX + 2] * past) - (theirs[p + 2] + theirs[p + VX + 2] * gone) +
                images.shift(code, 2)
        val s = mine[q + RADIUS] + theirs[p + RADIUS] + field.space.margin
        val b = dx * ux + dy * uy + dz * uz
        val c = dx * dx + dy * dy + dz * dz - s * s
        if (b >= receding) return false
        if (c <= 0.0) return true
        val discriminant = b * b - (ux * ux + uy * uy + uz * uz) * c
        if (discriminant < 0.0) return false
        return !(waitUntilRoot(b, c, discriminant) > (until - from) * (1 + ROUNDING))
    }

    private companion object {
        const val NONE = GroupPaths.NONE

        /** Of times; the margin has room for the rounding of places. */
        const val ROUNDING = 1e-9
    }
}
