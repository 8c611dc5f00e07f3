package daphnis.actors.region

import daphnis.core.parallel.RangeBody

/** A loop whose indices are shared among regions. */
internal class SharedLoop(val body: RangeBody) {
    /** Nobody waits for it any more: a share that has not begun must not begin. */
    @Volatile
    var isAbandoned = false
}

/**
 * The only thing that a region is told: the indices [from] until [to] of [loop] are its share. It gets one only after
 * it has answered the last, so a mailbox for one suffices.
 */
internal class Share(private val loop: SharedLoop, private val from: Int, private val to: Int) {
    /** Works on it as [worker], unless nobody waits for it any more. */
    fun run(worker: Int) {
        check(!loop.isAbandoned) { "a share of a loop that nobody waits for" }
        if (from < to) loop.body.run(worker, from, to)
    }
}
