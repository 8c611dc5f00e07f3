package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * Processes collisions of the spheres of one group, or of all, in order of time: the two spheres of a collision get new
 * lines, and what they can touch is found along these. Pairs that come near in a later step are filed in [calendar].
 *
 * @param number the number of the group, by which versions of lines differ from those of others
 * @param numbers how many groups there are
 */
internal class CollisionGroup(
    prepared: PreparedStep,
    private val space: EpochSpace,
    private val calendar: PairCalendar,
    places: SlotPlaces,
    source: RowSource,
    number: Int,
    numbers: Int,
    witness: Impact.Witness?,
) : EpochImpact.Course,
    LineSearch.Found {
    /** Says which spheres other groups have changed, so that this one leaves them alone. */
    interface Others {
        fun haveChanged(slot: Int): Boolean

        /** A sphere flies along [piece] now. */
        fun meet(piece: Int)
    }

    private val frame = space.frame
    private val lines = space.lines
    private val cells = space.cells

    /** Spheres that have become roamers in this step, of which only this group knows yet. */
    val newRoamers = Roamers(frame, lines)
    val sight = Sight(lines, space.before, space.shares)
    val newLines = NewLines(space, sight, newRoamers, number, numbers)
    val search = LineSearch(frame, cells, space.roamers, space.giants, newRoamers, sight, this)
    val work = GroupWork(search, space.limits)
    val held = GroupSpheres(places, source)
    val impact = EpochImpact(prepared, held, this, witness)
    val pairs = DuePairs(prepared, space, calendar, held, sight, work)
    val trails = Trails(frame, cells, number)
    val paths = GroupPaths()

    /** Collisions of the step, where they are wanted. */
    val record = CollisionRecord()

    /** Pairs of a sphere of this group and one of another that may touch in this step. */
    val crossings = PairList()

    /** Null when there are none. */
    var others: Others? = null

    /** Whether paths are kept, so that a part of the work can be dropped. */
    private var keepsPaths = false

    /** Whether collisions are under way: pairs that are due are asked at once. */
    private var isUnderWay = false

    /** Whether an exception ended the work. */
    var hasFailed = false
        private set

    /** Pieces of other groups that were compared with pieces of this one, in this step. */
    var compared = 0L
        private set

    /** Begins an epoch, in which [filter] dismisses lines. */
    fun beginEpoch(filter: LineFilter) {
        newLines.begin()
        newRoamers.begin(space.spheres / ROOM_FOR_ROAMERS, cells.speeds.fastest, frame.memberRadius)
        search.begin(filter)
        rest()
    }

    /** Searches from now on belong to no collision. */
    fun rest() {
        isUnderWay = false
        others = null
        sight.widen()
    }

    /** Begins a step, or a window of it without the rows before. */
    fun begin(tracks: Boolean, keepsPaths: Boolean) {
        this.keepsPaths = keepsPaths
        hasFailed = false
        compared = 0
        held.begin(frame.duration, frame.start, frame.stepLimit, tracks)
        pairs.giants.begin(areCut = keepsPaths)
        crossings.clear()
        if (newRoamers.size > 0) {
            newRoamers.begin(space.spheres / ROOM_FOR_ROAMERS, cells.speeds.fastest, frame.memberRadius)
        }
        if (!keepsPaths) return
        trails.clear()
        paths.begin()
    }

    /** Collisions begin; they are written to [record]. */
    fun open(record: CollisionRecord?) {
        isUnderWay = true
        impact.begin(record)
    }

    /** Collisions go on in another window of the step, with the rows that there are. */
    fun goOn() {
        isUnderWay = true
        held.goOn(frame.start, frame.end)
        pairs.giants.begin(areCut = false)
    }

    /** Processes all that is queued. @return false when the step cannot be ended in this way */
    fun process(): Boolean {
        val queue = held.queue
        while (true) {
            val hasNext = queue.pop()
            // Pairs with giants that have waited until now may collide before what is next; then that is put back.
            if (pairs.giants.askUntil(if (hasNext) queue.time else frame.stepLimit)) {
                if (hasNext) queue.add(queue.time, queue.first, queue.second, queue.image)
                continue
            }
            if (!hasNext) return true
            if (impact.process(queue.time, queue.first, queue.second, queue.image) != Impact.End.DONE) return false
        }
    }

    /** The same for one group of several: a law that throws ends it, too. */
    fun processApart(begin: () -> Unit): Boolean = try {
        begin()
        process()
    } catch (e: Throwable) {
        // What a law threw at a collision that may never come. Memory that ends is no matter of the guess.
        if (e is VirtualMachineError && e !is StackOverflowError) throw e
        hasFailed = true
        false
    }

    override fun pair(slot: Int, other: Int, code: Int, from: Double) {
        if (others?.haveChanged(other) == true || space.isAway(other)) return
        val seen = sight.of(other)
        val touch = lines.touch(slot, seen, other, code, from)
        if (touch > frame.end) return
        val due = frame.stepAt(touch)
        if (due > frame.step || !isUnderWay) {
            if (due < frame.steps) pairs.file(maxOf(due, frame.step), slot, other, code)
        } else if (seen === lines) {
            pairs.ask(slot, other, code)
        } else {
            crossings.add(slot, other, code)
        }
    }

    /** See [DuePairs.ask] and [DuePairs.lookAtWalls]. */
    fun ask(i: Int, j: Int, code: Int): Unit = pairs.ask(i, j, code)

    fun lookAtWalls(slot: Int, from: Double): Unit = pairs.lookAtWalls(slot, from, isUnderWay)

    /**
     * Finds the pieces of [other]'s spheres that [piece] of this group's may touch: calls [use] for those within the
     * present step, and files the others.
     *
     * @param alsoOld whether pieces that follow no collision are asked for
     * @param isTwice whether open pieces of the other group look for this one's, and file as well
     */
    inline fun meet(piece: Int, other: CollisionGroup, alsoOld: Boolean, isTwice: Boolean, use: (Int) -> Unit) {
        trails.forEachNear(piece, other.trails) { q, code ->
            countCompared()
            if ((alsoOld || other.trails.isNew(q)) && other.held.has(other.trails.slots[q])) {
                val touch = touch(piece, other.trails, q, code)
                if (touch <= frame.end) {
                    if (frame.stepAt(touch) <= frame.step) {
                        use(q)
                    } else if (!(isTwice && other.trails.isOpen(q))) {
                        fileLater(touch, piece, other.trails, q, code)
                    }
                }
            }
        }
    }

    fun countCompared() {
        compared++
        work.compared++
    }

    /** A moment before which [piece] cannot touch piece [q] of [theirs], while both count; NEVER when they cannot. */
    fun touch(piece: Int, theirs: Trails, q: Int, code: Int): Double {
        val from = maxOf(trails.from[piece], theirs.from[q])
        val touch = trails.lines.touch(piece, theirs.lines, q, code, from)
        val until = minOf(trails.until[piece], theirs.until[q])
        return if (touch <= until + frame.duration * SLACK) touch else NEVER
    }

    /** Files the spheres of two pieces; that holds if these are the last of the step. */
    fun fileLater(touch: Double, piece: Int, theirs: Trails, q: Int, code: Int) {
        val due = frame.stepAt(touch)
        if (due >= frame.steps) return
        val i = trails.slots[piece]
        val j = theirs.slots[q]
        val image = trails.lines.spheresImage(code, piece, theirs.lines, q)
        calendar.file(due, i, j, lines.linesImage(image, i, lines, j), lines.version[i], lines.version[j])
    }

    override fun met(first: Int, second: Int) {
        work.impacts++
        pairs.giants.forget()
        if (keepsPaths) paths.met(first, second, impact.counted, record.size)
    }

    override fun bend(slot: Int, place: Int) {
        val state = held.rows.state
        val p = place * StepRows.STRIDE
        val v = p + StepRows.VX
        val t = frame.step * frame.duration + state[p + StepRows.TIME]
        if (pairs.giants.keeps(slot, p, t)) return
        if (keepsPaths) {
            val old = paths.pieceOf(place)
            val last = if (old != GroupPaths.NONE) old else trails.add(slot, lines, frame.windowStart, isNew = false)
            trails.end(last, t)
        }
        lines.put(slot, state[p], state[p + 1], state[p + 2], state[v], state[v + 1], state[v + 2], t)
        val isMember = settle(slot, t)
        if (!keepsPaths) return
        val piece = trails.add(slot, lines, t, isNew = true)
        paths.setPiece(place, piece)
        // Others do not look for roamers in their cells.
        if (!isMember) trails.open(piece)
    }

    /** The line in [slot] is new from time [from] on. @return whether its cell holds it */
    private fun settle(slot: Int, from: Double): Boolean {
        if (newLines.settleInCell(slot, from, newLines.takeVersions(1))) return true
        roam(slot)
        return false
    }

    /** The sphere in [slot], whose line is new, has left its cell. */
    fun roam(slot: Int) {
        newLines.roam(slot, isFinal = !keepsPaths)
    }

    override fun lookOut(slot: Int, place: Int, except: Int): Boolean {
        if (lines.isLost || work.isTooMuch()) return false
        if (pairs.giants.hasKept(slot)) {
            pairs.giants.askAgain(slot, except)
            return true
        }
        val local = held.rows.state[place * StepRows.STRIDE + StepRows.TIME]
        sight.hasMetOthers = false
        // Whoever has kept its line has not looked for this one.
        search.around(slot, frame.stepStart + local, if (pairs.giants.hasKept(except)) SteadyGiants.NOBODY else except)
        if (frame.hasWalls) lookAtWalls(slot, frame.stepStart + local)
        if (keepsPaths) {
            val piece = paths.pieceOf(place)
            if (sight.hasMetOthers) trails.open(piece)
            others?.meet(piece)
        }
        return true
    }

    private companion object {
        /** The grid of new roamers has room for one of so many spheres: cells with few are looked through quickly. */
        const val ROOM_FOR_ROAMERS = 32

        /** For the rounding of times, as a part of a step. */
        const val SLACK = 1e-6
    }
}
