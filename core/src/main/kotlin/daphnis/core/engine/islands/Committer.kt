package daphnis.core.engine.islands

import daphnis.core.collision.CollisionRecord

/**
 * Makes the results of one worker's islands part of the step, once no two islands touch.
 *
 * @param number the number of the worker
 */
internal class Committer(private val field: IslandField, private val number: Int, private val stores: WorkerStores) {
    /** Collisions of committed islands, in no order. */
    val record = CollisionRecord()

    /** Copies the results of the islands that are alive into the state. */
    fun commit() {
        val members = stores.members
        val attempts = stores.attempts
        for (index in 0 until attempts.size) {
            if (!attempts.isAlive(index)) continue
            for (k in attempts.firstRow(index) until attempts.endOfRows(index)) {
                field.rows.put(members.slot(k), members.rows, k)
                field.board.release(members.slot(k), number)
            }
            record.addAll(stores.tried, attempts.firstRecord(index), attempts.endOfRecord(index))
        }
    }

    /**
     * After all have committed: finds what suspects may do to one another later, each pair searched from the time at
     * which the other was not yet known.
     */
    fun hintSuspects() {
        val suspects = stores.suspects
        for (k in 0 until suspects.size) {
            if (!stores.attempts.isAlive(suspects.attempt(k))) continue
            val slot = suspects.slot(k)
            val other = suspects.other(k)
            val t = field.prepared.meetingTime(field.rows, slot, field.rows, other, suspects.image(k))
            if (t > field.windowEnd && t <= field.prepared.duration) stores.hints.add(t, slot, other, suspects.image(k))
        }
    }
}
