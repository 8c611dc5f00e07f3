package daphnis.core.wall

import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.RecordSums

/**
 * Sums over the collisions with walls: the energy that walls gave, and from [IMPULSES] on their momentum by face, and
 * then by surface.
 */
internal class WallSums : RecordSums() {
    init {
        sum(IMPULSES + WallContact.FACES - 1)
    }

    override fun add(record: CollisionRecord) {
        for (k in 0 until record.size) {
            if (!record.isWall(k)) continue
            count++
            sum(WORK).add(-record.surfaceDissipation(k))
            sum(IMPULSES + WallContact.number(record.lower[k])).add(record.impulse(k))
        }
    }

    companion object {
        const val WORK = 0
        const val IMPULSES = 1
    }
}
