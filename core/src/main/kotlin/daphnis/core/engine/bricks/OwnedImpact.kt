package daphnis.core.engine.bricks

import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.queue.Schedule
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * The impacts in one brick. It counts and records those collisions of which it owns the sphere with the lower id, so
 * that each is counted once, and hashes the paths of all its spheres.
 */
internal class OwnedImpact(prepared: PreparedStep, schedule: Schedule, private val brick: Brick) :
    Impact(prepared, prepared.rows, schedule) {
    /** Impacts since [begin], those in the halo included. */
    private var impacts = 0L

    override fun begin(record: CollisionRecord?) {
        super.begin(record)
        impacts = 0
    }

    override fun isCounted(first: Int, second: Int): Boolean {
        val place = if (rows.id[first] <= rows.id[second]) first else second
        return rows.origin[place] < brick.own
    }

    override fun changed(first: Int, second: Int, time: Double) {
        // What happens in the halo is not counted, but must have an end too.
        prepared.limits.checkWork(++impacts)
        take(first, if (second < 0) second else rows.id[second], time)
        if (second >= 0) take(second, rows.id[first], time)
    }

    /** Takes the impact of the sphere at [place] on [partner] into the hash of its path. */
    private fun take(place: Int, partner: Int, time: Double) {
        val v = place * STRIDE + VX
        val k = rows.origin[place]
        var h = PathHash.mix(brick.paths[k], time)
        h = PathHash.mix(h, rows.state[v])
        h = PathHash.mix(h, rows.state[v + 1])
        h = PathHash.mix(h, rows.state[v + 2])
        h = PathHash.mix(h, partner.toLong() xor (rows.rank(place).toLong() shl Int.SIZE_BITS))
        if (brick.tracksLastCollision) h = PathHash.mix(h, rows.lastCollision[place])
        brick.paths[k] = h
    }
}
