package daphnis.core.engine.threadpool

import daphnis.core.queue.BucketEventQueue
import daphnis.core.queue.EventStore
import daphnis.core.step.StepLimits

/** The potential collision that a worker has taken. */
internal class Taken {
    var time = 0.0
    var first = -1
    var second = -1
    var image = 0

    /** Whether it was taken before its turn: while an earlier one was being processed, or after one was passed over. */
    var isEarly = false

    /** Whether another collision, at this time or later, had been taken before its turn. */
    var isLate = false
}

/**
 * The synchronised queue: hands out the next collision that is safe together with all that are being processed **and**
 * with every earlier one that was passed over because it was not safe. All fields are guarded by [lock].
 */
internal class SafeQueue(private val busy: BusyCells, private val limits: StepLimits) {
    private val lock = SpinLock()
    private val queue = BucketEventQueue()
    private var working = 0
    private var takenInStep = 0L

    /** Latest time of those that were taken early. */
    private var latestEarly = NONE_TAKEN
    private val passedOver = EventStore(MOST_PASSED_OVER)

    /** Counts changes that may have made a collision safe. */
    @Volatile
    private var changes = 0

    /** Set when all workers have to stop: the queue is empty and none works, or one has given up. */
    @Volatile
    var isOver = false
        private set

    fun reset(duration: Double, ids: IntArray, count: Int) {
        queue.reset(duration, ids, count)
        working = 0
        takenInStep = 0
        latestEarly = NONE_TAKEN
        isOver = false
    }

    /** Adds all of [found]; only while no worker works. */
    fun addAll(found: EventStore) {
        for (k in 0 until found.size) queue.add(found.time(k), found.first(k), found.second(k), found.image(k))
    }

    fun stop() {
        isOver = true
    }

    /**
     * Takes the next safe collision into [taken], waiting while there is none; false when it is over.
     *
     * @throws IllegalArgumentException when there have been too many
     */
    fun take(taken: Taken): Boolean {
        var spins = 0
        while (!isOver) {
            val seen = changes
            if (tryTake(taken)) return true
            while (seen == changes && !isOver) SpinLock.relax(spins++)
        }
        return false
    }

    /**
     * Takes the next safe collision into [taken]; false when there is none now.
     *
     * @throws IllegalArgumentException when there have been too many
     */
    fun tryTake(taken: Taken): Boolean = lock.use { takeLocked(taken) }

    /** Returns [taken], which has been processed and led to [found]. */
    fun finish(taken: Taken, found: EventStore) {
        lock.use {
            queue.removeAllOf(taken.first)
            if (taken.second >= 0) queue.removeAllOf(taken.second)
            addAll(found)
            busy.remove(taken.first, taken.second)
            working--
            changes++
        }
    }

    private fun takeLocked(taken: Taken): Boolean {
        if (isOver) return false
        val isTaken = passOverTo(taken)
        // Whether any that is busy now comes before it, being processed or passed over.
        if (isTaken) taken.isEarly = busy.hasBefore(taken.time)
        for (k in 0 until passedOver.size) busy.remove(passedOver.first(k), passedOver.second(k))
        addAll(passedOver)
        if (!isTaken) {
            if (working == 0 && passedOver.size == 0) isOver = true
            return false
        }
        limits.checkWork(++takenInStep)
        taken.isLate = taken.time <= latestEarly
        if (taken.isEarly) latestEarly = maxOf(latestEarly, taken.time)
        busy.add(taken.first, taken.second, taken.time)
        working++
        return true
    }

    /** Copies the first safe collision of the queue to [taken]; those before it are [passedOver] and busy. */
    private fun passOverTo(taken: Taken): Boolean {
        passedOver.clear()
        while (passedOver.size < MOST_PASSED_OVER && queue.pop()) {
            if (busy.areFree(queue.first, queue.second, queue.time)) {
                taken.time = queue.time
                taken.first = queue.first
                taken.second = queue.second
                taken.image = queue.image
                return true
            }
            // Nothing near it may be taken before it.
            busy.add(queue.first, queue.second, queue.time)
            passedOver.add(queue.time, queue.first, queue.second, queue.image)
        }
        return false
    }

    private companion object {
        const val NONE_TAKEN = -1.0

        /** How many unsafe collisions a worker passes over before it waits instead. */
        const val MOST_PASSED_OVER = 16
    }
}
