package daphnis.core.engine.bricks

import daphnis.core.engine.bricks.Cuts.Companion.AXES

/**
 * Finds out whether all bricks were right at once: the one thing in a step that needs to hear of all. A state machine
 * without threads: [begin] starts a step, [receive] takes a message and posts what follows from it.
 */
internal class Agreement(private val bricks: Int, private val margins: HaloMargins, private val post: Post) {
    private var key = NEVER
    private val answered = BooleanArray(bricks)
    private val wrong = BooleanArray(bricks)
    private val bound = DoubleArray(AXES)
    private var missing = 0

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
        val wider = widths.widened(wrong, bound, key.attempt, margins)
        val redo = Redo(key.next, wider, wrong.copyOf())
        begin(redo.key, wider)
        for (brick in 0 until bricks) post.send(brick, redo)
    }

    private companion object {
        val NEVER = AttemptKey(0, -1, 0)
    }
}
