package daphnis.core.engine.islands

import daphnis.core.growth.IntList
import daphnis.core.queue.EventStore.Companion.NONE
import daphnis.core.wall.WallContact

/** Makes the seeds of a window from one worker's [hints], and groups them into islands. */
internal class Seeder(private val field: IslandField, private val hints: Hints) {
    private val board = field.board

    /** Roots of the islands that [group] found first. */
    val roots = IntList()

    /** The own seeds that concern spheres which the rule did not allow. */
    var borderFrom = 0
        private set
    var borderTo = 0
        private set

    private var seedsFrom = 0
    private var seedsTo = 0

    /**
     * Makes seeds of the own hints of slices [from] to [to] that still hold, and puts the spheres of each into one
     * island. Seeds of spheres which [rule] does not allow are set aside.
     */
    fun propose(from: Int, to: Int, rule: ClaimRule?) {
        roots.clear()
        var count = 0
        for (slice in from..to) count += hints.count(slice)
        seedsFrom = board.seeds.reserve(count)
        seedsTo = seedsFrom
        borderTo = seedsFrom + count
        borderFrom = borderTo
        for (slice in from..to) {
            var hint = hints.head(slice)
            while (hint != NONE) {
                if (holds(hint)) seed(hint, rule)
                hint = hints.store.link(hint)
            }
        }
    }

    /** Whether the contact time of [hint] is the same to the bit, so that neither sphere has changed. */
    private fun holds(hint: Int): Boolean {
        val first = hints.store.first(hint)
        val second = hints.store.second(hint)
        val time = if (second < 0) {
            field.prepared.walls.time(field.rows, first, WallContact.number(second))
        } else {
            field.prepared.meetingTime(field.rows, first, field.rows, second, hints.store.image(hint))
        }
        return time == hints.store.time(hint)
    }

    private fun seed(hint: Int, rule: ClaimRule?) {
        val store = hints.store
        val first = store.first(hint)
        val second = store.second(hint)
        val isOwn = rule == null || (rule.mayClaim(first) && (second < 0 || rule.mayClaim(second)))
        val s = if (isOwn) seedsTo++ else --borderFrom
        board.seeds.store.put(s, store.time(hint), first, second, store.image(hint))
        if (isOwn && second >= 0) board.union(first, second)
    }

    /** Hangs the own seeds into the lists of their islands. */
    fun group() {
        for (s in seedsFrom until seedsTo) {
            val root = board.find(board.seeds.store.first(s))
            board.own(s, root)
            if (board.hang(s, root)) roots.add(root)
        }
        // In the order of memory, so that consecutive islands find their neighbourhoods in the cache.
        roots.sort()
    }
}
