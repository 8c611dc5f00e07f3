package daphnis.core.engine.islands

import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.engine.islands.IslandField.Companion.FREE
import daphnis.core.engine.islands.IslandField.Companion.OWNER
import daphnis.core.engine.islands.IslandField.Companion.TICKET

/** Makes the seeds of a window from one worker's [hints], and groups them into islands. */
internal class Seeder(private val field: IslandField, private val hints: Hints) {
    /** Roots of the islands that [group] found first. */
    var roots = IntArray(INITIAL)
        private set
    var rootCount = 0
        private set

    /** The own seeds that concern spheres which the rule did not allow. */
    var borderFrom = 0
        private set
    var borderTo = 0
        private set

    private var seedsFrom = 0
    private var seedsTo = 0

    /**
     * Makes seeds of the own hints of slices [from] to [to] that still hold, and puts whoever shares one into one
     * island.
     */
    fun propose(from: Int, to: Int, rule: ClaimRule?) {
        rootCount = 0
        var count = 0
        for (slice in from..to) count += hints.count(slice)
        val seeds = field.seeds
        seedsFrom = seeds.reserve(count)
        borderTo = seedsFrom + count
        borderFrom = borderTo
        var own = seedsFrom
        for (slice in from..to) {
            var hint = hints.head(slice)
            while (hint != FREE) {
                val first = hints.first(hint)
                val second = hints.second(hint)
                val image = hints.image(hint)
                val time = hints.time(hint)
                if (time == timeOf(first, second, image)) {
                    val isOwn = rule == null || (rule.mayClaim(first) && (second < 0 || rule.mayClaim(second)))
                    val s = if (isOwn) own++ else --borderFrom
                    seeds.time[s] = time
                    seeds.first[s] = first
                    seeds.second[s] = second
                    seeds.image[s] = image
                    if (isOwn && second >= 0) field.union(first, second)
                }
                hint = hints.next(hint)
            }
        }
        seedsTo = own
    }

    private fun timeOf(first: Int, second: Int, image: Int): Double = if (second < 0) {
        field.prepared.walls.time(field.rows, first, WallContact.face(second))
    } else {
        contactTime(field.rows, first, second, image, field.grid.images)
    }

    /** Hangs the own seeds into the lists of their islands. */
    fun group() {
        val seeds = field.seeds
        val ticket = field.ticket
        for (s in seedsFrom until seedsTo) {
            val root = field.find(seeds.first[s])
            ticket[seeds.first[s] * TICKET + OWNER] = root
            if (seeds.second[s] >= 0) ticket[seeds.second[s] * TICKET + OWNER] = root
            if (field.hang(s, root)) {
                if (rootCount == roots.size) roots = roots.copyOf(rootCount * 2)
                roots[rootCount++] = root
            }
        }
        // In the order of memory, so that islands one after the other find their neighbourhoods in the cache.
        roots.sort(0, rootCount)
    }

    private companion object {
        const val INITIAL = 256
    }
}
