package daphnis.core.cluster.bricks

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.storeWhere
import daphnis.core.population.PopulationColumns
import daphnis.core.queue.BucketEventQueue
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * Computes a step for the spheres of one territory and of its halo, in memory of its own: in an epoch of several steps
 * ([BrickAhead]) where that should be quicker, else with the serial engine's parts and in its order. See [BrickCrew]
 * for why this gives the serial engine's bits. One thread at a time.
 */
internal class Brick(ahead: BrickAhead.Choice = BrickAhead.Choice.QUICKEST) {
    /** The spheres at the start of the step. */
    val spheres = BrickSpheres()
    private val prepared = PreparedStep()
    private val queue = BucketEventQueue()
    private val paths = OwnPaths(prepared, spheres)
    private val impact = Impact(prepared, prepared.rows, queue, paths)

    /** Collisions whose sphere with the lower id is the brick's. */
    val record = CollisionRecord()
    private val ahead = BrickAhead(ahead, prepared, spheres, paths, record)

    /** Whether the present step was taken in an epoch. */
    private var isAhead = false

    /** What was counted of those, and of impacts of its spheres on walls. */
    val counted: CollisionCounters get() = if (isAhead) ahead.counted else impact.counted

    /** How often the last [solve] had to begin again because a sphere went beyond the bound. */
    var outrun = 0
        private set

    /** How far a sphere could go along x, y, z. */
    val bound: DoubleArray get() = prepared.farthest

    /** Steps that were taken in epochs, since the start. */
    val stepsAhead: Long get() = ahead.steps

    /**
     * Computes the step of [whole], which has been measured, for the spheres about [middle] that [gather] adds. Ends
     * early, with no result, when [halt] says so.
     *
     * @param isAgain whether the step has been computed before, with other spheres
     * @throws RuntimeException whatever the laws of the collision throw, or a refusal; it may come from a wrong guess
     *   of what happens at the outer end of the halo
     */
    fun solve(whole: PreparedStep, middle: DoubleArray, halt: Halt, isAgain: Boolean, gather: Gathering) {
        outrun = 0
        val mayLookAhead = !isAgain && whole.step.law.isPlain
        isAhead = mayLookAhead && ahead.solve(whole, middle, gather)
        if (isAhead) return
        ahead.drop()
        if (!mayLookAhead) gather.anew(spheres)
        prepared.takePart(whole, spheres, middle)
        while (!attempt(halt)) outrun++
        ahead.observe(counted)
    }

    /** @return false when a sphere went beyond the bound, which is now larger */
    private fun attempt(halt: Halt): Boolean {
        prepared.prepare()
        val rows = prepared.rows
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

    /** The hash of the whole path of the sphere at place [k]. */
    fun wholePath(k: Int): Long = paths.whole(k)

    /** Writes the brick's spheres, at the end of the step, to entries [at] and following of [columns]. */
    fun store(columns: PopulationColumns, at: Int) {
        val written = if (isAhead) {
            ahead.store(columns, at)
        } else {
            prepared.rows.storeWhere(columns, at, prepared.duration) { spheres.isOwn(it) }
        }
        check(written == spheres.own) { "a brick of ${spheres.own} spheres has written $written" }
    }

    /** Lets [whole] begin the next step with the headroom that the brick needed in this. */
    fun teach(whole: PreparedStep) {
        whole.reach.learn(prepared.reach)
    }
}

/** Adds the spheres of a brick in the present step. */
internal interface Gathering {
    /** Number of spheres. */
    val count: Int

    /** Adds all to [spheres]. */
    fun into(spheres: BrickSpheres)

    /** Has [spheres] forget those before, and adds all. */
    fun anew(spheres: BrickSpheres) {
        spheres.begin(count)
        into(spheres)
        spheres.settle()
    }
}

/** Tells the bricks of a step that their work is not needed any more. */
internal class Halt {
    @Volatile
    var isRequested = false
}
