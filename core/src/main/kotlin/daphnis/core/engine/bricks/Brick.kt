package daphnis.core.engine.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.storeFirst
import daphnis.core.population.PopulationColumns
import daphnis.core.queue.BucketEventQueue
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * Computes a step for the spheres of one territory and of its halo, with the serial engine's parts and in its order, in
 * memory of its own. See [BricksEngine] for why this gives the serial engine's bits. One thread at a time.
 */
internal class Brick {
    /** The spheres at the start of the step: the first [own] are the brick's, the rest its halo. */
    val columns = BrickColumns()
    var own = 0

    private val prepared = PreparedStep()
    private val queue = BucketEventQueue()
    private val impact = OwnedImpact(prepared, queue, this)

    /** Of each entry of [columns] the hash of its impacts. */
    var paths = LongArray(0)
        private set

    /** Collisions whose sphere with the lower id is the brick's. */
    val record = CollisionRecord()

    /** What was counted of those, and of impacts of its spheres on walls. */
    val counted: CollisionCounters get() = impact.counted

    /** How often the last [solve] had to begin again because a sphere went beyond the bound. */
    var outrun = 0
        private set

    /** How far a sphere could go along x, y, z. */
    val bound: DoubleArray get() = prepared.reach.bound

    val tracksLastCollision: Boolean get() = prepared.step.law.guard.needsLastCollision

    /**
     * Computes the step of [whole], which has been measured, for [columns], which lie about [middle]. Ends early, with
     * no result, when [halt] says so.
     *
     * @throws RuntimeException whatever the laws of the collision throw, or a refusal; it may come from a wrong guess
     *   of what happens at the outer end of the halo
     */
    fun solve(whole: PreparedStep, middle: DoubleArray, halt: Halt) {
        prepared.takePart(whole, columns, middle)
        if (paths.size < columns.size) paths = LongArray(columns.size + columns.size / 4)
        outrun = 0
        while (!attempt(halt)) outrun++
    }

    /** @return false when a sphere went beyond the bound, which is now larger */
    private fun attempt(halt: Halt): Boolean {
        prepared.prepare()
        val rows = prepared.rows
        paths.fill(PathHash.STRAIGHT, 0, rows.size)
        queue.reset(prepared.duration, rows.id, rows.size)
        impact.begin(if (prepared.step.record == null) null else record)
        impact.candidates.start(0, rows.size, queue)
        while (!halt.isRequested && queue.pop()) {
            val end = impact.process(queue.time, queue.first, queue.second, queue.image)
            if (end == Impact.End.DONE) continue
            prepared.enlarge(rows, queue.first, queue.second)
            return false
        }
        return true
    }

    /** The hash of the whole path of entry [k] of [columns]. */
    fun wholePath(k: Int): Long = PathHash.whole(paths[k], columns, k, tracksLastCollision)

    /** Writes the brick's spheres, at the end of the step, to entries [at] and following of [columns]. */
    fun store(columns: PopulationColumns, at: Int) {
        val written = prepared.rows.storeFirst(own, columns, at, prepared.duration)
        check(written == own) { "a brick of $own spheres has written $written" }
    }

    /** Lets [whole] begin the next step with the headroom that the brick needed in this. */
    fun teach(whole: PreparedStep) {
        whole.reach.learn(prepared.reach)
    }
}

/** Tells the bricks of a step that their work is not needed any more. */
internal class Halt {
    @Volatile
    var isRequested = false
}
