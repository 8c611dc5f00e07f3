package daphnis.core.cluster.bricks

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.population.SphereQuantity
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * Follows the paths of the [spheres] of a brick through the step that is [prepared]: hashes of all, see [PathHash]. Of
 * collisions, those count of which the brick owns the sphere with the lower id, so that each is counted once.
 */
internal class OwnPaths(private val prepared: PreparedStep, private val spheres: BrickSpheres) : Impact.Witness {
    /** Impacts in this attempt, those in the halo included. */
    private var impacts = 0L

    /** Of each of [spheres] the hash of its impacts. */
    private var hashes = LongArray(0)

    private val tracksLastCollision: Boolean get() = prepared.step.law.guard.needsLastCollision

    override fun begin() {
        impacts = 0
        if (hashes.size < spheres.size) hashes = LongArray(spheres.size + spheres.size / SPARE)
        hashes.fill(PathHash.STRAIGHT, 0, spheres.size)
    }

    override fun isCounted(rows: StepRows, first: Int, second: Int): Boolean {
        val place = if (rows.id[first] <= rows.id[second]) first else second
        return spheres.isOwn(rows.origin[place])
    }

    override fun changed(rows: StepRows, first: Int, second: Int, time: Double) {
        // What happens in the halo is not counted, but must have an end too.
        prepared.limits.checkWork(++impacts)
        take(rows, first, if (second < 0) second else rows.id[second], time)
        if (second >= 0) take(rows, second, rows.id[first], time)
    }

    /** Takes the impact of the sphere at [place] on [partner] into the hash of its path. */
    private fun take(rows: StepRows, place: Int, partner: Int, time: Double) {
        val v = place * STRIDE + VX
        val k = rows.origin[place]
        var h = PathHash.mix(hashes[k], time)
        h = PathHash.mix(h, rows.state[v])
        h = PathHash.mix(h, rows.state[v + 1])
        h = PathHash.mix(h, rows.state[v + 2])
        if (prepared.step.law.merging != null) h = PathHash.mix(h, rows.state[place * STRIDE + RADIUS])
        if (rows.hasSpin) for (side in SPINS) h = PathHash.mix(h, rows.side(side)[place])
        h = PathHash.mix(h, partner.toLong() xor (rows.rank(place).toLong() shl Int.SIZE_BITS))
        if (tracksLastCollision) h = PathHash.mix(h, rows.lastCollision[place])
        hashes[k] = h
    }

    /** The hash of the whole path of sphere [k]. */
    fun whole(k: Int): Long = PathHash.whole(hashes[k], spheres, k, tracksLastCollision)

    private companion object {
        val SPINS = SphereQuantity.SPIN.places.toList().toIntArray()

        /** One part in so many is room for more. */
        const val SPARE = 4
    }
}
