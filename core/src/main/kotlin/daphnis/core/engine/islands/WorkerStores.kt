package daphnis.core.engine.islands

import daphnis.core.collision.CollisionRecord

/** What one worker keeps for itself: hints for the step, and everything else for the present window. */
internal class WorkerStores {
    val hints = Hints()
    val attempts = Attempts()
    val suspects = Suspects()
    val members = Members()

    /** Collisions of all attempts, including the dropped ones. */
    val tried = CollisionRecord()

    /** For a new attempt at the step. */
    fun prepare(duration: Double, limits: IslandLimits) {
        hints.reset(duration, limits)
        clearWindow(limits)
    }

    fun clearWindow(limits: IslandLimits) {
        attempts.clear()
        suspects.clear()
        members.clear(limits)
        tried.clear()
    }
}
