package daphnis.core.cluster.bricks

import daphnis.core.cluster.bricks.Cuts.Companion.AXES

/**
 * Finds out whether all bricks were right at once: the one thing in a step that needs to hear of all. A state machine
 * without threads: [begin] starts a step, [receive] takes a message and posts what follows from it. Processes that have
 * some of the bricks each have an agreement of their own, which is told the same and so decides the same.
 *
 * After [GUESSES] attempts, or one after the first that ends with an exception, every brick computes all spheres.
 */
internal class Agreement(private val bricks: Int, private val margins: HaloMargins, private val post: Post) {
    private var key = NEVER
    private val answered = BooleanArray(bricks)
    private val wrong = BooleanArray(bricks)
    private val bound = DoubleArray(AXES)
    private var missing = 0
    private var anyFailed = false

    /** Whether the step ends with an exception in the serial engine's way, and so for all. */
    var hasFailed = false
        private set

    /** What all bricks have counted in the present attempt. */
    var counts = BrickCounts.NONE
        private set

    /** The widths of the present attempt. */
    lateinit var widths: HaloWidths
        private set

    /** Whether the step is agreed on. */
    var isDone = false
        private set

    /** How many attempts at this step have failed. */
    val redone: Int get() = key.attempt

    /** Waits for the answers to the attempt [key] with [widths]. */
    fun begin(key: AttemptKey, widths: HaloWidths) {
        this.key = key
        this.widths = widths
        isDone = false
        hasFailed = false
        anyFailed = false
        counts = BrickCounts.NONE
        missing = bricks
        answered.fill(false)
        wrong.fill(false)
        bound.fill(0.0)
    }

    /** Takes [message]; one that is late or comes twice changes nothing. */
    fun receive(message: BrickMessage) {
        if (message !is Agreed || message.key != key || answered[message.from]) return
        answered[message.from] = true
        wrong[message.from] = !message.isRight
        if (message.hasFailed) anyFailed = true
        counts += message.counts
        for (axis in 0 until AXES) bound[axis] = maxOf(bound[axis], message.bound[axis])
        if (--missing == 0) decide()
    }

    private fun decide() {
        if (wrong.none { it }) {
            isDone = true
            val go = Go(key)
            for (brick in 0 until bricks) post.send(brick, go)
            return
        }
        if (widths.isEverything) {
            hasFailed = true
            return
        }
        val wider = if (key.attempt + 1 >= GUESSES || anyFailed && key.attempt > 0) {
            wrong.fill(true)
            widths.everything()
        } else {
            widths.widened(wrong, bound, key.attempt, margins)
        }
        val redo = Redo(key.next, wider, wrong.copyOf())
        begin(redo.key, wider)
        for (brick in 0 until bricks) post.send(brick, redo)
    }

    private companion object {
        val NEVER = AttemptKey(0, -1, 0)

        /** Attempts at a step with halos of limited width. */
        const val GUESSES = 6
    }
}
